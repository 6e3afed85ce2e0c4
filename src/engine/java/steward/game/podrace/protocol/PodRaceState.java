package steward.game.podrace.protocol;

import steward.game.StateCodec;
import steward.game.podrace.PodRace;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.io.SerializedString;

/** The commands and states of the pod race, as a replay keeps them. */
final class PodRaceState implements StateCodec {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString TURNS_LEFT = new SerializedString("turnsLeft");
        static final SerializedString BODIES = new SerializedString("bodies");
    }

    private final PodRace race;
    private final PodRaceAnswer answer;
    private final PodJsonCache texts;

    /** @param texts shared with the frames of the same race */
    PodRaceState(PodRace race, PodJsonCache texts) {
        this.race = race;
        this.texts = texts;
        answer = new PodRaceAnswer(race.settings().podsPerPlayer(), race.settings().maximumThrust());
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeRawValue(texts.command(player));
    }

    @Override
    public boolean hasPartialCommand(int player) {
        return race.thrust(player * race.settings().podsPerPlayer()) != PodRace.NO_COMMAND;
    }

    @Override
    public void clearCommand(int player) {
        int first = player * race.settings().podsPerPlayer();
        for (int k = 0; k < race.settings().podsPerPlayer(); k++) {
            race.command(first + k, 0, 0, PodRace.NO_COMMAND);
        }
    }

    @Override
    public String readPartialCommand(JsonParser in, int player) {
        String wrong = answer.readArray(in, true);
        if (wrong == null) {
            answer.command(race, player, answer.given());
        }
        return wrong;
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        String wrong = answer.readArray(in, false);
        if (wrong == null) {
            answer.command(race, player, race.settings().podsPerPlayer());
        }
        return wrong;
    }

    @Override
    public int readPlainCommand(byte[] json, int from, int to, int player) {
        int behind = answer.readPlainPods(json, from, to);
        if (behind >= 0) {
            answer.command(race, player, race.settings().podsPerPlayer());
        }
        return behind;
    }

    @Override
    public void writeState(JsonGenerator out) {
        out.writeName(Name.BODIES);
        out.writeStartArray();
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            out.writeRawValue(texts.state(pod));
        }
        out.writeEndArray();
        out.writeName(Name.TURNS_LEFT);
        out.writeStartArray();
        for (int player = 0; player < race.players(); player++) {
            out.writeNumber(race.turnsLeft(player));
        }
        out.writeEndArray();
    }
}

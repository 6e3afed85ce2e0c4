package steward.replay.verify;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import steward.game.Game;
import steward.game.GameTypes;
import steward.game.JsonNumbers;
import steward.replay.InputHash;
import steward.replay.JsonLine;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.ReplayWriter;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * What came of playing a recorded match again and comparing every turn.
 *
 * @param turns      how many turns agreed
 * @param difference the first difference, or {@code null} if there is none
 * @param warning    where the file was cut off, or {@code null}
 */
public record Verification(int turns, Difference difference, String warning) {

    /** Whether everything that was recorded agrees. */
    public boolean verified() {
        return difference == null;
    }

    /**
     * Verifies a replay from its first turn to its end or cut.
     *
     * @param replay just opened
     * @throws ReplayException              if the file is damaged before its end
     * @throws steward.scene.json.SceneException if its scene cannot be played
     */
    public static Verification of(ReplayReader replay, GameTypes types) {
        if (replay.header() == null) {
            return new Verification(0, null, replay.warning());
        }
        Resimulation again = new Resimulation(replay.header(), types, replay.source());
        byte[] start = json(out -> ReplayWriter.writeOpening(out, again.game(), again.codec()));
        byte[] recorded = opening(replay);
        Difference difference = compare(0, recorded, start, replay.imported());
        difference = difference != null ? difference
            : compareHash(0, "headerHash", replay.headerLine(), replay.format());
        String[] faults = new String[again.game().players()];
        TurnCheck check = new TurnCheck(again, replay.format());
        int turns = 0;
        while (difference == null) {
            byte[] line = replay.nextLine();
            TurnCheck.Found found = line == null ? TurnCheck.Found.NOTHING : check.check(line);
            if (found == TurnCheck.Found.SAME) {
                turns++;
                replay.passed(turns);
                continue;
            }
            RecordedTurn turn = replay.turn(line);
            if (turn == null) {
                difference = replay.result() == null ? null
                    : compareResult(replay, again.game(), faults);
                break;
            }
            difference = found == TurnCheck.Found.PLAYED ? null : again.play(turn);
            difference = difference != null ? difference : compareTurn(check, turn, replay, again);
            turns += difference == null ? 1 : 0;
            for (int player = 0; player < faults.length; player++) {
                faults[player] = faults[player] == null ? turn.faults()[player] : faults[player];
            }
        }
        return new Verification(turns, difference, replay.warning());
    }

    private static byte[] opening(ReplayReader replay) {
        byte[] drawing = replay.drawing();
        byte[] start = replay.start();
        return json(out -> {
            out.writeName("drawing");
            out.writeRawValue(new String(drawing, StandardCharsets.UTF_8));
            out.writeName("start");
            out.writeRawValue(new String(start, StandardCharsets.UTF_8));
        });
    }

    /** Compares a turn that was played with all that its line says. */
    private static Difference compareTurn(TurnCheck check, RecordedTurn turn, ReplayReader replay,
                                          Resimulation again) {
        String inputHash = InputHash.of(replay.format(), turn.commands(), 0, turn.commands().length, turn.faults(),
            turn.messages(), turn.stderr());
        return inputHash.equals(turn.inputHash())
            ? compare(turn.number(), turn.outcome(),
                replay.imported() ? json(out -> ObservableOutcome.write(out, again.game(), again.codec()))
                    : outcome(check), replay.imported())
            : new Difference(turn.number(), "inputHash", turn.inputHash(),
                inputHash + " of what the players did and wrote");
    }

    private static byte[] outcome(TurnCheck check) {
        return Arrays.copyOf(check.outcome(), check.outcomeLength());
    }

    private static byte[] json(Consumer<JsonGenerator> fields) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(4096);
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            out.writeStartObject();
            fields.accept(out);
            out.writeEndObject();
        }
        return bytes.toByteArray();
    }

    /** Bytes decide nearly always; only where they differ are both read. */
    private static Difference compare(int turn, byte[] recorded, byte[] found, boolean observed) {
        if (Arrays.equals(recorded, found)) {
            return null;
        }
        return observed ? Difference.fromObserved(turn, recorded, found) : Difference.between(turn, recorded, found);
    }

    private static Difference compareResult(ReplayReader replay, Game game, String[] faults) {
        JsonLine result = replay.result();
        if (!game.isOver()) {
            return new Difference(game.turn(), "result", "an end of the match", "the match goes on");
        }
        if (result.integer("turns") != game.turn()) {
            return new Difference(game.turn(), "turns", Integer.toString(result.integer("turns")),
                Integer.toString(game.turn()));
        }
        if (!result.text("ending").equals(game.ending())) {
            return new Difference(game.turn(), "ending", result.text("ending"), game.ending());
        }
        byte[] standing = json(out -> ReplayWriter.writeStanding(out, game));
        byte[] recorded = json(out -> {
            out.writeName("standing");
            out.writeRawValue(new String(result.array("standing"), StandardCharsets.UTF_8));
        });
        Difference difference = compare(game.turn(), recorded, standing, replay.imported());
        difference = difference != null ? difference
            : comparePlayers(result, game.turn(), replay.header().names(), faults);
        return difference != null ? difference
            : compareHash(game.turn(), "resultHash", result, replay.format());
    }

    /** Nothing before the field was altered, not even what has no effect on the game. */
    private static Difference compareHash(int turn, String field, JsonLine line, int format) {
        String recorded = line.text(field);
        String found = line.hashBefore(field, format);
        return recorded.equals(found) ? null
            : new Difference(turn, field, recorded, found + " of the line as it stands");
    }

    /** Names and faults of the result are those of the header and the turns. */
    private static Difference comparePlayers(JsonLine result, int turn, List<String> names, String[] faults) {
        String[] recordedNames = result.textsOf("players", "name");
        String[] recordedFaults = result.textsOf("players", "fault");
        if (recordedNames.length != names.size()) {
            return new Difference(turn, "players", recordedNames.length + " entries", names.size() + " entries");
        }
        for (int player = 0; player < faults.length; player++) {
            String field = "players[" + player + "].";
            if (!names.get(player).equals(recordedNames[player])) {
                return new Difference(turn, field + "name", String.valueOf(recordedNames[player]), names.get(player));
            }
            if (!Objects.equals(faults[player], recordedFaults[player])) {
                return new Difference(turn, field + "fault", recordedFaults[player] == null ? "nothing"
                    : recordedFaults[player], faults[player] == null ? "nothing" : faults[player]);
            }
        }
        return null;
    }
}

package steward.replay.verify;

import java.util.Arrays;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.JsonNumbers;
import steward.replay.InputHash;
import steward.replay.JsonLine;
import steward.replay.OutcomeJson;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Formats 1 and 2: what follows from the game is written again and compared, the rest is held by the hashes of header
 * and result, and by one of commands and texts in every turn.
 */
final class EarlierLineCheck implements LineCheck {

    private final ReplayReader replay;
    private final Resimulation again;
    private final LineBuffer outcome = new LineBuffer();
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), outcome);
    private final OutcomeJson json = new OutcomeJson();

    EarlierLineCheck(ReplayReader replay, Resimulation again) {
        this.replay = replay;
        this.again = again;
    }

    @Override
    public Difference header() {
        Difference difference = RecordedJson.compareOpening(replay, again);
        return difference != null ? difference
            : RecordedJson.compareHash(0, "headerHash", replay.headerLine(), replay.format());
    }

    @Override
    public boolean isSame(byte[] line) {
        return false;
    }

    @Override
    public Difference turn(byte[] line, RecordedTurn turn) {
        Difference difference = again.play(turn);
        if (difference != null) {
            return difference;
        }
        String inputHash = InputHash.of(replay.format(), turn.commands(), 0, turn.commands().length, turn.faults(),
            turn.messages(), turn.stderr());
        if (!inputHash.equals(turn.hash())) {
            return new Difference(turn.number(), "inputHash", turn.hash(),
                inputHash + " of what the players did and wrote");
        }
        outcome.reset();
        json.write(out, again.game(), again.codec());
        out.flush();
        byte[] written = Arrays.copyOf(outcome.bytes(), outcome.size());
        return RecordedJson.compare(turn.number(), turn.outcome(), written, replay.imported());
    }

    @Override
    public Difference result(String[] faults) {
        JsonLine result = replay.result();
        Game game = again.game();
        Difference difference = LineCheck.end(game, result.integer("turns"), result.text("ending"));
        difference = difference != null ? difference : RecordedJson.compareStanding(replay, game);
        difference = difference != null ? difference : LineCheck.players(game.turn(), replay.header().names(), faults,
            result.textsOf("players", "name"), result.textsOf("players", "fault"));
        return difference != null ? difference
            : RecordedJson.compareHash(game.turn(), "resultHash", result, replay.format());
    }
}

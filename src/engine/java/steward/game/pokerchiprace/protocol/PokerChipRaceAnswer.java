package steward.game.pokerchiprace.protocol;

import steward.game.pokerchiprace.ChipCommand;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.CommandsAnswer;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/**
 * JSON of a player's chip commands in answers and replays, read, checked and written: {@code chips}, an array in the
 * order of the player's list, each
 * <pre>{"x":1,"y":2}   {"wait":true}</pre>
 */
final class PokerChipRaceAnswer extends CommandsAnswer<ChipCommand> {

    private final PokerChipRace game;
    private boolean waits;

    private PokerChipRaceAnswer(PokerChipRace game, double farthest) {
        super("chips", farthest, "x", "y", "wait");
        this.game = game;
    }

    static PokerChipRaceAnswer ofBot(PokerChipRace game) {
        return new PokerChipRaceAnswer(game, FARTHEST);
    }

    static PokerChipRaceAnswer ofReplay(PokerChipRace game) {
        return new PokerChipRaceAnswer(game, Double.MAX_VALUE);
    }

    static void write(JsonGenerator out, ChipCommand command) {
        if (command.waits()) {
            out.writeBooleanProperty("wait", true);
        } else {
            JsonNumbers.write(out, "x", command.x());
            JsonNumbers.write(out, "y", command.y());
        }
    }

    @Override
    protected int count() {
        return game.table().owned(player);
    }

    @Override
    protected void beginCommand() {
        waits = false;
    }

    @Override
    protected String commandField(String field, JsonParser in) {
        String wrong = flag(field, in);
        if (wrong == null && waits) {
            return "wait: found twice, expected once";
        }
        waits = true;
        return wrong;
    }

    @Override
    protected String endCommand(int index) {
        String wrong = waits ? targetBeside("wait") : missingTarget();
        return wrong == null ? keep(index, waits ? ChipCommand.WAIT : new ChipCommand(x, y))
            : waits ? wrong : wrong + " (or wait alone)";
    }
}

package steward.game.pokerchiprace.protocol;

import steward.game.pokerchiprace.ChipCommand;
import steward.json.CommandsAnswer;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/**
 * The commands of a player's chips as JSON, in answers and replays: {@code chips}, an array in the order of the
 * player's list, each
 * <pre>{"x":1,"y":2}   {"wait":true}</pre>
 */
final class PokerChipRaceAnswer extends CommandsAnswer<ChipCommand> {

    private int chips;
    private boolean waits;

    private PokerChipRaceAnswer(double farthest) {
        super("chips", farthest, "x", "y", "wait");
    }

    static PokerChipRaceAnswer ofBot() {
        return new PokerChipRaceAnswer(FARTHEST);
    }

    static PokerChipRaceAnswer ofReplay() {
        return new PokerChipRaceAnswer(Double.MAX_VALUE);
    }

    /** Says how many commands the next answer must have. */
    PokerChipRaceAnswer expect(int number) {
        chips = number;
        return this;
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
        return chips;
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

package steward.game.pokerchiprace.protocol;

import steward.game.JsonAnswer;
import tools.jackson.core.JsonParser;

/** Reads one answer of a bot: the commands as {@link ChipCommandJson} and an optional message. */
final class ChipAnswer extends JsonAnswer {

    private final ChipCommandJson commands = new ChipCommandJson(ChipCommandJson.FARTHEST);
    private int chips;
    private boolean given;

    ChipAnswer() {
        super("chips");
    }

    /** How many commands the next answer must have. */
    ChipAnswer expect(int number) {
        chips = number;
        return this;
    }

    /** The commands of the last valid answer. */
    ChipCommandJson commands() {
        return commands;
    }

    @Override
    protected void begin() {
        given = false;
    }

    @Override
    protected String field(String name, JsonParser in) {
        if (given) {
            return "chips: found twice, expected once";
        }
        given = true;
        return commands.read(in, chips, false);
    }

    @Override
    protected String complete() {
        return given ? null : "chips: found nothing, expected an array of " + chips;
    }
}

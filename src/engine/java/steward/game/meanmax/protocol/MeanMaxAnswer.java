package steward.game.meanmax.protocol;

import steward.game.JsonAnswer;
import steward.game.meanmax.UnitKind;
import tools.jackson.core.JsonParser;

/** Reads one answer of a Mean Max bot: the commands as {@link LooterCommandJson} and an optional message. */
final class MeanMaxAnswer extends JsonAnswer {

    private final LooterCommandJson commands = new LooterCommandJson();
    private boolean given;

    MeanMaxAnswer() {
        super("looters");
    }

    /** The commands of the last valid answer. */
    LooterCommandJson commands() {
        return commands;
    }

    @Override
    protected void begin() {
        given = false;
    }

    @Override
    protected String field(String name, JsonParser in) {
        if (given) {
            return "looters: found twice, expected once";
        }
        given = true;
        return commands.read(in, false);
    }

    @Override
    protected String complete() {
        return given ? null : "looters: found nothing, expected an array of " + UnitKind.LOOTERS;
    }
}

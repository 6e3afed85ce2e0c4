package steward.game.meanmax.protocol;

import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.LooterCommand.Action;
import steward.game.meanmax.UnitKind;
import steward.json.CommandsAnswer;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/**
 * JSON of the commands of three looters in answers and replays, read, checked and written: {@code looters}, an array of
 * reaper, destroyer and doof, each
 * <pre>{"x":1,"y":2,"power":300}   {"x":1,"y":2,"skill":true}   {"wait":true}</pre>
 */
final class MeanMaxAnswer extends CommandsAnswer<LooterCommand> {

    private double power;
    private Action action;

    MeanMaxAnswer() {
        super("looters", FARTHEST, "x", "y", "power", "skill", "wait");
    }

    static void write(JsonGenerator out, LooterCommand command) {
        if (command.action() == Action.WAIT) {
            out.writeBooleanProperty("wait", true);
            return;
        }
        JsonNumbers.write(out, "x", command.x());
        JsonNumbers.write(out, "y", command.y());
        if (command.action() == Action.SKILL) {
            out.writeBooleanProperty("skill", true);
        } else {
            JsonNumbers.write(out, "power", command.power());
        }
    }

    @Override
    protected int count() {
        return UnitKind.LOOTERS;
    }

    @Override
    protected void beginCommand() {
        action = null;
    }

    @Override
    protected String commandField(String field, JsonParser in) {
        boolean moves = field.equals("power");
        if (moves) {
            power = number(in) + 0.0;
        }
        String wrong = !moves ? flag(field, in) : power >= 0 && power <= LooterCommand.MOST_POWER ? null
            : "power: found " + found(in) + ", expected a number 0.." + LooterCommand.MOST_POWER;
        if (wrong == null && action != null) {
            return field + ": found more than one of power, skill, wait, expected exactly one";
        }
        action = moves ? Action.MOVE : field.equals("skill") ? Action.SKILL : Action.WAIT;
        return wrong;
    }

    @Override
    protected String endCommand(int index) {
        if (action == null) {
            return ": found none of power, skill, wait, expected exactly one";
        }
        String wrong = action == Action.WAIT ? targetBeside("wait") : missingTarget();
        return wrong != null ? wrong : keep(index, switch (action) {
            case WAIT -> LooterCommand.WAIT;
            case SKILL -> LooterCommand.skill(x + 0.0, y + 0.0);
            case MOVE -> LooterCommand.move(x + 0.0, y + 0.0, power);
        });
    }
}

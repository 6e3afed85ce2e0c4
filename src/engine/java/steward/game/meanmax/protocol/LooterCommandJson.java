package steward.game.meanmax.protocol;

import java.util.Set;
import java.util.TreeSet;
import steward.game.JsonNumbers;
import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.LooterCommand.Action;
import steward.game.meanmax.UnitKind;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * The commands of a player's three looters as JSON, in answers and replays: an array of reaper, destroyer and doof,
 * each
 * <pre>{"x":1,"y":2,"power":300}   {"x":1,"y":2,"skill":true}   {"wait":true}</pre>
 * An error is returned as a sentence, because a wrong answer is frequent and not an exception.
 */
final class LooterCommandJson {

    /** The greatest coordinate of a target, in u. */
    private static final double FARTHEST = 1e9;
    private static final Set<String> FIELDS = new TreeSet<>(Set.of("x", "y", "power", "skill", "wait"));

    private final LooterCommand[] read = new LooterCommand[UnitKind.LOOTERS];

    private double x;
    private double y;
    private double power;
    private Action action;

    /** The command last read for a looter, or {@code null}. */
    LooterCommand command(int looter) {
        return read[looter];
    }

    static void write(JsonGenerator out, LooterCommand command) {
        if (command == null) {
            out.writeNull();
            return;
        }
        out.writeStartObject();
        if (command.action() == Action.WAIT) {
            out.writeBooleanProperty("wait", true);
        } else {
            JsonNumbers.write(out, "x", command.x());
            JsonNumbers.write(out, "y", command.y());
            if (command.action() == Action.SKILL) {
                out.writeBooleanProperty("skill", true);
            } else {
                JsonNumbers.write(out, "power", command.power());
            }
        }
        out.writeEndObject();
    }

    /**
     * Reads the array; the parser stands on its first token.
     *
     * @param partial whether it is what a faulty answer gave: the first commands, at least one, and then null
     * @return what is wrong, or {@code null}
     */
    String read(JsonParser in, boolean partial) {
        if (in.currentToken() != JsonToken.START_ARRAY) {
            return "looters: found " + describe(in) + ", expected an array of " + UnitKind.LOOTERS;
        }
        int count = 0;
        int given = 0;
        while (in.nextToken() != JsonToken.END_ARRAY) {
            if (count == UnitKind.LOOTERS) {
                return "looters: found more than " + UnitKind.LOOTERS + ", expected " + UnitKind.LOOTERS;
            }
            read[count] = null;
            if (partial && given > 0 && in.currentToken() == JsonToken.VALUE_NULL) {
                count++;
                continue;
            }
            String wrong = given < count ? path(count) + ": found " + describe(in) + ", expected null"
                : readOne(in, count);
            if (wrong != null) {
                return wrong;
            }
            given = ++count;
        }
        if (count != UnitKind.LOOTERS) {
            return "looters: found " + count + ", expected " + UnitKind.LOOTERS;
        }
        return partial && given == count ? "looters: found " + given + " commands, expected fewer" : null;
    }

    private String readOne(JsonParser in, int looter) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return path(looter) + ": found " + describe(in) + ", expected an object";
        }
        x = Double.NaN;
        y = Double.NaN;
        action = null;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong = readField(in, name);
            if (wrong != null) {
                return path(looter) + "." + wrong;
            }
        }
        if (action == null) {
            return path(looter) + ": found none of power, skill, wait, expected exactly one";
        }
        boolean aims = action != Action.WAIT;
        if (aims && (Double.isNaN(x) || Double.isNaN(y))) {
            return path(looter) + (Double.isNaN(x) ? ".x" : ".y") + ": found nothing, expected a number";
        }
        if (!aims && !(Double.isNaN(x) && Double.isNaN(y))) {
            return path(looter) + (Double.isNaN(x) ? ".y" : ".x") + ": found a number, expected nothing beside wait";
        }
        read[looter] = !aims ? LooterCommand.WAIT
            : action == Action.SKILL ? LooterCommand.skill(x, y) : LooterCommand.move(x, y, power);
        return null;
    }

    private String readField(JsonParser in, String name) {
        switch (name) {
            case "x", "y" -> {
                double before = name.equals("x") ? x : y;
                double value = in.currentToken().isNumeric() ? in.getDoubleValue() : Double.NaN;
                if (!(Math.abs(value) <= FARTHEST)) {
                    return name + ": found " + describe(in) + ", expected a number -1e9..1e9";
                }
                if (!Double.isNaN(before)) {
                    return name + ": found twice, expected once";
                }
                x = name.equals("x") ? value + 0.0 : x;
                y = name.equals("y") ? value + 0.0 : y;
                return null;
            }
            case "power" -> {
                power = in.currentToken().isNumeric() ? in.getDoubleValue() + 0.0 : Double.NaN;
                if (!(power >= 0 && power <= LooterCommand.MOST_POWER)) {
                    return "power: found " + describe(in) + ", expected a number 0.." + LooterCommand.MOST_POWER;
                }
                return act(name, Action.MOVE);
            }
            case "skill", "wait" -> {
                if (in.currentToken() != JsonToken.VALUE_TRUE) {
                    return name + ": found " + describe(in) + ", expected true (or leave it out)";
                }
                return act(name, name.equals("skill") ? Action.SKILL : Action.WAIT);
            }
            default -> {
                return TextFormat.beginning(name, 40) + ": unknown field, expected one of " + String.join(", ", FIELDS)
                    + NearestName.question(name, FIELDS, "");
            }
        }
    }

    private String act(String name, Action wanted) {
        if (action != null) {
            return name + ": found more than one of power, skill, wait, expected exactly one";
        }
        action = wanted;
        return null;
    }

    private static String path(int looter) {
        return "looters[" + looter + "]";
    }

    static String describe(JsonParser in) {
        JsonToken token = in.currentToken();
        if (token == null) {
            return "nothing";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "an array";
            case VALUE_STRING -> "\"" + TextFormat.beginning(in.getString(), 40) + "\"";
            default -> TextFormat.beginning(in.getString(), 40);
        };
    }
}

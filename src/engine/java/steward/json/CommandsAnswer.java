package steward.json;

import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * Reader of an array of commands, one object for each body of a player. The array is part of an answer, beside an
 * optional {@code message}, or of a replay. Commands may have a target {@code x}, {@code y}; the other fields are the
 * game's. A game's sentences about a command begin with {@code .field: } or {@code : }; the place of the command is put
 * before them.
 */
public abstract class CommandsAnswer<C> extends JsonAnswer {

    /** Greatest coordinate of a target in most answers, in u. */
    protected static final double FARTHEST = 1e9;
    private static final int SHOWN = 40;

    /** Target of the command that is being read, as it stands there; NaN for none. */
    protected double x;
    protected double y;

    /** The player whose commands are read. */
    protected int player;

    private final String name;
    private final double farthest;
    private final Set<String> fields;
    private Object[] commands = new Object[2];
    private int given;
    private boolean found;

    /**
     * @param name     of the array
     * @param farthest the greatest coordinate of a target, in u; {@code Double.MAX_VALUE} for any finite number
     */
    protected CommandsAnswer(String name, double farthest, String... fields) {
        super(name);
        this.name = name;
        this.farthest = farthest;
        this.fields = new TreeSet<>(Set.of(fields));
    }

    /** Says whose commands are read next: their number, and what is allowed, may depend on the player. @return this */
    public final CommandsAnswer<C> of(int whose) {
        player = whose;
        return this;
    }

    /** The number of commands that the array must have. */
    protected abstract int count();

    /** The number of commands, for an error. */
    protected String counted() {
        return Integer.toString(count());
    }

    /** Forgets the command before. */
    protected abstract void beginCommand();

    /** Reads a field of a command that is neither x nor y. @return what is wrong, or {@code null} */
    protected abstract String commandField(String field, JsonParser in);

    /**
     * Returns the error of a command, something missing or too much; {@code null} if right, and then {@linkplain #keep
     * kept}.
     */
    protected abstract String endCommand(int index);

    /** Keeps a command that is right. @return {@code null} */
    protected final String keep(int index, C command) {
        commands[index] = command;
        return null;
    }

    /** The command last read for a place in the array, or {@code null}. */
    @SuppressWarnings("unchecked")
    public final C command(int index) {
        return (C) commands[index];
    }

    /** Returns how many commands the last array had before the first {@code null}. */
    public final int given() {
        return given;
    }

    /**
     * Reads the array; the parser stands on its first token.
     *
     * @param partial whether it is what a faulty answer gave: the first commands, at least one, and then null
     * @return what is wrong, or {@code null}
     */
    public final String readArray(JsonParser in, boolean partial) {
        int expected = count();
        if (in.currentToken() != JsonToken.START_ARRAY) {
            return name + ": found " + found(in) + ", expected an array of " + counted();
        }
        if (commands.length < expected) {
            commands = Arrays.copyOf(commands, 2 * expected);
        }
        int index = 0;
        given = 0;
        while (in.nextToken() != JsonToken.END_ARRAY) {
            if (index == expected) {
                return name + ": found more than " + expected + ", expected " + counted();
            }
            commands[index] = null;
            if (partial && given > 0 && in.currentToken() == JsonToken.VALUE_NULL) {
                index++;
                continue;
            }
            String wrong = given < index ? ": found " + found(in) + ", expected null" : readCommand(in, index);
            if (wrong != null) {
                return name + "[" + index + "]" + wrong;
            }
            given = ++index;
        }
        if (index != expected) {
            return name + ": found " + index + ", expected " + counted();
        }
        return partial && given == index ? name + ": found " + given + " commands, expected fewer" : null;
    }

    private String readCommand(JsonParser in, int index) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return ": found " + found(in) + ", expected an object";
        }
        x = Double.NaN;
        y = Double.NaN;
        beginCommand();
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String field = in.currentName();
            in.nextToken();
            String wrong = !fields.contains(field) ? TextFormat.beginning(field, SHOWN)
                + ": unknown field, expected one of " + String.join(", ", fields)
                + NearestName.question(field, fields, "")
                : field.equals("x") || field.equals("y") ? readCoordinate(field, in) : commandField(field, in);
            if (wrong != null) {
                return "." + wrong;
            }
        }
        return endCommand(index);
    }

    private String readCoordinate(String field, JsonParser in) {
        boolean isX = field.equals("x");
        double value = number(in);
        if (!(Math.abs(value) <= farthest)) {
            return field + ": found " + found(in) + ", expected a "
                + (farthest == Double.MAX_VALUE ? "finite number" : "number -1e9..1e9");
        }
        if (!Double.isNaN(isX ? x : y)) {
            return field + ": found twice, expected once";
        }
        x = isX ? value : x;
        y = isX ? y : value;
        return null;
    }

    /** Returns the error of a command that needs a target, or {@code null}. */
    protected final String missingTarget() {
        return Double.isNaN(x) ? ".x: found nothing, expected a number"
            : Double.isNaN(y) ? ".y: found nothing, expected a number" : null;
    }

    /** Returns the error of a command that must have no target, or {@code null}. */
    protected final String targetBeside(String field) {
        return Double.isNaN(x) && Double.isNaN(y) ? null
            : (Double.isNaN(x) ? ".y" : ".x") + ": found a number, expected nothing beside " + field;
    }

    /** Returns the error of a flag, or {@code null}. */
    protected static String flag(String field, JsonParser in) {
        return in.currentToken() == JsonToken.VALUE_TRUE ? null
            : field + ": found " + found(in) + ", expected true (or leave it out)";
    }

    @Override
    protected final void begin() {
        found = false;
    }

    @Override
    protected final String field(String field, JsonParser in) {
        if (found) {
            return name + ": found twice, expected once";
        }
        found = true;
        return readArray(in, false);
    }

    @Override
    protected final String complete() {
        return found ? null : name + ": found nothing, expected an array of " + counted();
    }
}

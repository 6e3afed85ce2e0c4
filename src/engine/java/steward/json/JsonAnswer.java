package steward.json;

import java.util.Set;
import java.util.TreeSet;
import steward.scene.json.JsonProblem;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Reader of answers that are one object of a game's own fields and an optional {@code message}, token by token. An
 * error is returned as a sentence, because wrong answers are frequent and not exceptional: it names the field, what was
 * found and what was expected. A valid answer without a message allocates nothing.
 */
public abstract class JsonAnswer {

    private static final int SHOWN = 40;

    private final Set<String> known;
    private final LineParser lines = new LineParser();
    private String message;

    /** @param fields the names that are known, without {@code message} */
    protected JsonAnswer(String... fields) {
        known = new TreeSet<>(Set.of(fields));
        known.add("message");
    }

    /** Forgets the answer before. */
    protected abstract void begin();

    /**
     * Reads one of the fields; the parser stands on the first token of its value.
     *
     * @return what is wrong, or {@code null}
     */
    protected abstract String field(String name, JsonParser in);

    /** Returns the error once all fields are read, a field missing or too much, or {@code null}. */
    protected abstract String complete();

    /** The message of the last valid answer, or {@code null}. */
    public final String message() {
        return message;
    }

    /** Reads a line. @return {@code null} if it is a valid answer, otherwise what is wrong with it */
    public final String read(byte[] line, int length) {
        message = null;
        return isPlain(line, length) || isValid(line, length) ? null : readForError(line, length);
    }

    /** A faster way to read the answers that are usual; it may reject anything. */
    protected boolean isPlain(byte[] line, int length) {
        return false;
    }

    private boolean isValid(byte[] line, int length) {
        if (!LineParser.canRead(line, 0, length)) {
            return false;
        }
        try {
            JsonParser in = lines.begin(line, 0, length);
            if (in.nextToken() == JsonToken.START_OBJECT && readObject(in) == null) {
                lines.endValue();
                return lines.restIsBlank();
            }
            lines.reset();
            return false;
        } catch (JacksonException problem) {
            // The error and its position are found by reading the line once more.
            lines.reset();
            return false;
        }
    }

    private String readForError(byte[] line, int length) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), line, 0, length)) {
            if (in.nextToken() != JsonToken.START_OBJECT) {
                return "found " + found(in) + ", expected an object with " + String.join(", ", known);
            }
            String wrong = readObject(in);
            if (wrong != null) {
                return wrong;
            }
            return in.nextToken() == null ? null : "found more after the closing }, expected one object a line";
        } catch (JacksonException problem) {
            // The reader's own limits (digits of a number, length of a name) come without a position.
            String column = problem.getLocation() == null ? "" : ", column " + problem.getLocation().getColumnNr();
            return "not JSON" + column + ": " + JsonProblem.message(problem);
        }
    }

    /** Reads the fields of an object whose bracket is the current token. @return what is wrong, or {@code null} */
    public final String readObject(JsonParser in) {
        begin();
        message = null;
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return "found " + found(in) + ", expected an object";
        }
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong = name.equals("message") ? readMessage(in) : known.contains(name) ? field(name, in)
                : TextFormat.beginning(name, SHOWN) + ": unknown field, expected one of " + String.join(", ", known)
                    + NearestName.question(name, known, "");
            if (wrong != null) {
                return wrong;
            }
        }
        return complete();
    }

    private String readMessage(JsonParser in) {
        if (in.currentToken() != JsonToken.VALUE_STRING) {
            return "message: found " + found(in) + ", expected a string";
        }
        if (message != null) {
            return "message: found twice, expected once";
        }
        message = in.getString();
        return null;
    }

    /** A finite number, or NaN. */
    protected static double number(JsonParser in) {
        double value = in.currentToken().isNumeric() ? in.getDoubleValue() : Double.NaN;
        return Double.isFinite(value) ? value : Double.NaN;
    }

    /** True if a number is a whole one of a range; 100.0 is one too, since some languages print it so. */
    protected static boolean isWhole(double value, int least, int most) {
        return value == Math.rint(value) && value >= least && value <= most;
    }

    /** Describes the value found, for an error. */
    protected static String found(JsonParser in) {
        JsonToken token = in.currentToken();
        if (token == null) {
            return "nothing";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "an array";
            case VALUE_STRING -> "\"" + TextFormat.beginning(in.getString(), SHOWN) + "\"";
            default -> TextFormat.beginning(in.getString(), SHOWN);
        };
    }
}

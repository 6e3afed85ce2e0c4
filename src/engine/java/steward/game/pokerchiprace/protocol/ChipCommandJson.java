package steward.game.pokerchiprace.protocol;

import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import steward.game.JsonNumbers;
import steward.game.pokerchiprace.ChipCommand;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * The commands of a player's chips as JSON, in answers and replays: an array in the order of the player's list, each
 * <pre>{"x":1,"y":2}   {"wait":true}</pre>
 * An error is returned as a sentence, because a wrong answer is frequent and not an exception.
 */
final class ChipCommandJson {

    /** The greatest coordinate of a target in an answer, in u. */
    static final double FARTHEST = 1e9;
    private static final Set<String> FIELDS = new TreeSet<>(Set.of("x", "y", "wait"));

    private final double farthest;
    private ChipCommand[] read = new ChipCommand[8];
    private double x;
    private double y;
    private boolean waits;

    /** @param farthest the greatest coordinate of a target, in u */
    ChipCommandJson(double farthest) {
        this.farthest = farthest;
    }

    /** The command last read for the k-th chip, or {@code null}. */
    ChipCommand command(int k) {
        return read[k];
    }

    static void write(JsonGenerator out, ChipCommand command) {
        if (command == null) {
            out.writeNull();
            return;
        }
        out.writeStartObject();
        if (command.waits()) {
            out.writeBooleanProperty("wait", true);
        } else {
            JsonNumbers.write(out, "x", command.x());
            JsonNumbers.write(out, "y", command.y());
        }
        out.writeEndObject();
    }

    /**
     * Reads the array; the parser stands on its first token.
     *
     * @param chips   how many there must be
     * @param partial whether it is what a faulty answer gave: the first commands, at least one, and then null
     * @return what is wrong, or {@code null}
     */
    String read(JsonParser in, int chips, boolean partial) {
        if (in.currentToken() != JsonToken.START_ARRAY) {
            return "chips: found " + describe(in) + ", expected an array of " + chips;
        }
        if (read.length < chips) {
            read = Arrays.copyOf(read, 2 * chips);
        }
        int count = 0;
        int given = 0;
        while (in.nextToken() != JsonToken.END_ARRAY) {
            if (count == chips) {
                return "chips: found more than " + chips + ", expected " + chips;
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
        if (count != chips) {
            return "chips: found " + count + ", expected " + chips;
        }
        return partial && given == count ? "chips: found " + given + " commands, expected fewer" : null;
    }

    private String readOne(JsonParser in, int k) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return path(k) + ": found " + describe(in) + ", expected an object";
        }
        x = Double.NaN;
        y = Double.NaN;
        waits = false;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong = readField(in, name);
            if (wrong != null) {
                return path(k) + "." + wrong;
            }
        }
        if (waits) {
            if (!(Double.isNaN(x) && Double.isNaN(y))) {
                return path(k) + (Double.isNaN(x) ? ".y" : ".x") + ": found a number, expected nothing beside wait";
            }
            read[k] = ChipCommand.WAIT;
            return null;
        }
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return path(k) + (Double.isNaN(x) ? ".x" : ".y") + ": found nothing, expected a number (or wait alone)";
        }
        read[k] = new ChipCommand(x, y);
        return null;
    }

    private String readField(JsonParser in, String name) {
        switch (name) {
            case "x", "y" -> {
                boolean isX = name.equals("x");
                double value = in.currentToken().isNumeric() ? in.getDoubleValue() : Double.NaN;
                if (!(Math.abs(value) <= farthest)) {
                    return name + ": found " + describe(in) + ", expected a number"
                        + (farthest == FARTHEST ? " -1e9..1e9" : "");
                }
                if (!Double.isNaN(isX ? x : y)) {
                    return name + ": found twice, expected once";
                }
                x = isX ? value : x;
                y = isX ? y : value;
                return null;
            }
            case "wait" -> {
                if (in.currentToken() != JsonToken.VALUE_TRUE) {
                    return "wait: found " + describe(in) + ", expected true (or leave it out)";
                }
                if (waits) {
                    return "wait: found twice, expected once";
                }
                waits = true;
                return null;
            }
            default -> {
                return TextFormat.beginning(name, 40) + ": unknown field, expected one of " + String.join(", ", FIELDS)
                    + NearestName.question(name, FIELDS, "");
            }
        }
    }

    private static String path(int k) {
        return "chips[" + k + "]";
    }

    private static String describe(JsonParser in) {
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

package steward.game.meanmax.protocol;

import java.util.Set;
import java.util.TreeSet;
import steward.game.JsonNumbers;
import steward.scene.json.JsonProblem;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/** Reads one answer of a Mean Max bot: the commands as {@link LooterCommandJson} and an optional message. */
final class MeanMaxAnswer {

    private static final Set<String> FIELDS = new TreeSet<>(Set.of("looters", "message"));

    private final LooterCommandJson commands = new LooterCommandJson();
    private String message;

    /** The commands of the last valid answer. */
    LooterCommandJson commands() {
        return commands;
    }

    /** The message of the last valid answer, or {@code null}. */
    String message() {
        return message;
    }

    /** @return {@code null} if the line is a valid answer, otherwise what is wrong with it */
    String read(byte[] line, int length) {
        message = null;
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), line, 0, length)) {
            if (in.nextToken() != JsonToken.START_OBJECT) {
                return "found " + LooterCommandJson.describe(in) + ", expected an object {\"looters\":[...]}";
            }
            String wrong = readFields(in);
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

    private String readFields(JsonParser in) {
        boolean given = false;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong = switch (name) {
                case "looters" -> given ? "looters: found twice, expected once" : commands.read(in, false);
                case "message" -> readMessage(in);
                default -> TextFormat.beginning(name, 40) + ": unknown field, expected one of "
                    + String.join(", ", FIELDS) + NearestName.question(name, FIELDS, "");
            };
            if (wrong != null) {
                return wrong;
            }
            given |= name.equals("looters");
        }
        return given ? null : "looters: found nothing, expected an array of 3";
    }

    private String readMessage(JsonParser in) {
        if (in.currentToken() != JsonToken.VALUE_STRING) {
            return "message: found " + LooterCommandJson.describe(in) + ", expected a string";
        }
        if (message != null) {
            return "message: found twice, expected once";
        }
        message = in.getString();
        return null;
    }
}

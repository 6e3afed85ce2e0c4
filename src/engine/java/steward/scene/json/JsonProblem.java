package steward.scene.json;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonToken;

/** Messages about malformed JSON for the author of the file; the parser's own messages are for programmers. */
public final class JsonProblem {

    private static final String CUT = "found the end of the text within the JSON, expected all of it";
    private static final String VALUE = "expected a value: a text in double quotes, a number, an object, an array, "
        + "true, false or null";
    private static final String NUMBER = "found a number that is not finite, expected digits";
    private static final String ESCAPE = "expected one of \\\\\" \\\\\\\\ \\\\/ \\\\b \\\\f \\\\n \\\\r \\\\t or "
        + "\\\\u with four hexadecimal digits";
    private static final String BYTES = "found bytes that are not UTF-8, expected UTF-8";
    /** A character that the parser quotes, and its code. */
    private static final String CHARACTER = "Unexpected character \\((.+?) \\(code \\d+[^)]*\\)\\)";

    /**
     * A message of the parser, and what is said in its place.
     *
     * @param message what the parser's message begins with
     * @param words   with references to the groups of the message
     */
    private record Translation(Pattern message, String words) {

        static Translation of(String message, String words) {
            return new Translation(Pattern.compile(message, Pattern.DOTALL), words);
        }
    }

    /** The first one that fits is taken. */
    private static final List<Translation> TRANSLATIONS = List.of(
        Translation.of("Unexpected end-of-input", CUT),
        Translation.of(CHARACTER + ".*plus sign", "found a number with a plus sign, expected one without"),
        Translation.of(CHARACTER + ".*Decimal point", "found $1 after a decimal point, expected a digit"),
        Translation.of(CHARACTER + ".*Exponent", "found $1 in the exponent of a number, expected a digit"),
        Translation.of(CHARACTER + ".*minus sign", "found $1 after a minus sign, expected a digit"),
        Translation.of(CHARACTER + ".*comment", "found $1, perhaps a comment; JSON has none"),
        Translation.of(CHARACTER + ".*escape sequence", "found $1 after \\\\u, expected four hexadecimal digits"),
        Translation.of(CHARACTER + ".*comma to separate Object", "found $1, expected a comma or }"),
        Translation.of(CHARACTER + ".*comma", "found $1, expected a comma or ]"),
        Translation.of(CHARACTER + ".*double-quote", "found $1, expected the name of a field in double quotes"),
        Translation.of(CHARACTER + ".*colon", "found $1, expected a colon between a field's name and its value"),
        Translation.of("Unexpected character \\(.+?\\(code 65279.*", "found a byte order mark, expected none"),
        Translation.of(CHARACTER, "found $1, " + VALUE),
        Translation.of("Unexpected close marker ('.').*expected ('.')", "found $1, expected $2"),
        Translation.of("Unexpected close marker ('.')", "found $1, but nothing that it closes"),
        Translation.of("(?:Unrecognized|Non-standard) token '(?:[+-]?(?:INF|Infinity)|NaN)'", NUMBER),
        Translation.of("Unrecognized token '(.*?)'", "found $1, " + VALUE),
        Translation.of(".*[Ll]eading zero", "found a number that begins with a zero too many, expected none"),
        Translation.of("Illegal unquoted character", "found a control character or the end of the line within a text, "
            + "expected a closing double quote, or an escape such as \\\\n"),
        Translation.of("Illegal character", "found a control character, expected JSON"),
        Translation.of("Unrecognized character escape ('.*')", "found $1 after \\\\, " + ESCAPE),
        Translation.of("Invalid UTF-", BYTES),
        Translation.of("Invalid UTF|Unsupported UCS|Invalid character", BYTES),
        Translation.of("Document nesting depth \\((\\d+)\\).*?\\((\\d+)",
            "found objects and arrays $1 deep, expected at most $2"),
        Translation.of("Number value length \\((\\d+)\\).*?\\((\\d+)",
            "found a number of $1 characters, expected at most $2"),
        Translation.of("Name length \\((\\d+)\\).*?\\((\\d+)",
            "found a field's name of $1 characters, expected at most $2"),
        Translation.of("String value length \\((\\d+)\\).*?\\((\\d+)",
            "found a text of $1 characters, expected at most $2"),
        Translation.of("Numeric value \\((.*?)\\) out of range", "found the number $1, which is too large"),
        Translation.of("Invalid numeric value", "found a number that is not spelt as JSON spells them"));

    private JsonProblem() { }

    /** Returns the kind of value that begins at a token, such as {@code an object}. */
    public static String kind(JsonToken token) {
        if (token == null) {
            return "nothing";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "an array";
            case END_OBJECT, END_ARRAY -> "nothing";
            case PROPERTY_NAME -> "a field";
            case VALUE_STRING -> "a string";
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> "a number";
            case VALUE_TRUE -> "true";
            case VALUE_FALSE -> "false";
            case VALUE_NULL -> "null";
            default -> "something else";
        };
    }

    /** Returns what was found and what was expected, without a place. */
    public static String message(JacksonException problem) {
        String message = problem.getOriginalMessage();
        for (Translation translation : TRANSLATIONS) {
            Matcher matcher = translation.message.matcher(message);
            if (matcher.lookingAt()) {
                return matcher.reset(message.substring(0, matcher.end())).replaceFirst(translation.words);
            }
        }
        return "found what is not JSON";
    }
}

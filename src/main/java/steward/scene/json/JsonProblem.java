package steward.scene.json;

import java.util.regex.Pattern;
import steward.Internal;
import tools.jackson.core.JacksonException;

/** Messages of the JSON parser for people who write JSON. */
@Internal
public final class JsonProblem {

    /** Parts of the parser's messages that are for programmers: descriptions of its source, and its settings. */
    private static final Pattern FOR_PROGRAMMERS =
        Pattern.compile(" \\(start marker at \\[Source: .*?]\\)|: enable `[^`]*` to allow|, from `[^`]*`");

    private JsonProblem() {
    }

    /** The parser's message without the parts for programmers. */
    public static String message(JacksonException problem) {
        return FOR_PROGRAMMERS.matcher(problem.getOriginalMessage()).replaceAll("");
    }
}

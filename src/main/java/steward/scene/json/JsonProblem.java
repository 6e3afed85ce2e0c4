package steward.scene.json;

import java.util.regex.Pattern;
import steward.Internal;
import tools.jackson.core.JacksonException;

/** What the JSON reader found wrong, in words for people who write JSON. */
@Internal
public final class JsonProblem {

    /** What the reader says to programmers: descriptions of its source, and settings it could be given. */
    private static final Pattern FOR_PROGRAMMERS =
        Pattern.compile(" \\(start marker at \\[Source: .*?]\\)|: enable `[^`]*` to allow|, from `[^`]*`");

    private JsonProblem() {
    }

    /** The reader's message without what is meant for programmers. */
    public static String words(JacksonException problem) {
        return FOR_PROGRAMMERS.matcher(problem.getOriginalMessage()).replaceAll("");
    }
}

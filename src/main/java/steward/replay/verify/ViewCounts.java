package steward.replay.verify;

import java.util.List;

/**
 * Comparison of an imported match, word by word, with what the server would have shown of ours.
 *
 * @param values      how many numbers and words agree
 * @param notCompared what the server shows and this program does not compute, in words; empty where nothing is shown
 */
public record ViewCounts(long values, List<String> notCompared) {

    public static final ViewCounts NONE = new ViewCounts(0, List.of());
}

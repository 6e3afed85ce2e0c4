package steward.replay.verify;

import java.util.List;

/**
 * Counts of a comparison, word by word, of an imported match with the frames that the server would have written for
 * ours.
 *
 * @param values      how many numbers and words agree
 * @param near        numbers that are only within 1e-9 of ours, each by its place; at most {@link #MOST_NEAR}
 * @param nearInAll   how many of them there are
 * @param notCompared what the server shows and this program does not compute, in words; empty where nothing is shown
 */
public record ViewCounts(long values, List<String> near, int nearInAll, List<String> notCompared) {

    static final int MOST_NEAR = 5;

    public static final ViewCounts NONE = new ViewCounts(0, List.of(), 0, List.of());
}

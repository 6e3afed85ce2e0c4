package steward.league;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiPredicate;
import java.util.function.Consumer;

/**
 * Bots that are paused because they failed in many games in a row. Whether a bot is paused at a decision depends on the
 * results of earlier decisions alone, of earlier runs too: neither threads nor interruptions change it.
 *
 * <ul>
 * <li>A bot plays if its last game at least {@code lag} decisions back was without failure; nothing is waited for.
 * <li>Otherwise it is paused if it has failed in all games since, and in enough of them. If a game under way could
 * complete the row, the decision waits for that game.
 * </ul>
 *
 * <p>A decision ends the row if the bot played one of its games without failure. So does a person who lets it play
 * again. Not thread-safe.
 */
public final class PausedBots {

    /** State of a bot at a decision. */
    enum State {
        PLAYS, PAUSED,
        /** An answer that depends on games that are not over. */
        OPEN
    }

    private final int most;
    private final int lag;
    private final int first;
    private final Map<Integer, Row> rows = new HashMap<>();

    /** Games of a version. */
    private static final class Row {
        private final TreeMap<Integer, Count> decisions = new TreeMap<>();
        private boolean isKnown;
        private boolean stopped;
        /** Failures in decisions below this one do not matter. */
        private int since;
        /** Games in a row in which it failed, in decisions that are not in the map any more; -1 if there are none. */
        private int failures = -1;
    }

    /** Games of a version in a decision. */
    private static final class Count {
        private int open;
        private int failed;
        private int fine;
    }

    /**
     * @param most  how many games in a row pause a bot; 0 for never
     * @param lag   of the schedule, in decisions
     * @param first the first decision that this run makes
     */
    public PausedBots(int most, int lag, int first) {
        this.most = most;
        this.lag = lag;
        this.first = first;
    }

    private Row row(int version) {
        return rows.computeIfAbsent(version, any -> new Row());
    }

    /**
     * Takes how a version is to play from now on.
     *
     * @param since   the first decision in which its failures matter: it was let play again then
     * @param stopped whether it is paused whatever its results are
     * @param earlier called once: tells of its games of earlier runs, each with its decision and whether it failed, as
     *                long as more are wanted. They come in the reverse order of their ends, which is that of decisions
     *                but for {@code lag}
     */
    public void use(int version, int since, boolean stopped, Consumer<BiPredicate<Integer, Boolean>> earlier) {
        Row row = row(version);
        row.stopped = stopped;
        if (since > row.since) {
            row.since = since;
            row.failures = -1;
            row.decisions.headMap(since).clear();
        }
        if (most > 0 && !row.isKnown) {
            int[] fine = {-1};                         // ends the row, as no decision to come waits for it
            earlier.accept((decision, failed) -> {
                over(decision, version, failed);
                fine[0] = Math.max(fine[0], !failed && decision <= first - lag ? decision : -1);
                return decision >= fine[0] - lag;
            });
        }
        row.isKnown = true;
    }

    /** True if a version was let play again after a decision. */
    boolean isResumed(int version, int decision) {
        return decision < row(version).since;
    }

    /** Takes that a game will be played, or not any more: it is over, or held. */
    void expect(Schedule.Task task, boolean is) {
        for (int version : task.lineup()) {
            Count count = count(task.decision(), version);
            count.open = Math.max(0, count.open + (is ? 1 : -1));
        }
    }

    /** A game of a version is over. */
    void over(int decision, int version, boolean failed) {
        Count count = count(decision, version);
        count.failed += failed ? 1 : 0;
        count.fine += failed ? 0 : 1;
    }

    private Count count(int decision, int version) {
        Row row = row(version);
        return decision < row.since || most == 0 ? new Count()
            : row.decisions.computeIfAbsent(decision, any -> new Count());
    }

    /** Returns how a version stands at a decision; those {@code lag} or more back are over. */
    State at(int version, int decision) {
        Row row = row(version);
        while (!row.decisions.isEmpty() && row.decisions.firstKey() <= decision - lag) {
            Count count = row.decisions.pollFirstEntry().getValue();
            row.failures = count.fine > 0 ? 0 : count.failed > 0 ? Math.max(0, row.failures) + count.failed
                : row.failures;
        }
        if (row.stopped) {
            return State.PAUSED;
        }
        if (most == 0 || row.failures == 0) {
            return State.PLAYS;
        }
        int failures = Math.max(0, row.failures);
        boolean open = false;
        for (Count count : row.decisions.headMap(decision).values()) {
            if (count.fine > 0) {
                return State.PLAYS;
            }
            open |= count.open > 0;
            failures += count.failed + count.open;
        }
        return failures < most ? State.PLAYS : open ? State.OPEN : State.PAUSED;
    }
}

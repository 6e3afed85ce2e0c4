package steward.league;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;

/**
 * Bots that are paused because they failed in many games in a row. Whether a bot is paused at a decision depends on the
 * results of earlier decisions alone, so that threads do not change it:
 *
 * <ul>
 * <li>A bot plays if its last game at least {@code lag} decisions back was without failure; nothing is waited for.
 * <li>Otherwise it is paused if it has failed in all games since, and in enough of them. If a game under way could
 * complete the row, the decision waits for that game.
 * </ul>
 *
 * <p>A decision ends the row if the bot played one of its games without failure. Not thread-safe.
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
    private final Map<Integer, Row> rows = new HashMap<>();

    /** Games of a version. */
    private static final class Row {
        private final TreeMap<Integer, Count> decisions = new TreeMap<>();
        /** Earlier failures do not matter. */
        private int since;
        /** Games in a row in which it failed, in decisions that are not in the map any more. */
        private int failures;
        private boolean hasEarlier;
        private boolean stopped;
        /** The last decision without failure that does not matter to the next one any more, or -1. */
        private int fine = -1;
    }

    /** Games of a version in a decision. */
    private static final class Count {
        private int open;
        private int failed;
        private int fine;
    }

    /**
     * @param most how many games in a row pause a bot; 0 for never
     * @param lag  of the schedule, in decisions
     */
    public PausedBots(int most, int lag) {
        this.most = most;
        this.lag = lag;
    }

    private Row row(int version) {
        return rows.computeIfAbsent(version, any -> new Row());
    }

    /** Lets a version play again: its failures in decisions below this one do not matter. */
    public void resume(int version, int decision) {
        Row row = row(version);
        row.stopped = false;
        if (decision > row.since) {
            row.since = decision;
            row.failures = 0;
            row.hasEarlier = false;
            row.decisions.headMap(decision).clear();
        }
    }

    /** True if a version was let play again after a decision. */
    boolean isResumed(int version, int decision) {
        return decision < row(version).since;
    }

    /** Pauses a version whatever its results are, until it is resumed. */
    public void pause(int version) {
        row(version).stopped = true;
    }

    /** A game that will be played. */
    void expect(Schedule.Task task) {
        for (int version : task.lineup()) {
            count(task.decision(), version).open++;
        }
    }

    /** A game that was expected is over, or will not be played. */
    void forget(Schedule.Task task) {
        for (int version : task.lineup()) {
            Count count = count(task.decision(), version);
            count.open = Math.max(0, count.open - 1);
        }
    }

    /**
     * A game of a version was over before this run. Its games come in the reverse order of their ends, which is that of
     * decisions but for {@code lag}.
     *
     * @param next the decision that is made next: a game without failure that is {@code lag} back ends the row
     * @return whether one before it is wanted
     */
    public boolean earlier(int next, int decision, int version, boolean failed) {
        over(decision, version, failed);
        Row row = row(version);
        if (!failed && decision <= next - lag) {
            row.fine = Math.max(row.fine, decision);
        }
        return most > 0 && decision >= row.fine - lag;
    }

    /** A game of a version is over. */
    public void over(int decision, int version, boolean failed) {
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
            row.failures = count.fine > 0 ? 0 : row.failures + count.failed;
            row.hasEarlier |= count.fine + count.failed > 0;
        }
        if (row.stopped) {
            return State.PAUSED;
        }
        if (most == 0 || row.hasEarlier && row.failures == 0) {
            return State.PLAYS;
        }
        int failures = row.failures;
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

package steward.match;

import steward.bot.TimeBasis;
import steward.scene.Time;

/**
 * Time limits for the answers of all players.
 *
 * @param firstNanos the limit of the first answer, in nanoseconds; it includes the start of a process
 * @param turnNanos  the limit of every later answer; {@code Long.MAX_VALUE} is no deadline
 * @param basis      what they are limits of
 * @param factor     by which limits are multiplied that a player has or a game sets itself;
 *                   {@code POSITIVE_INFINITY} for none
 */
public record TimeControl(long firstNanos, long turnNanos, TimeBasis basis, double factor) {

    /** No deadlines. */
    public static final TimeControl UNLIMITED = new TimeControl(Long.MAX_VALUE, Long.MAX_VALUE,
        TimeBasis.WALL, Double.POSITIVE_INFINITY);

    private static final double NANOS_PER_MS = 1e6;

    /** Limits of the wall clock. */
    public TimeControl(long firstNanos, long turnNanos) {
        this(firstNanos, turnNanos, TimeBasis.WALL, 1);
    }

    /** Returns these limits on another clock. */
    public TimeControl by(TimeBasis other) {
        return new TimeControl(firstNanos, turnNanos, other, factor);
    }

    /** A scene's limits times a factor, finite and above 0. */
    public static TimeControl of(Time time, double factor) {
        if (!(factor > 0 && factor < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("time factor " + factor + ", expected above 0");
        }
        return new TimeControl((long) (time.firstAnswerMs() * NANOS_PER_MS * factor),
            (long) (time.answerMs() * NANOS_PER_MS * factor), TimeBasis.WALL, factor);
    }

    /** The limit of a player's n-th answer, counted from 0. */
    public long limit(int answersBefore) {
        return answersBefore == 0 ? firstNanos : turnNanos;
    }

    /**
     * The limit of a player's n-th answer where a player or its game can have others.
     *
     * @param own    limits of the player, which come first; or {@code null}
     * @param gameMs a limit that the game sets itself; 0 for none
     * @return in nanoseconds
     */
    public long limit(Time own, int gameMs, int answersBefore) {
        int ms = own == null ? gameMs : answersBefore == 0 ? own.firstAnswerMs() : own.answerMs();
        return ms == 0 ? limit(answersBefore)
            : factor == Double.POSITIVE_INFINITY ? Long.MAX_VALUE : (long) (ms * NANOS_PER_MS * factor);
    }

    /**
     * Returns a time as a game counts it that sets limits itself: as if the limit were its own, and 0 without limits.
     *
     * @param nanos   that were measured
     * @param limit   that the player has, in nanoseconds
     * @param gameMs  limit that the game sets; 0 for none
     */
    static long counted(long nanos, long limit, int gameMs) {
        return gameMs == 0 ? nanos : limit == Long.MAX_VALUE ? 0 : (long) (nanos * (gameMs * NANOS_PER_MS / limit));
    }

    /** Returns a time of a game that sets limits itself as a time for the player, the inverse of {@link #counted}. */
    static long allowed(int ms, long limit, int gameMs) {
        return limit == Long.MAX_VALUE ? limit : (long) (ms * (double) limit / gameMs);
    }
}

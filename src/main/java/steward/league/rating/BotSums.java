package steward.league.rating;

import steward.league.StoredGame.StoredSeat;

/** Sums over all games of one version of a bot: games, scores, failures, answer times. */
public final class BotSums {

    private long games;
    private double score;
    private long faults;
    private long allFailed;
    private long answers;
    private double nanos;
    private long worstNanos;

    void add(StoredSeat seat) {
        add(1, seat.score(), seat.fault() == null ? 0 : 1, seat.answers(), (double) seat.meanNanos() * seat.answers(),
            seat.worstNanos());
    }

    void add(long moreGames, double moreScore, long moreFaults, long moreAnswers, double moreNanos, long worst) {
        games += moreGames;
        score += moreScore;
        faults += moreFaults;
        answers += moreAnswers;
        nanos += moreNanos;
        worstNanos = Math.max(worstNanos, worst);
    }

    /** Returns how many count. */
    public long games() {
        return games;
    }

    /** The game's own score, the mean; NaN without games. */
    public double meanScore() {
        return games == 0 ? Double.NaN : score / games;
    }

    /** Games in which it failed. */
    public long faults() {
        return faults;
    }

    void addAllFailed(long more) {
        allFailed += more;
    }

    /** Games besides those that count, in which all players failed in the same turn. */
    public long allFailed() {
        return allFailed;
    }

    /** In nanoseconds; NaN without answers. */
    public double meanNanos() {
        return answers == 0 ? Double.NaN : nanos / answers;
    }

    /** The longest answer, in nanoseconds. */
    public long worstNanos() {
        return worstNanos;
    }
}

package steward.lab.capacity;

import steward.lab.capacity.MeasuredLeague.Kind;
import steward.lab.capacity.MeasuredLeague.Sample;

/**
 * Measured costs of workers, and the number of workers that a league can serve, as follows from them.
 *
 * @param rate   games in a second at which the overhead is told
 * @param rounds how often both leagues were measured in turn; medians are told
 * @param alone  a league that plays its games itself
 * @param served the same with a worker in the same process
 * @param table  simulated
 */
public record Capacity(double rate, int rounds, Sample alone, Sample served, CheckPrices prices,
                       SaturationTable table) {

    private static final double MICROS = 1e6;

    /** The costs of a game, in whole microseconds: what is simulated is what is printed. */
    public static LeagueCosts costs(Sample served, CheckPrices prices) {
        double offers = served.kinds().get(Kind.GAMES) - prices.check() - MeasuredLeague.SHARE * prices.again();
        return new LeagueCosts(whole(served.kinds().get(Kind.BROKER) + Math.max(0, offers)),
            whole(served.kinds().get(Kind.MESSAGES)), whole(prices.check()), whole(prices.again()),
            MeasuredLeague.SHARE, whole(served.kinds().get(Kind.SCHEDULE)),
            whole(served.kinds().get(Kind.STORE)));
    }

    private static double whole(double micros) {
        return Math.max(1, Math.rint(micros));
    }

    /** Returns the extra cost of a game with a worker, on both sides, in microseconds of all threads. */
    public double overhead() {
        return served.threads() - alone.threads();
    }

    /**
     * Returns the extra cost of checks and connection to the league's process over a game of its own, without the game.
     */
    public double leagueOverhead() {
        LeagueCosts costs = table.costs();
        return costs.broker() + costs.messages() + costs.check() + costs.share() * costs.again();
    }

    /** Returns so many microseconds a game as a share of one processor, at {@link #rate} games in a second. */
    public double ofOneProcessor(double micros) {
        return micros * rate / MICROS;
    }
}

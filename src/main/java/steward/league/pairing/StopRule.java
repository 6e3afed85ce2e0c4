package steward.league.pairing;

import java.util.List;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import steward.league.rating.AnytimeBar;
import steward.league.rating.Difference;
import steward.league.rating.Ratings;

/**
 * Rule by which a league knows enough to end. It compares ratings by bars that hold at any time.
 *
 * @param bars   ends when the rating of each bot that can have such a bar has one of at most so many Elo, see {@link
 *               BarNeed}; NaN for no such end
 * @param ranked ends when every two neighbours in the table are ordered or equal, or no game can compare them
 * @param equal  neighbours are equal whose difference is surely within so many Elo; 0 if none are
 */
public record StopRule(double bars, boolean ranked, double equal) {

    /** Order of two neighbours in the table, as far as it is known. */
    public enum Order {
        /** The first is better. */
        ORDERED,
        /** They are equal, as far as is asked. */
        EQUAL,
        /** Neither is sure. */
        OPEN,
        /** They cannot meet, and both are sure beside those that they meet: no game will compare them. */
        APART
    }

    /** Elo within which bots count as equal, if nothing else is said. */
    public static final double USUAL_EQUAL = 5;
    /** Share of the permitted errors that falls to the test of bots that win or lose nearly everything. */
    private static final double TESTED = 0.1;
    /** One that never ends a league. */
    public static final StopRule NONE = new StopRule(Double.NaN, false, USUAL_EQUAL);

    /** True if it is there. */
    public boolean isAny() {
        return ranked || !Double.isNaN(bars);
    }

    /** True if enough is known. @param meet whether two versions may meet in a game */
    public boolean isMet(Ratings ratings, BiPredicate<Integer, Integer> meet) {
        return (Double.isNaN(bars) || BarNeed.of(ratings, bars).stream().noneMatch(BarNeed::isWaitedFor))
            && (!ranked || !orders(ratings, ratings.order(), meet).contains(Order.OPEN));
    }

    /** Returns the known order of each version in a list and the next one. */
    public List<Order> orders(Ratings ratings, List<Integer> order, BiPredicate<Integer, Integer> meet) {
        return IntStream.range(1, order.size()).mapToObj(k -> {
            int upper = order.get(k - 1);
            int lower = order.get(k);
            Order known = order(ratings, upper, lower);
            return known == Order.OPEN && !meet.test(upper, lower) && !ratings.isComparable(upper, lower)
                && isSettled(ratings, order, k - 1, meet) && isSettled(ratings, order, k, meet) ? Order.APART : known;
        }).toList();
    }

    /** True if a version is ordered beside the next above and the next below that it meets. */
    private boolean isSettled(Ratings ratings, List<Integer> order, int place, BiPredicate<Integer, Integer> meet) {
        int version = order.get(place);
        for (int step = -1; step <= 1; step += 2) {
            int next = place + step;
            while (next >= 0 && next < order.size() && !meet.test(version, order.get(next))) {
                next += step;
            }
            if (next >= 0 && next < order.size() && order(ratings, version, order.get(next)) == Order.OPEN) {
                return false;
            }
        }
        return true;
    }

    /**
     * Returns the known order of two versions; it does not matter which of them is the better one. All that is said
     * holds with 95% for all pairs of bots and at all looks at once: each has the part of the 5% that falls to one of
     * so many pairs, nine tenths for its bar and one for the test of those of which one has won or lost nearly
     * everything. Across components all falls to their bound.
     */
    Order order(Ratings ratings, int one, int other) {
        int bots = ratings.versions().size();
        double alpha = AnytimeBar.ALPHA / Math.max(1, bots * (bots - 1) / 2);
        if (!ratings.isComparable(one, other)) {
            return ratings.isUnequal(one, other, alpha) ? Order.ORDERED : Order.OPEN;
        }
        Difference difference = ratings.difference(one, other);
        double bar = difference.anytimeBar((1 - TESTED) * alpha);
        double apart = Math.abs(difference.elo());
        return apart > bar || ratings.isUnequal(one, other, TESTED * alpha) ? Order.ORDERED
            : apart + bar <= equal ? Order.EQUAL : Order.OPEN;
    }
}

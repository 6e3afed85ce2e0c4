package steward.league.pairing;

import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import steward.league.rating.Ratings;

/** End of a schedule by a {@link StopRule}, at a decision that depends neither on threads nor on interruptions. */
public final class LeagueEnd implements IntPredicate {

    private final StopRule rule;
    private final KnownResults known;
    private final int lag;
    private final Supplier<List<Integer>> versions;
    private final BiPredicate<Integer, Integer> meet;
    private Ratings met;
    private int asked = -1;
    /** Those that played then. */
    private List<Integer> rated = List.of();

    /**
     * @param rule     may be {@link StopRule#NONE}: then nothing else is asked
     * @param versions those that play, when it is asked
     * @param meet     whether two versions may meet in a game
     */
    public LeagueEnd(StopRule rule, KnownResults known, int lag, Supplier<List<Integer>> versions,
                     BiPredicate<Integer, Integer> meet) {
        this.rule = rule;
        this.known = known;
        this.lag = lag;
        this.versions = versions;
        this.meet = meet;
    }

    /** True if the schedule ends before a decision. */
    @Override
    public boolean test(int decision) {
        List<Integer> playing = versions.get();
        if (decision != asked || !playing.equals(rated)) {
            asked = decision;
            rated = playing;
            met = null;
            if (rule.isAny() && Looks.isLook(decision) && decision >= lag && playing.size() > 1) {
                Ratings ratings = Ratings.of(known.before(decision - lag + 1), playing);
                met = rule.isMet(ratings, meet) ? ratings : null;
            }
        }
        return met != null;
    }

    /** Returns the ratings when the rule was met, or {@code null}. */
    public Ratings met() {
        return met;
    }

    public StopRule rule() {
        return rule;
    }
}

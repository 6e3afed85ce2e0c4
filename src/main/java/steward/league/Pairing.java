package steward.league;

import java.util.List;
import java.util.function.Predicate;

/**
 * Strategy that decides which bots play next. It is told all decisions. A pairing that uses results is told only those
 * of decisions at least {@code lag} back; so its choices depend neither on threads nor on where a run was interrupted.
 */
public interface Pairing {

    /** Tells it the number of the decision that it is to choose for next. */
    default void next(int decision) {
        // Most pairings do not mind.
    }

    /**
     * Chooses the versions of the next decision.
     *
     * @param wanted true of groups that may be chosen
     * @return from the lowest; {@code null} if no group may
     */
    int[] choose(Predicate<int[]> wanted);

    /** Tells it that these versions were decided on so many times, now or in an earlier run. */
    void made(int times, int... versions);

    /** Everyone against everyone, whoever has met least. */
    static Pairing roundRobin(List<Integer> versions, int players) {
        return new LeastPlayed(versions, players, -1);
    }

    /** One against everyone else. */
    static Pairing gauntlet(List<Integer> versions, int players, int hero) {
        return new LeastPlayed(versions, players, hero);
    }
}

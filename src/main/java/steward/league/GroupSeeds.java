package steward.league;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.contest.seeds.Seeds;

/**
 * Seeds that each group of bots still has to play. From a list, each group plays every seed once in the list's order,
 * whatever it played from an earlier list. From consecutive numbers, each decision takes the next. Not thread-safe.
 */
final class GroupSeeds {

    private final Seeds seeds;
    private final Map<List<Integer>, BitSet> played = new HashMap<>();
    /** Places of the seeds in the list. */
    private final Map<Long, Integer> places = new HashMap<>();
    private int others;

    GroupSeeds(Seeds seeds) {
        this.seeds = seeds;
        for (int place = 0; seeds.isListed() && place < seeds.count(); place++) {
            places.put(seeds.at(place), place);
        }
    }

    /** Takes a decision of an earlier run. */
    void decided(List<Integer> group, long seed) {
        Integer place = places.get(seed);
        if (place != null) {
            of(group).set(place);
        } else if (seeds.isListed()) {
            others++;
        }
    }

    private BitSet of(List<Integer> group) {
        return played.computeIfAbsent(group, any -> new BitSet());
    }

    /** Number of decisions on seeds that are not in the list: it was another one then. */
    int others() {
        return others;
    }

    /** Number of seeds that a group has not played. */
    int left(List<Integer> group) {
        return seeds.count() - (seeds.isListed() ? played.getOrDefault(group, new BitSet()).cardinality() : 0);
    }

    /** Returns a group's next seed, which it has played then. @param number of the decision */
    long next(List<Integer> group, int number) {
        if (!seeds.isListed()) {
            return seeds.at(number);
        }
        BitSet own = of(group);
        int place = own.nextClearBit(0);
        own.set(place);
        return seeds.at(place);
    }
}

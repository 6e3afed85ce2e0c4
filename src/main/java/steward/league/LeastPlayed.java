package steward.league;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Predicate;

/**
 * Pairing that chooses the group with the fewest games, among equals the first in {@link RoundOrder}, so that
 * latecomers catch up. It uses no results.
 */
final class LeastPlayed implements Pairing {

    private final List<int[]> groups;
    private final Map<String, Integer> places = new HashMap<>();
    private final int[] counts;
    /** Places of groups, the next one first. */
    private final TreeSet<Integer> order;

    /** @param hero the version that is in every group, or -1 */
    LeastPlayed(List<Integer> versions, int players, int hero) {
        groups = RoundOrder.groups(versions, players, hero);
        counts = new int[groups.size()];
        order = new TreeSet<>((one, other) -> counts[one] != counts[other]
            ? Integer.compare(counts[one], counts[other]) : Integer.compare(one, other));
        for (int place = 0; place < groups.size(); place++) {
            places.put(key(groups.get(place)), place);
            order.add(place);
        }
    }

    private static String key(int... versions) {
        return Arrays.toString(versions);
    }

    @Override
    public int[] choose(Predicate<int[]> wanted) {
        return order.stream().map(groups::get).filter(wanted).findFirst().map(int[]::clone).orElse(null);
    }

    @Override
    public void made(int times, int... versions) {
        Integer place = places.get(key(versions));
        if (place != null) {
            order.remove(place);
            counts[place] += times;
            order.add(place);
        }
    }
}

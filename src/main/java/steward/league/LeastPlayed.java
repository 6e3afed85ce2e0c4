package steward.league;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/**
 * Chooses the group of bots that has been chosen least, the first of several in the order of versions: a round robin,
 * in which a bot that comes later catches up. Uses no results.
 */
final class LeastPlayed implements Pairing {

    /** More groups than this are not listed. */
    private static final int MOST = 1_000_000;

    private final List<int[]> groups = new ArrayList<>();
    private final Map<String, Integer> places = new HashMap<>();
    private final int[] counts;
    /** Places of groups, the next one first. */
    private final TreeSet<Integer> order;

    /** @param hero the version that is in every group, or -1 */
    LeastPlayed(List<Integer> versions, int players, int hero) {
        List<Integer> sorted = new ArrayList<>(versions);
        Collections.sort(sorted);
        add(sorted, 0, new int[players], 0, hero);
        counts = new int[groups.size()];
        order = new TreeSet<>((one, other) -> counts[one] != counts[other]
            ? Integer.compare(counts[one], counts[other]) : Integer.compare(one, other));
        for (int place = 0; place < groups.size(); place++) {
            places.put(key(groups.get(place)), place);
            order.add(place);
        }
    }

    private void add(List<Integer> versions, int from, int[] group, int size, int hero) {
        if (size == group.length) {
            if (groups.size() == MOST) {
                throw new IllegalArgumentException("more than " + MOST + " groups of bots");
            }
            boolean wanted = hero < 0;
            for (int version : group) {
                wanted |= version == hero;
            }
            if (wanted) {
                groups.add(group.clone());
            }
            return;
        }
        for (int k = from; k < versions.size(); k++) {
            group[size] = versions.get(k);
            add(versions, k + 1, group, size + 1, hero);
        }
    }

    private static String key(int... versions) {
        StringBuilder key = new StringBuilder();
        for (int version : versions) {
            key.append(version).append(' ');
        }
        return key.toString();
    }

    @Override
    public int[] choose() {
        return groups.get(order.first()).clone();
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

package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Order of all groups of bots in which game counts stay balanced: the bot with the fewest games comes first. For two
 * players it is the circle method: no bot is ever more than one game ahead of another. In larger groups it is two games
 * at most.
 */
public final class RoundOrder {

    /** More groups than this are not listed. */
    private static final int MOST = 1_000_000;
    /** With more groups than this fewer candidates are tried for each place: a list of a million takes seconds. */
    private static final int MANY = 50_000;
    private static final int TRIES = 2000;
    private static final int FEW_TRIES = 50;

    private final List<Integer> versions;
    private final int players;
    private final List<int[]> groups = new ArrayList<>();
    private final int[] games;
    private final Set<List<Integer>> used = new HashSet<>();
    private int tries;

    private RoundOrder(List<Integer> versions, int players) {
        this.versions = versions;
        this.players = players;
        games = new int[versions.size()];
    }

    /**
     * All groups, each from the lowest version.
     *
     * @param hero the version that is in every group, or -1
     * @throws IllegalArgumentException if there are more than a million
     */
    public static List<int[]> groups(List<Integer> versions, int players, int hero) {
        List<Integer> free = versions.stream().filter(version -> version != hero).sorted().toList();
        RoundOrder order = new RoundOrder(free, hero < 0 ? players : players - 1);
        order.find();
        return order.groups.stream().map(group -> hero < 0 ? group
            : IntStream.concat(IntStream.of(hero), IntStream.of(group)).sorted().toArray()).toList();
    }

    private void find() {
        long all = 1;
        for (int k = 0; k < players && all <= MOST; k++) {
            all = all * (versions.size() - k) / (k + 1);
        }
        if (all > MOST) {
            throw new IllegalArgumentException("more than " + MOST + " groups of bots");
        }
        if (players == 2) {
            circle();
            return;
        }
        int[] first = new int[players];
        while (groups.size() < all) {
            tries = all > MANY ? FEW_TRIES : TRIES;
            List<Integer> least = IntStream.range(0, games.length).boxed()
                .sorted(Comparator.comparingInt(bot -> games[bot])).toList();
            int[] group = new int[players];
            if (!choose(least, 0, group, 0)) {
                group = unused(first);
            }
            used.add(key(group));
            groups.add(IntStream.of(group).map(versions::get).sorted().toArray());
            IntStream.of(group).forEach(bot -> games[bot]++);
        }
    }

    /**
     * An even number: the bots sit at a round table, the last in its middle. In a round all those meet who sit opposite
     * each other as seen from one seat, whose bot meets the middle; then everybody moves on.
     *
     * <p>An odd number: tours lead through all bots, each from the one in the middle and then to and fro across the
     * table, and begin one seat further each time (Walecki's decomposition: B. Alspach, "The wonderful Walecki
     * construction", Bulletin of the Institute of Combinatorics and its Applications 52, 2008). In a tour neighbours
     * meet by twos, then the last and the first, then the twos between.
     */
    private void circle() {
        int bots = versions.size();
        if (bots % 2 == 0) {
            for (int round = 0; round < bots - 1; round++) {
                addPair(round, bots - 1);
                for (int k = 1; k < bots / 2; k++) {
                    addPair((round + k) % (bots - 1), (round - k + bots - 1) % (bots - 1));
                }
            }
            return;
        }
        int[] tour = new int[bots];
        for (int first = 0; first < bots / 2; first++) {
            for (int k = 1; k < bots; k++) {
                int across = k % 2 == 0 ? k / 2 : -(k / 2);
                tour[k] = 1 + (first + across + bots - 1) % (bots - 1);
            }
            for (int k = 0; k < 2 * bots; k += 2) {
                addPair(tour[k % bots], tour[(k + 1) % bots]);
            }
        }
    }

    private void addPair(int one, int other) {
        groups.add(new int[] {versions.get(Math.min(one, other)), versions.get(Math.max(one, other))});
    }

    /** Takes the first unused group in the order of the bots, within the tries that are left. */
    private boolean choose(List<Integer> order, int from, int[] group, int size) {
        if (size == group.length) {
            return tries-- > 0 && !used.contains(key(group));
        }
        for (int k = from; k < order.size() && tries > 0; k++) {
            group[size] = order.get(k);
            if (choose(order, k + 1, group, size + 1)) {
                return true;
            }
        }
        return false;
    }

    /** Goes on from a group, in the order of versions, to one that is unused. @param from {@code 0 0 ...} at first */
    private int[] unused(int... from) {
        if (from.length > 1 && from[1] == 0) {
            Arrays.setAll(from, k -> k);
        }
        while (used.contains(key(from))) {
            int place = players - 1;
            while (from[place] == versions.size() - players + place) {
                place--;
            }
            from[place]++;
            for (int k = place + 1; k < players; k++) {
                from[k] = from[k - 1] + 1;
            }
        }
        return from.clone();
    }

    private static List<Integer> key(int... group) {
        return Arrays.stream(group).sorted().boxed().toList();
    }
}

package steward.league.rating;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Games of two and more, put together by seed and group of bots. A cluster is open until every bot has been on every
 * seat; until then it counts as far as it has come. Nothing depends on the order in which games come.
 */
final class Clusters {

    private static final Comparator<int[]> ORDER = Arrays::compare;

    /** By group, its versions ascending: how often a cluster went so. */
    private final Map<int[], Map<int[], Long>> groups = new TreeMap<>(ORDER);
    private final Map<Key, int[]> open = new HashMap<>();
    private final boolean alone;

    private record Key(long seed, List<Integer> group) {
    }

    /** @param alone whether each bot plays alone: then a map is one game of all who have played it */
    Clusters(boolean alone) {
        this.alone = alone;
    }

    /** Adds clusters of one group that all went so: one array of ranks by ascending version for each game, in a row. */
    void add(int[] group, int[] games, long count) {
        Map<int[], Long> patterns = groups.computeIfAbsent(group, key -> new TreeMap<>(ORDER));
        if (patterns.merge(sorted(games, group.length), count, Long::sum) == 0) {
            patterns.remove(sorted(games, group.length));
        }
        if (patterns.isEmpty()) {
            groups.remove(group);
        }
    }

    /** The same games, in an order of their own. */
    private static int[] sorted(int[] games, int players) {
        List<int[]> each = new ArrayList<>();
        for (int from = 0; from < games.length; from += players) {
            each.add(Arrays.copyOfRange(games, from, from + players));
        }
        each.sort(ORDER);
        return each.stream().flatMapToInt(Arrays::stream).toArray();
    }

    /** Adds a game. */
    void add(long seed, int[] lineup, int... ranks) {
        int[] group = group(lineup);
        Key key = new Key(seed, Arrays.stream(group).boxed().toList());
        int[] before = open.getOrDefault(key, new int[0]);
        if (before.length > 0) {
            add(group, before, -1);
        }
        int[] games = Arrays.copyOf(before, before.length + ranks.length);
        System.arraycopy(byVersion(group, lineup, ranks), 0, games, before.length, ranks.length);
        add(group, games, 1);
        if (games.length == group.length * group.length) {
            open.remove(key);
        } else {
            open.put(key, games);
        }
    }

    static int[] group(int... lineup) {
        int[] group = lineup.clone();
        Arrays.sort(group);
        return group;
    }

    /** Ranks in the order of a group. */
    static int[] byVersion(int[] group, int[] lineup, int... ranks) {
        int[] ordered = new int[ranks.length];
        for (int seat = 0; seat < lineup.length; seat++) {
            ordered[Arrays.binarySearch(group, lineup[seat])] = ranks[seat];
        }
        return ordered;
    }

    /**
     * What a fit takes.
     *
     * @param places of versions in the fit, ascending as the versions; groups with others are left out
     */
    List<Stratum> strata(Map<Integer, Integer> places) {
        List<Stratum> strata = new ArrayList<>();
        groups.forEach((group, patterns) -> {
            if (group.length > 1 && Arrays.stream(group).allMatch(places::containsKey)) {
                Stratum stratum = new Stratum(alone ? 1 : 2.0 / group.length,
                    Arrays.stream(group).map(places::get).toArray());
                patterns.forEach((games, count) -> stratum.add(stratum.pattern(numbers(games, group.length)), count));
                strata.add(stratum);
            }
        });
        return strata;
    }

    private double[] numbers(int[] games, int players) {
        double weight = alone ? 1 : 2.0 / players;
        double[] numbers = new double[3 * players * (players - 1) / 2];
        for (int from = 0; from < games.length; from += players) {
            int k = 0;
            for (int i = 0; i < players; i++) {
                for (int j = i + 1; j < players; j++) {
                    int one = games[from + i];
                    int other = games[from + j];
                    numbers[k] += weight;
                    numbers[k + 1] += one < other ? weight : one == other ? weight / 2 : 0;
                    numbers[k + 2] += one == other ? weight : 0;
                    k += 3;
                }
            }
        }
        return numbers;
    }

    /** How many clusters there are. */
    long count() {
        return groups.values().stream().flatMap(patterns -> patterns.values().stream()).mapToLong(Long::longValue)
            .sum();
    }
}

package steward.league.rating;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Games of two and more players, grouped by seed: games of one seed whose bots are connected form one cluster. A
 * cluster counts even if some of its games are missing. The order in which games are added does not matter.
 */
final class Clusters {

    private static final Comparator<int[]> ORDER = Arrays::compare;
    private static final Comparator<int[][]> BY_GROUP = (one, other) -> Arrays.compare(one, other, ORDER);

    /** By groups, each ascending: how often a cluster went so; three counts for each pair as of {@link #count}. */
    private final Map<int[][], Map<int[], Long>> shapes = new TreeMap<>(BY_GROUP);
    private final Map<Long, List<Cluster>> seeds = new HashMap<>();
    /** Games that are not among the clusters of their seeds yet, each as a cluster of its own. */
    private final Map<Long, List<Cluster>> waiting = new HashMap<>();
    private final boolean alone;

    /**
     * A cluster.
     *
     * @param groups bots that have played together, in {@link #ORDER}
     * @param counts by group
     */
    private record Cluster(int[][] groups, int[]... counts) {

        /** All games of some clusters. */
        static Cluster of(List<Cluster> parts) {
            Map<int[], int[]> all = new TreeMap<>(ORDER);
            for (Cluster part : parts) {
                for (int g = 0; g < part.groups.length; g++) {
                    all.merge(part.groups[g], part.counts[g], Cluster::sum);
                }
            }
            return new Cluster(all.keySet().toArray(int[][]::new), all.values().toArray(int[][]::new));
        }

        private static int[] sum(int[] one, int... other) {
            int[] sum = one.clone();
            for (int k = 0; k < sum.length; k++) {
                sum[k] += other[k];
            }
            return sum;
        }
    }

    /** @param alone whether each bot plays alone: then a map is one game of all who have played it */
    Clusters(boolean alone) {
        this.alone = alone;
    }

    /** Adds a game. It waits until as many have come as the seed has groups: then joining all costs little for each. */
    void add(long seed, int[] lineup, int... ranks) {
        int[] group = group(lineup);
        List<Cluster> games = waiting.computeIfAbsent(seed, key -> new ArrayList<>(1));
        games.add(new Cluster(new int[][] {group}, count(byVersion(group, lineup, ranks))));
        if (games.size() >= seeds.getOrDefault(seed, List.of()).stream().mapToInt(each -> each.groups.length).sum()) {
            join(seed, waiting.remove(seed));
        }
    }

    private void joinAll() {
        waiting.forEach(this::join);
        waiting.clear();
    }

    /** Joins games with the clusters of their seed that their bots connect. */
    private void join(long seed, List<Cluster> games) {
        List<Cluster> parts = new ArrayList<>(seeds.getOrDefault(seed, List.of()));
        parts.forEach(cluster -> add(cluster, -1));
        parts.addAll(games);
        Map<Integer, Integer> links = new HashMap<>();
        for (Cluster part : parts) {
            int first = root(links, part.groups[0][0]);
            Stream.of(part.groups).flatMapToInt(Arrays::stream).forEach(bot -> links.put(root(links, bot), first));
        }
        seeds.put(seed, parts.stream().collect(Collectors.groupingBy(part -> root(links, part.groups[0][0])))
            .values().stream().map(Cluster::of).toList());
        seeds.get(seed).forEach(cluster -> add(cluster, 1));
    }

    /** The bot that stands for all that are connected with a bot. */
    private static int root(Map<Integer, Integer> links, int bot) {
        int root = bot;
        for (int next = links.getOrDefault(root, root); next != root; next = links.getOrDefault(root, root)) {
            root = next;
        }
        links.put(bot, root);
        return root;
    }

    /** Adds clusters of one group that all went so: ranks by ascending version, of each game. */
    void add(int[] group, List<int[]> games, long count) {
        add(Cluster.of(games.stream().map(ranks -> new Cluster(new int[][] {group}, count(ranks))).toList()), count);
    }

    private void add(Cluster cluster, long count) {
        Map<int[], Long> patterns = shapes.computeIfAbsent(cluster.groups, key -> new TreeMap<>(ORDER));
        int[] pattern = Stream.of(cluster.counts).flatMapToInt(Arrays::stream).toArray();
        if (patterns.merge(pattern, count, Long::sum) == 0) {
            patterns.remove(pattern);
        }
        if (patterns.isEmpty()) {
            shapes.remove(cluster.groups);
        }
    }

    /** By pair of one game: 1, twice the points of the first, 1 if it was a tie. */
    private static int[] count(int... ranks) {
        int[] counts = new int[3 * ranks.length * (ranks.length - 1) / 2];
        int k = 0;
        for (int i = 0; i < ranks.length; i++) {
            for (int j = i + 1; j < ranks.length; j++) {
                counts[k++] = 1;
                counts[k++] = 1 + Integer.compare(ranks[j], ranks[i]);
                counts[k++] = ranks[i] == ranks[j] ? 1 : 0;
            }
        }
        return counts;
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
     * Returns the strata for a fit.
     *
     * @param places of versions in the fit, ascending as the versions; groups with others are left out
     */
    List<Stratum> strata(Map<Integer, Integer> places) {
        joinAll();
        Map<int[][], Stratum> strata = new TreeMap<>(BY_GROUP);
        shapes.forEach((groups, patterns) -> {
            boolean[] taken = new boolean[groups.length];
            for (int g = 0; g < groups.length; g++) {
                taken[g] = groups[g].length > 1 && Arrays.stream(groups[g]).allMatch(places::containsKey);
            }
            int[][] kept = IntStream.range(0, groups.length).filter(g -> taken[g])
                .mapToObj(g -> Arrays.stream(groups[g]).map(places::get).toArray()).toArray(int[][]::new);
            if (kept.length > 0) {
                double weight = alone ? 1 : 2.0 / kept[0].length;
                Stratum stratum = strata.computeIfAbsent(kept, key -> new Stratum(weight, key));
                patterns.forEach((counts, count) ->
                    stratum.add(stratum.pattern(numbers(groups, taken, weight, counts)), count));
            }
        });
        return List.copyOf(strata.values());
    }

    /** A pattern of the groups that are taken. */
    private static double[] numbers(int[][] groups, boolean[] taken, double weight, int... counts) {
        double[] numbers = new double[counts.length];
        int from = 0;
        int to = 0;
        for (int g = 0; g < groups.length; g++) {
            int length = 3 * groups[g].length * (groups[g].length - 1) / 2;
            for (int k = 0; taken[g] && k < length; k++) {
                numbers[to++] = weight * counts[from + k] / (k % 3 == 1 ? 2 : 1);
            }
            from += length;
        }
        return Arrays.copyOf(numbers, to);
    }

    long count() {
        joinAll();
        return shapes.values().stream().flatMap(patterns -> patterns.values().stream()).mapToLong(Long::longValue)
            .sum();
    }
}

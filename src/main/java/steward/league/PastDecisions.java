package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.IntToLongFunction;
import java.util.stream.Collectors;

/**
 * The decisions of earlier runs, and which of their games are over. Where several play, a decision takes six bytes
 * here, so that a league of a million games is resumed at once. Filled first: lineups, then decisions, then games.
 *
 * <p>Not thread-safe.
 */
public final class PastDecisions {

    private static final int NONE = Integer.MIN_VALUE;

    /** Bits of seats: a game has 16 at most. */
    private static final int ALL = 0xFFFF;

    private final int players;
    private final IntToLongFunction seeds;
    private final Map<Integer, Lineup> lineups = new HashMap<>();
    private final Map<List<Integer>, Integer> firsts = new HashMap<>();
    /** By decision: the number of its lineup, {@link #NONE} if it is not there; the complement if it is dropped. */
    private int[] groups = new int[0];
    /** By decision: a bit for each seat of the lowest version in a game that is over. */
    private short[] seats = new short[0];
    /** Bots that have played, in place of seats, in games for one. */
    private final Map<Integer, TreeSet<Integer>> alone = new HashMap<>();
    /** Bots that were paused, in games for one. */
    private final Map<Integer, Set<Integer>> paused = new HashMap<>();
    private int next;

    /**
     * Versions by seat.
     *
     * @param group a number that all lineups of the same versions have in common
     * @param seat  of the lowest version
     */
    private record Lineup(int group, int seat, int... versions) { }

    /** Takes a decision that lacks games. */
    interface Taker {

        /**
         * Takes one.
         *
         * @param group   the versions, ascending
         * @param over    number of its games that are over
         * @param missing the versions by seat of each of the others
         */
        void take(int number, int[] group, boolean dropped, int over, List<int[]> missing);
    }

    /**
     * Decisions of a season, none yet.
     *
     * @param players of a game
     * @param seeds   tells the seed of a decision that is there
     */
    public PastDecisions(int players, IntToLongFunction seeds) {
        this.players = players;
        this.seeds = seeds;
    }

    /** Adds the versions by seat of a lineup, or those of a group, ascending. */
    public void lineup(int number, int... versions) {
        int[] group = Lineups.sorted(versions);
        int seat = 0;
        while (versions.length > 0 && versions[seat] != group[0]) {
            seat++;
        }
        lineups.put(number, new Lineup(firsts.computeIfAbsent(Arrays.stream(group).boxed().toList(), key -> number),
            seat, versions));
    }

    /** Adds a decision. @param lineup number of its group, ascending */
    public void decision(int number, int lineup, boolean dropped) {
        if (number >= groups.length) {
            int before = groups.length;
            groups = Arrays.copyOf(groups, Math.max(number + 1, 2 * before));
            Arrays.fill(groups, before, groups.length, NONE);
            seats = Arrays.copyOf(seats, groups.length);
        }
        groups[number] = dropped ? ~lineup : lineup;
        next = Math.max(next, number + 1);
    }

    /** Says who was paused at a decision. */
    public void paused(int number, int... versions) {
        paused.put(number, Arrays.stream(versions).boxed().collect(Collectors.toSet()));
    }

    /** Adds a game that is over, of a decision that is there. */
    public void game(int number, int lineup) {
        Lineup found = lineups.get(lineup);
        if (players == 1) {
            alone.computeIfAbsent(number, any -> new TreeSet<>()).add(found.versions()[0]);
        } else if (found.group() == lineups.get(lineup(number)).group()) {
            seats[number] |= (short) (1 << found.seat());
        }
    }

    private int lineup(int number) {
        return groups[number] < 0 ? ~groups[number] : groups[number];
    }

    /** The number after that of the last decision. */
    public int next() {
        return next;
    }

    long seed(int number) {
        return seeds.applyAsLong(number);
    }

    /**
     * Tells of all that lack games, in their order.
     *
     * @param roster who may play: where each plays alone, also those that came later
     * @param pauses where each plays alone, those who were paused play if they have been resumed
     * @return how many do not, by group
     */
    Map<List<Integer>, Integer> incomplete(Collection<Integer> roster, PausedBots pauses, Taker taker) {
        Map<Integer, Integer> whole = new LinkedHashMap<>();
        for (int number = 0; number < next; number++) {
            if (groups[number] == NONE) {
                continue;
            }
            int[] group = lineups.get(lineup(number)).versions();
            List<int[]> missing = missing(number, group, roster, pauses);
            if (missing.isEmpty()) {
                whole.merge(lineup(number), 1, Integer::sum);
            } else {
                int over = players == 1 ? alone.getOrDefault(number, new TreeSet<>()).size()
                    : Integer.bitCount(seats[number] & ALL);
                taker.take(number, group, groups[number] < 0, over, missing);
            }
        }
        Map<List<Integer>, Integer> byGroup = new LinkedHashMap<>();
        whole.forEach((lineup, times) -> byGroup.merge(Lineups.group(players, lineups.get(lineup).versions()), times,
            Integer::sum));
        return byGroup;
    }

    /** Returns how many there are of each group, dropped ones included. */
    Map<List<Integer>, Integer> decided() {
        Map<List<Integer>, Integer> decided = new LinkedHashMap<>();
        for (int number = 0; number < next; number++) {
            if (groups[number] != NONE) {
                decided.merge(Lineups.group(players, lineups.get(lineup(number)).versions()), 1, Integer::sum);
            }
        }
        return decided;
    }

    private List<int[]> missing(int number, int[] group, Collection<Integer> roster, PausedBots pauses) {
        List<int[]> missing = new ArrayList<>();
        if (players == 1) {
            TreeSet<Integer> all = new TreeSet<>(roster);
            Arrays.stream(group).forEach(all::add);
            all.removeAll(alone.getOrDefault(number, new TreeSet<>()));
            paused.getOrDefault(number, Set.of()).stream().filter(version -> !pauses.isResumed(version, number))
                .forEach(all::remove);
            all.forEach(version -> missing.add(new int[] {version}));
        } else if ((seats[number] & ALL) != (1 << players) - 1) {
            for (int[] lineup : Lineups.rotations(group)) {
                int seat = 0;
                while (lineup[seat] != group[0]) {
                    seat++;
                }
                if ((seats[number] & 1 << seat) == 0) {
                    missing.add(lineup);
                }
            }
        }
        return missing;
    }

    /** Number of games that are over. */
    long games() {
        long games = alone.values().stream().mapToInt(TreeSet::size).sum();
        for (short each : seats) {
            games += Integer.bitCount(each & ALL);
        }
        return games;
    }
}

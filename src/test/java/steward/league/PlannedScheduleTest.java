package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A plan is kept to: whatever was played before, interrupted or left by versions that are gone, every group of those
 * that play has just so many games at the end, one from each seat for each decision.
 */
class PlannedScheduleTest {

    private static final int TIMES = 3;
    private static final int VERSIONS = 7;

    /** A game of the store. */
    private record Played(int decision, List<Integer> lineup) { }

    private final List<Played> store = new ArrayList<>();

    private Schedule schedule(int players, int lag, List<Integer> roster) {
        EarlierGames earlier = new EarlierGames();
        store.forEach(game -> earlier.add(game.decision(),
            earlier.lineup(game.lineup().stream().mapToInt(version -> version).toArray())));
        Schedule schedule = new Schedule(100, players, lag, earlier);
        schedule.following(decided -> group -> TIMES);
        schedule.play(roster, versions -> Pairing.roundRobin(versions, players));
        return schedule;
    }

    private void store(Schedule.Task task) {
        store.add(new Played(task.decision(), Arrays.stream(task.lineup()).boxed().toList()));
    }

    /** Plays at most so many games, several at a time; those under way at the end are lost, as at a kill. */
    private void play(Schedule schedule, Random random, int most) {
        List<Schedule.Task> underWay = new ArrayList<>();
        for (int played = 0; played < most; played++) {
            Schedule.Task task = underWay.size() < 4 ? schedule.next(Long.MAX_VALUE) : null;
            if (task != null) {
                underWay.add(task);
            } else if (underWay.isEmpty()) {
                return;
            } else {
                Schedule.Task over = underWay.remove(random.nextInt(underWay.size()));
                store(over);
                schedule.over(over);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void everyGroupHasAsManyGamesAsPlannedAndNoMore(int players) {
        for (int seed = 0; seed < 60; seed++) {
            Random random = new Random(seed);
            store.clear();
            List<Integer> roster = List.of();
            for (int epoch = 0; epoch < 6; epoch++) {
                TreeSet<Integer> chosen = new TreeSet<>();
                while (chosen.size() < players + 2) {
                    chosen.add(1 + random.nextInt(VERSIONS));
                }
                roster = List.copyOf(chosen);
                play(schedule(players, 5, roster), random, random.nextInt(60));
            }
            Schedule last = schedule(players, 5, roster);
            long planned = last.planned();
            int before = store.size();
            play(last, random, Integer.MAX_VALUE);
            String what = players + " players, seed " + seed;
            assertEquals(planned, store.size() - before, what);
            assertNull(schedule(players, 5, roster).next(Long.MAX_VALUE), what);
            check(players, roster, what);
        }
    }

    private void check(int players, List<Integer> roster, String what) {
        Map<List<Integer>, Integer> counts = new HashMap<>();
        for (Played game : store) {
            if (roster.containsAll(game.lineup())) {
                counts.merge(game.lineup(), 1, Integer::sum);
            }
        }
        if (players == 1) {                            // all have played each map that any has begun
            assertEquals(1, counts.values().stream().distinct().count(), what + counts);
            return;
        }
        List<List<Integer>> expected = new ArrayList<>();
        for (int[] group : RoundOrder.groups(roster, players, -1)) {
            for (int[] lineup : Lineups.rotations(group)) {
                expected.addAll(Collections.nCopies(1, Arrays.stream(lineup).boxed().toList()));
            }
        }
        assertEquals(expected.size(), counts.size(), what);
        expected.forEach(lineup -> assertEquals(TIMES, counts.get(lineup), what + lineup));
    }
}

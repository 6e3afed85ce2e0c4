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

    private MemoryLeague league;

    private Schedule schedule(int players, int lag, List<Integer> roster) {
        Schedule schedule = league.schedule(lag, roster);
        schedule.following(decided -> group -> TIMES);
        schedule.play(roster, versions -> Pairing.roundRobin(versions, players));
        return schedule;
    }

    private void play(Schedule schedule, Random random, int steps) {
        league.play(schedule, Long.MAX_VALUE, steps, 4, random, task -> league.over(schedule, task));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void everyGroupHasAsManyGamesAsPlannedAndNoMore(int players) {
        for (int seed = 0; seed < 60; seed++) {
            Random random = new Random(seed);
            league = new MemoryLeague(players, 1 + random.nextInt(9));
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
            int before = league.games().size();
            play(last, random, Integer.MAX_VALUE);
            String what = players + " players, seed " + seed;
            assertEquals(planned, league.games().size() - before, what);
            assertNull(league.next(schedule(players, 5, roster), Long.MAX_VALUE), what);
            check(players, roster, what);
        }
    }

    private void check(int players, List<Integer> roster, String what) {
        Map<List<Integer>, Integer> counts = new HashMap<>();
        for (Schedule.Task game : league.games()) {
            List<Integer> lineup = Arrays.stream(game.lineup()).boxed().toList();
            if (roster.containsAll(lineup)) {
                counts.merge(lineup, 1, Integer::sum);
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

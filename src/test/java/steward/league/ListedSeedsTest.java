package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.contest.seeds.Seeds;

/** A schedule over a list of seeds: every group plays each of them once, then it ends. */
class ListedSeedsTest {

    private static final Seeds LIST = Seeds.of(List.of(70L, 5L, 60L));

    private static Schedule schedule(int players, MemoryLeague league, Integer... bots) {
        return schedule(LIST, players, league, bots);
    }

    private static Schedule schedule(Seeds list, int players, MemoryLeague league, Integer... bots) {
        Schedule schedule = league.goOn(new Schedule(list, players, 4, List.of(bots), new PausedBots(0, 4, 0),
            version -> { }));
        schedule.play(List.of(bots), versions -> Pairing.roundRobin(versions, players));
        return schedule;
    }

    /** Of 8, 60, 9 and 5 the second and the last have been played by all groups. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void ofAnotherListEveryGroupPlaysWhatItHasNotPlayed(int players) {
        MemoryLeague league = new MemoryLeague(players);
        Schedule first = schedule(players, league, 1, 2, 3);
        assertEquals(0, first.unlisted());
        league.play(first, 1000, task -> { });
        int before = league.games().size();
        Schedule second = schedule(Seeds.of(List.of(8L, 60L, 9L, 5L)), players, league, 1, 2, 3);
        assertEquals(players == 2 ? 3 : 1, second.unlisted(), "those on 70");
        league.play(second, 1000, task -> { });
        assertTrue(second.isExhausted(true));
        Map<Long, Integer> seeds = new TreeMap<>();
        league.games().subList(before, league.games().size()).forEach(task ->
            seeds.merge(task.seed(), 1, Integer::sum));
        assertEquals(Map.of(8L, before / 3, 9L, before / 3), seeds);
    }

    /** Interrupted after some games, and gone on with; a fourth bot comes later and begins with the first seed. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void everyGroupPlaysTheListOnce(int players) {
        MemoryLeague league = new MemoryLeague(players);
        Schedule first = schedule(players, league, 1, 2, 3);
        for (int k = 0; k < 4; k++) {
            league.over(first, league.next(first, 1000));
        }
        Schedule second = schedule(players, league, 1, 2, 3);
        league.play(second, 1000, task -> { });
        assertTrue(second.isExhausted(true));
        assertFalse(second.isExhausted(false));
        int groups = players == 2 ? 3 : 1;
        int games = players == 1 ? 3 : players;
        assertEquals(groups * games * LIST.count(), league.games().size());
        Set<List<Object>> once = new HashSet<>();
        Map<Long, Integer> seeds = new TreeMap<>();
        for (Schedule.Task each : league.games()) {
            seeds.merge(each.seed(), 1, Integer::sum);
            assertTrue(once.add(List.of(each.seed(), Arrays.toString(each.lineup()))), each.toString());
        }
        assertEquals(Map.of(5L, groups * games, 60L, groups * games, 70L, groups * games), seeds);
        assertEquals(70, league.games().get(0).seed());
        if (players == 2) {
            Schedule third = schedule(players, league, 1, 4);
            assertEquals(70, league.next(third, 1000).seed());
        }
        assertNull(league.next(second, 1000));
    }

    @Test
    void aListThatARuleEndsIsNotPlayedOut() {
        MemoryLeague league = new MemoryLeague(2);
        Schedule schedule = schedule(2, league, 1, 2, 3);
        schedule.until(number -> number == 2);
        league.play(schedule, 1000, task -> { });
        assertEquals(4, league.games().size());
        assertFalse(schedule.isExhausted(true), "two of nine decisions have been made");
        assertFalse(schedule.isExhausted(false));
    }
}

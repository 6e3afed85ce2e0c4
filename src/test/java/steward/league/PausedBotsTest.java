package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiPredicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.league.Schedule.Task;

/** Bots are paused at decisions that neither threads nor interruptions change. */
class PausedBotsTest {

    private static final int MOST = 5;
    private static final int BOTS = 5;
    private static final int GAMES = 400;

    /** Bot 1 always fails, bot 2 fails from decision 20 on, 3 now and then, 4 several times in a row, 5 never. */
    private static boolean fails(int version, Task task) {
        return version == 1 || version == 2 && task.decision() >= 20
            || version == 3 && (task.decision() * 31 + task.lineup()[0]) % 3 == 0
            || version == 4 && task.decision() / 10 % 2 == 1;
    }

    /**
     * A run in which up to so many games are under way and end in any order. It is killed after so many games in all:
     * those under way are lost.
     */
    private static List<Integer> run(int players, int kill, int threads, int lag, MemoryLeague league, Random random) {
        PausedBots pauses = new PausedBots(MOST, lag, league.next());
        List<Task> latestFirst = new ArrayList<>(league.games());
        Collections.reverse(latestFirst);
        for (int version = 1; version <= BOTS; version++) {
            int own = version;
            pauses.use(version, 0, false, taker -> learn(own, latestFirst, taker));
        }
        List<Integer> paused = new ArrayList<>();
        Schedule schedule = league.schedule(lag, List.of(1, 2, 3, 4, 5), pauses, paused::add);
        schedule.play(List.of(1, 2, 3, 4, 5), versions -> Pairing.roundRobin(versions, players));
        List<Task> underWay = new ArrayList<>();
        while (league.games().size() < kill) {
            Task next = underWay.size() < threads ? league.next(schedule, GAMES) : null;
            if (next != null) {
                underWay.add(next);
            } else {
                Task over = underWay.remove(random.nextInt(underWay.size()));
                boolean[] failed = new boolean[players];
                for (int seat = 0; seat < players; seat++) {
                    failed[seat] = fails(over.lineup()[seat], over);
                }
                league.over(schedule, over, failed);
            }
        }
        return paused;
    }

    private static void learn(int version, List<Task> latestFirst, BiPredicate<Integer, Boolean> taker) {
        for (Task task : latestFirst) {
            if (Arrays.stream(task.lineup()).anyMatch(each -> each == version)
                && !taker.test(task.decision(), fails(version, task))) {
                return;
            }
        }
    }

    private static Set<String> names(MemoryLeague league) {
        Set<String> names = new TreeSet<>();
        league.games().forEach(task -> names.add(task.decision() + " " + Arrays.toString(task.lineup())));
        assertEquals(league.games().size(), names.size(), "each once");
        return names;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    @Tag("slow")
    void neitherThreadsNorInterruptionsChangeWhoIsPausedWhen(int players) {
        for (int lag : new int[] {1, 4, 16, 64}) {
            MemoryLeague plain = new MemoryLeague(players);
            List<Integer> paused = run(players, GAMES, 1, lag, plain, new Random(1));
            assertTrue(paused.containsAll(List.of(1, 2)), "lag " + lag + ": " + paused);
            assertEquals(paused.stream().distinct().toList(), paused, "lag " + lag);
            for (int seed = 0; seed < 20; seed++) {
                Random random = new Random(seed);
                MemoryLeague other = new MemoryLeague(players, 1 + random.nextInt(2 * lag));
                List<Integer> kills = random.ints(1 + random.nextInt(4), 0, GAMES).sorted().boxed().toList();
                kills.forEach(kill -> run(players, kill, 1 + random.nextInt(12), lag, other, random));
                run(players, GAMES, 1 + random.nextInt(12), lag, other, random);
                assertEquals(names(plain), names(other), "lag " + lag + ", seed " + seed + ", killed at " + kills);
            }
        }
    }

    @Test
    void aBotThatFailsFromTheBeginningPlaysNoMoreThanTheGamesThatPauseItAndTheRestOfItsDecision() {
        MemoryLeague stored = new MemoryLeague(2);
        run(2, GAMES, 8, 64, stored, new Random(3));
        long games = stored.games().stream().filter(task -> task.lineup()[0] == 1 || task.lineup()[1] == 1).count();
        assertTrue(games >= MOST && games <= MOST + 1, games + " games, expected 5, or 6 with both sides of the last");
    }

    /** The league was killed before the games of a worker that was caught were played again. */
    @Test
    void aPausedBotPlaysNoneOfTheGamesThatWereSetAside() {
        MemoryLeague stored = new MemoryLeague(2);
        run(2, GAMES, 1, 16, stored, new Random(1));
        stored.games().removeIf(task -> task.decision() >= 60 && task.decision() < 120);
        run(2, GAMES, 1, 16, stored, new Random(1));
        assertEquals(List.of(), stored.games().stream().filter(task -> task.decision() >= 60
            && Arrays.stream(task.lineup()).anyMatch(version -> version == 1)).toList());
    }

    @Test
    void aPausedBotIsToldOfOnceHoweverOftenTheLeagueIsEdited() {
        MemoryLeague league = new MemoryLeague(2);
        List<Integer> told = new ArrayList<>();
        Schedule schedule = league.schedule(1, List.of(1, 2, 3), new PausedBots(2, 1, 0), told::add);
        for (int edit = 0; edit < 3; edit++) {
            schedule.play(List.of(1, 2, 3), versions -> Pairing.roundRobin(versions, 2));
            for (int k = 0; k < 6; k++) {
                Task task = league.next(schedule, Long.MAX_VALUE);
                league.over(schedule, task, task.lineup()[0] == 1, task.lineup()[1] == 1);
            }
        }
        assertEquals(List.of(1), told);
    }

    @Test
    void aBotThatIsResumedPlaysAgainUntilItHasFailedAsOften() {
        PausedBots pauses = new PausedBots(MOST, 4, 0);
        for (int decision = 0; decision < MOST; decision++) {
            pauses.over(decision, 7, true);
        }
        assertEquals(PausedBots.State.PAUSED, pauses.at(7, MOST));
        pauses.use(7, MOST, false, taker -> { });
        assertEquals(PausedBots.State.PLAYS, pauses.at(7, MOST));
        for (int decision = MOST; decision < 2 * MOST; decision++) {
            pauses.over(decision, 7, true);
        }
        assertEquals(PausedBots.State.PAUSED, pauses.at(7, 2 * MOST));
    }
}

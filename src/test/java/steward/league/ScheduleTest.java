package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.TestSize;

/** The order of games: the same however many threads play them and wherever a run is interrupted. */
@Execution(ExecutionMode.CONCURRENT)
class ScheduleTest {

    private static final int GAMES = 60;

    private static Schedule schedule(int players, int lag, Integer... bots) {
        Schedule schedule = new MemoryLeague(players).schedule(lag, List.of(bots));
        schedule.play(List.of(bots), versions -> Pairing.roundRobin(versions, players));
        return schedule;
    }

    private static String name(Schedule.Task task) {
        return task.decision() + " " + task.seed() + " " + Arrays.toString(task.lineup());
    }

    private static List<String> straight(int players, Integer... bots) {
        Schedule schedule = schedule(players, 8, bots);
        MemoryLeague league = new MemoryLeague(players);
        List<String> games = new ArrayList<>();
        league.play(schedule, GAMES, task -> games.add(name(task)));
        return games;
    }

    @Test
    void everyPairMeetsEquallyOftenFromBothSides() {
        List<String> games = straight(2, 1, 2, 3);
        assertEquals(List.of("0 100 [1, 2]", "0 100 [2, 1]", "1 101 [1, 3]", "1 101 [3, 1]", "2 102 [2, 3]",
            "2 102 [3, 2]", "3 103 [1, 2]"), games.subList(0, 7));
        Map<String, Integer> counts = new HashMap<>();
        games.forEach(game -> counts.merge(game.replaceAll(".*\\[", ""), 1, Integer::sum));
        assertEquals(Map.of("1, 2]", 10, "2, 1]", 10, "1, 3]", 10, "3, 1]", 10, "2, 3]", 10, "3, 2]", 10), counts);
    }

    /** By the circle method nobody is ever more than a game ahead; with three and four players by two at most. */
    @ParameterizedTest
    @CsvSource({"2, 25, 1", "3, 12, 2", "4, 10, 2"})
    void everyBeginningOfAScheduleIsEven(int players, int most, int ahead) {
        for (int bots = players; bots <= most; bots++) {
            int[] games = new int[bots];
            List<int[]> groups = RoundOrder.groups(IntStream.range(0, bots).boxed().toList(), players, -1);
            Set<List<Integer>> all = new HashSet<>();
            for (int[] group : groups) {
                all.add(Arrays.stream(group).boxed().toList());
                IntStream.of(group).forEach(bot -> games[bot]++);
                int apart = IntStream.of(games).max().orElseThrow() - IntStream.of(games).min().orElseThrow();
                assertTrue(apart <= ahead, players + " players, " + bots + " bots: " + Arrays.toString(games));
            }
            assertEquals(groups.size(), all.size(), "each group once");
            assertEquals(1, IntStream.of(games).distinct().count(), "a round is even");
        }
    }

    @Test
    void inAGauntletTheOthersTakeTurns() {
        List<int[]> groups = RoundOrder.groups(List.of(1, 2, 3, 4), 2, 3);
        assertEquals(List.of("[1, 3]", "[2, 3]", "[3, 4]"), groups.stream().map(Arrays::toString).sorted().toList());
        assertEquals(3, RoundOrder.groups(List.of(1, 2, 3, 4), 3, 1).size());
        assertThrows(IllegalArgumentException.class,
            () -> RoundOrder.groups(IntStream.range(0, 200).boxed().toList(), 4, -1));
    }

    /**
     * 20 games of each lineup after the first are repeats: bots 1 and 2, whose games are all alike, then play no more.
     */
    @Test
    void groupsThatOnlyRepeatGamesAreNotAskedForMore() {
        MemoryLeague league = new MemoryLeague(2);
        Schedule schedule = league.schedule(1, List.of());
        schedule.play(List.of(1, 2, 3), versions -> Pairing.roundRobin(versions, 2));
        Map<String, Integer> counts = new HashMap<>();
        league.play(schedule, 300, task -> {
            boolean alike = Arrays.stream(task.lineup()).sum() == 3;
            schedule.repeated().add(task.decision(), alike ? 7 + task.lineup()[0] : task.seed(), task.lineup());
            counts.merge(Math.min(task.lineup()[0], task.lineup()[1]) + " " + Math.max(task.lineup()[0],
                task.lineup()[1]), 1, Integer::sum);
        });
        assertEquals(22, counts.get("1 2"), "two that are new and twenty that repeat them");
        assertEquals(278, counts.get("1 3") + counts.get("2 3"));
        assertFalse(schedule.isExhausted(false));
    }

    @Test
    void aScheduleOfNothingButRepeatsEnds() {
        for (int players = 1; players <= 3; players++) {
            MemoryLeague league = new MemoryLeague(players);
            Schedule schedule = league.schedule(3, List.of());
            schedule.play(List.of(1, 2, 3), versions -> Pairing.roundRobin(versions, 3));
            if (players == 2) {
                schedule.play(List.of(1, 2, 3), versions -> Pairing.roundRobin(versions, 2));
            }
            league.play(schedule, 1000, task -> schedule.repeated().add(task.decision(), 5, task.lineup()));
            assertTrue(league.games().size() < 100, players + " players, " + league.games().size() + " games");
            assertTrue(schedule.isExhausted(false));
        }
    }

    @Test
    void threePlayersTakeAllSeatsAndOnePlayerTakesEveryMap() {
        assertEquals(List.of("0 100 [1, 2, 3]", "0 100 [2, 3, 1]", "0 100 [3, 1, 2]", "1 101 [1, 2, 4]"),
            straight(3, 1, 2, 3, 4).subList(0, 4));
        assertEquals(List.of("0 100 [5]", "0 100 [6]", "1 101 [5]", "1 101 [6]"), straight(1, 5, 6).subList(0, 4));
    }

    @Test
    void theGauntletsBotIsInEveryGame() {
        MemoryLeague league = new MemoryLeague(2);
        Schedule schedule = league.schedule(8, List.of());
        schedule.play(List.of(1, 2, 3), versions -> Pairing.gauntlet(versions, 2, 2));
        league.play(schedule, GAMES, task ->
            assertTrue(Arrays.stream(task.lineup()).anyMatch(version -> version == 2), name(task)));
        assertEquals(GAMES, league.games().size());
    }

    /** One taker takes all games, the other none of bot 3: the games are the same, no decision is made too early. */
    @Test
    void whoCannotTakeSomeGamesTakesThoseBehindThem() {
        long seed = 23;
        SplittableRandom random = new SplittableRandom(seed);
        int ahead = 0;
        for (int round = 0; round < 200; round++) {
            int players = 2 + random.nextInt(2);
            int most = GAMES - random.nextInt(12);
            int patience = random.nextInt(8);
            int lag = 1 + random.nextInt(8);
            Schedule schedule = schedule(players, lag, 1, 2, 3, 4);
            MemoryLeague league = new MemoryLeague(players);
            List<Schedule.Task> open = new ArrayList<>();
            List<String> games = new ArrayList<>();
            TreeSet<Integer> over = new TreeSet<>();
            int[] count = new int[1000];
            while (games.size() < most || !open.isEmpty()) {
                boolean all = random.nextInt(1 + patience) == 0;
                league.decide(schedule, most, 1 + random.nextInt(2 * lag * players));
                Schedule.Task task = schedule.next(most, next -> all
                    || Arrays.stream(next.lineup()).noneMatch(version -> version == 3));
                if (task != null) {
                    for (int before = 0; before <= task.decision() - lag; before++) {
                        assertTrue(over.contains(before), () -> "seed " + seed + ": " + name(task));
                    }
                    ahead += !games.isEmpty() && task.decision() < Integer.parseInt(games.get(games.size() - 1)
                        .split(" ")[0]) ? 1 : 0;
                    open.add(task);
                    games.add(name(task));
                }
                if (task == null ? !open.isEmpty() : open.size() > random.nextInt(6)) {
                    Schedule.Task ended = open.remove(random.nextInt(open.size()));
                    schedule.over(ended);
                    if (++count[ended.decision()] == players) {
                        over.add(ended.decision());
                    }
                }
                assertEquals(games.size() < most, schedule.games() < most);
            }
            Collections.sort(games);
            List<String> expected = new ArrayList<>(straight(players, 1, 2, 3, 4).subList(0, most));
            Collections.sort(expected);
            assertEquals(expected, games, () -> "seed " + seed);
        }
        assertTrue(ahead > 0, "games were taken out of order");
    }

    /** Random numbers of threads, games that end in random order, and interruptions that lose what is under way. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    @Tag("sized")
    void threadsAndInterruptionsDoNotMatter(int players) {
        Integer[] bots = {1, 2, 3, 4};
        TreeSet<String> expected = new TreeSet<>(straight(players, bots));
        assertEquals(GAMES, expected.size());
        for (long seed = 0; seed < TestSize.of(60, 600); seed++) {
            assertEquals(expected, interrupted(players, bots, new SplittableRandom(seed)), "seed " + seed);
        }
    }

    private static TreeSet<String> interrupted(int players, Integer[] bots, SplittableRandom random) {
        MemoryLeague league = new MemoryLeague(players, 1 + random.nextInt(12));
        while (league.games().size() < GAMES) {
            Schedule schedule = league.schedule(4, List.of(bots));
            schedule.play(List.of(bots), versions -> Pairing.roundRobin(versions, players));
            int threads = 1 + random.nextInt(5);
            league.play(schedule, GAMES, random.nextInt(GAMES), threads, random, task -> league.over(schedule, task));
        }
        TreeSet<String> games = new TreeSet<>();
        league.games().forEach(task -> games.add(name(task)));
        assertEquals(league.games().size(), games.size(), "each once");
        return games;
    }

    /**
     * Leagues with a long past: decisions that are whole, that lack games or are not there, of bots that play no more,
     * and bots that change while it goes on. The games played are those of a plain walk through all decisions.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    @Tag("sized")
    void aResumedScheduleIsThatOfAPlainWalkThroughAllDecisions(int players) {
        for (long seed = 0; seed < TestSize.of(80, 1000); seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            List<Integer> before = bots(random, players);
            MemoryLeague league = new MemoryLeague(players);
            PlainSchedule plain = new PlainSchedule(players, 1 + random.nextInt(20));
            List<int[]> past = new ArrayList<>();
            for (int decision = random.nextInt(3); decision < 40; decision += random.nextInt(8) == 0 ? 2 : 1) {
                past.addAll(games(decision, before, players, random));
            }
            for (int k = past.size() - 1; k > 0; k--) {
                Collections.swap(past, k, random.nextInt(k + 1));
            }
            for (int[] game : past) {
                int[] lineup = Arrays.copyOfRange(game, 1, game.length);
                league.add(new Schedule.Task(game[0], 100 + game[0], lineup));
                plain.stored(game[0], lineup);
            }
            Schedule schedule = null;
            String message = players + " players, seed " + seed;
            for (int change = 0; change < 3; change++) {
                List<Integer> now = bots(random, players);
                schedule = schedule == null ? league.schedule(plain.lag(), now) : schedule;
                schedule.play(now, versions -> Pairing.roundRobin(versions, players));
                plain.play(now);
                int most = random.nextInt(4) == 0 ? random.nextInt(150) : Integer.MAX_VALUE;
                compare(league, schedule, plain, most, random, message);
            }
        }
    }

    private static List<Integer> bots(SplittableRandom random, int players) {
        List<Integer> bots = new ArrayList<>();
        for (int bot = 1; bot <= 7; bot++) {
            if (random.nextBoolean() || 7 - bot < players - bots.size()) {
                bots.add(bot);
            }
        }
        return bots;
    }

    /** Some of the games of a decision, mostly all: its number, then the versions by seat. */
    private static List<int[]> games(int decision, List<Integer> bots, int players, SplittableRandom random) {
        List<Integer> chosen = new ArrayList<>(bots);
        while (chosen.size() > players && players > 1) {
            chosen.remove(random.nextInt(chosen.size()));
        }
        int[] versions = chosen.stream().mapToInt(bot -> bot).toArray();
        List<int[]> lineups = players == 1 ? chosen.stream().map(bot -> new int[] {bot}).toList()
            : Lineups.rotations(versions);
        boolean whole = random.nextInt(5) > 0;
        List<int[]> games = new ArrayList<>();
        for (int[] lineup : lineups) {
            if (whole || random.nextBoolean()) {
                int[] game = new int[1 + lineup.length];
                game[0] = decision;
                System.arraycopy(lineup, 0, game, 1, lineup.length);
                games.add(game);
            }
        }
        return games;
    }

    private static void compare(MemoryLeague league, Schedule schedule, PlainSchedule plain, int most,
                                SplittableRandom random, String message) {
        List<Schedule.Task> open = new ArrayList<>();
        for (int k = 0; k < 60; k++) {
            if (open.size() < 4 && random.nextInt(3) > 0) {
                Set<String> expected = plain.next(most);
                Schedule.Task task = league.next(schedule, most);
                assertEquals(expected.isEmpty(), task == null, () -> message + expected);
                if (task != null) {
                    assertTrue(expected.contains(task.decision() + " " + Arrays.toString(task.lineup())),
                        () -> message + ": " + name(task) + ", expected one of " + expected);
                    plain.begin(task);
                    open.add(task);
                }
                assertEquals(plain.games(), schedule.games(), message);
            } else if (!open.isEmpty()) {
                end(schedule, plain, open.remove(random.nextInt(open.size())), random.nextInt(6) == 0);
            }
        }
        open.forEach(task -> end(schedule, plain, task, false));
    }

    private static void end(Schedule schedule, PlainSchedule plain, Schedule.Task task, boolean dropped) {
        if (dropped) {
            schedule.dropped(task);
            plain.dropped(task);
        } else {
            schedule.over(task);
            plain.over(task);
        }
    }

    /** Bot 2 goes when three decisions wait, one of them with a game under way, and comes back. */
    @Test
    void decisionsWhoseBotsAreGoneAreDroppedAndStayAsTheyAre() {
        MemoryLeague league = new MemoryLeague(2, 6);
        Schedule schedule = league.schedule(8, List.of());
        schedule.play(List.of(1, 2, 3), versions -> Pairing.roundRobin(versions, 2));
        Schedule.Task begun = league.next(schedule, 100);
        assertEquals("0 100 [1, 2]", name(begun));
        schedule.play(List.of(1, 3), versions -> Pairing.roundRobin(versions, 2));
        Decision.News news = schedule.decide(100, 1);
        assertEquals(Map.of(0, true, 2, true), news.dropped());
        assertEquals(List.of(), news.made());
        schedule.dropped(begun);
        List<String> games = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            Schedule.Task task = league.next(schedule, 100);
            games.add(name(task));
            schedule.over(task);
        }
        assertEquals(List.of("1 101 [1, 3]", "1 101 [3, 1]", "3 103 [1, 3]", "3 103 [3, 1]"), games);
        schedule.play(List.of(1, 2, 3), versions -> Pairing.roundRobin(versions, 2));
        assertEquals(Map.of(0, false, 2, false), schedule.decide(100, 1).dropped(), "their games are played");
        assertEquals(4, schedule.waiting(100).stream().filter(task -> task.decision() % 2 == 0 && task.decision() < 4)
            .count());
    }
}

package steward.league.pairing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.league.MemoryLeague;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.rating.Ratings;
import steward.league.rating.Results;
import steward.match.TestSize;

/** Who plays whom, and when it ends, follows from results alone: not from threads and not from interruptions. */
@Execution(ExecutionMode.CONCURRENT)
class AdaptivePairingTest {

    private static final int LAG = 4;
    private static final List<Integer> BOTS = List.of(1, 2, 3, 4, 5);
    private static final StopRule RULE = new StopRule(Double.NaN, true, 30);

    /** A league that is played in memory. */
    private static final class Play {

        private final Season season;
        private final MemoryLeague league;
        private final Schedule schedule;
        private final KnownResults known;
        private final LeagueEnd end;

        Play(int players, MemoryLeague league, Iterable<Schedule.Task> stored) {
            this.league = league;
            season = Season.of("crowd", "key", "limits", "rules", players, false);
            known = new KnownResults(season, new Results(season));
            stored.forEach(this::know);
            schedule = league.schedule(LAG, BOTS);
            end = new LeagueEnd(RULE, known, LAG, schedule::active, (one, other) -> true);
            schedule.until(end);
            play(BOTS);
        }

        void play(List<Integer> bots) {
            schedule.play(bots, versions -> new AdaptivePairing(versions, season.players(), LAG, RULE,
                before -> Ratings.of(known.before(before), versions)));
        }

        void know(Schedule.Task task) {
            known.add(task.decision(), task.seed(), task.lineup(), score(task), 0, ranks(task));
        }

        /** Plays until it ends by itself, or at so many games. */
        void play(long most, Consumer<Schedule.Task> game) {
            league.play(schedule, most, task -> {
                game.accept(task);
                know(task);
            });
        }
    }

    /** Bots 2 and 3 are close, the others far from each other; the same game always ends alike. */
    private static double[] strengths(Schedule.Task task) {
        SplittableRandom random = new SplittableRandom(task.seed() * 31 + Arrays.hashCode(task.lineup()));
        double[] known = {0, 5, 3, 2.6, 1.2, 0};
        return Arrays.stream(task.lineup()).mapToDouble(bot -> known[bot] + 3 * random.nextDouble()).toArray();
    }

    private static int[] ranks(Schedule.Task task) {
        double[] strengths = strengths(task);
        return Arrays.stream(strengths)
            .mapToInt(own -> (int) Arrays.stream(strengths).filter(other -> other > own).count()).toArray();
    }

    private static double score(Schedule.Task task) {
        return strengths(task)[0];
    }

    private static String name(Schedule.Task task) {
        return task.decision() + " " + task.seed() + " " + Arrays.toString(task.lineup());
    }

    private static TreeSet<String> straight(int players) {
        Play play = new Play(players, new MemoryLeague(players), List.of());
        TreeSet<String> games = new TreeSet<>();
        play.play(20_000, task -> games.add(name(task)));
        assertTrue(games.size() < 20_000, "it has ended by itself");
        List<Integer> order = play.end.met().order();
        assertEquals(List.of(1, 2, 3, 4, 5), order);
        assertTrue(!RULE.orders(play.end.met(), order, (one, other) -> true).contains(StopRule.Order.OPEN));
        return games;
    }

    @Test
    void aBotThatComesAfterTheEndIsRanked() {
        Play play = new Play(2, new MemoryLeague(2), List.of());
        Map<Integer, Integer> games = new HashMap<>();
        for (int bots = 4; bots <= 5; bots++) {
            play.play(BOTS.subList(0, bots));
            play.play(20_000, task -> Arrays.stream(task.lineup()).forEach(bot -> games.merge(bot, 1, Integer::sum)));
            assertEquals(BOTS.subList(0, bots), play.end.met().order());
        }
        assertTrue(games.get(5) > 20, games::toString);
    }

    /** The first four rounds of two, of 10 and of 25 bots: nobody is more than two games ahead. */
    @ParameterizedTest
    @ValueSource(ints = {10, 25})
    void everyBeginningOfTheFirstRoundsIsEven(int bots) {
        List<Integer> versions = IntStream.range(0, bots).boxed().toList();
        AdaptivePairing pairing = new AdaptivePairing(versions, 2, LAG, RULE, before -> null);
        int[] games = new int[bots];
        for (int decision = 0; decision < AdaptivePairing.FIRST * bots * (bots - 1) / 2; decision++) {
            int[] group = pairing.choose(any -> true);
            pairing.made(1, group);
            games[group[0]]++;
            games[group[1]]++;
            int ahead = IntStream.of(games).max().orElseThrow() - IntStream.of(games).min().orElseThrow();
            assertTrue(ahead <= 2, decision + ": " + Arrays.toString(games));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    @Tag("slow")
    @Tag("sized")
    void threadsAndInterruptionsDoNotMatter(int players) {
        TreeSet<String> expected = straight(players);
        for (long seed = 0; seed < TestSize.of(3, 30); seed++) {
            assertEquals(expected, interrupted(players, new SplittableRandom(seed)), "seed " + seed);
        }
    }

    private static TreeSet<String> interrupted(int players, SplittableRandom random) {
        Map<String, Schedule.Task> stored = new HashMap<>();
        MemoryLeague league = new MemoryLeague(players, 1 + random.nextInt(2 * LAG * players));
        boolean ended = false;
        while (!ended) {
            Play play = new Play(players, league, stored.values());
            int threads = 1 + random.nextInt(5);
            ended = league.play(play.schedule, 20_000, random.nextInt(3000), threads, random, over -> {
                play.know(over);
                league.over(play.schedule, over);
                stored.put(name(over), over);
            });
        }
        return new TreeSet<>(stored.keySet());
    }

    @Test
    void thoseInDoubtPlayMostAndNobodyIsForgotten() {
        Map<Integer, Integer> games = new HashMap<>();
        Play play = new Play(2, new MemoryLeague(2), List.of());
        play.play(4000, task -> Arrays.stream(task.lineup()).forEach(bot -> games.merge(bot, 1, Integer::sum)));
        double uniform = games.values().stream().mapToDouble(each -> each).average().orElseThrow();
        for (int bot : BOTS) {
            assertTrue(games.get(bot) >= 0.19 * uniform, games::toString);
        }
        assertTrue(games.get(2) > 1.2 * uniform && games.get(3) > 1.2 * uniform, games::toString);
    }

    @Test
    void looksFollowFromTheNumberAlone() {
        int looks = 0;
        int last = -1;
        for (int decision = 0; decision < 100_000; decision++) {
            int look = Looks.of(decision);
            assertTrue(look <= decision && look >= last && decision - look <= decision / 31, "decision " + decision);
            assertEquals(look == decision, Looks.isLook(decision));
            looks += Looks.isLook(decision) ? 1 : 0;
            last = look;
        }
        assertTrue(looks < 700, looks + " looks");
    }
}

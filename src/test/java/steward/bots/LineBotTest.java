package steward.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.Bot;
import steward.game.GameSetup;
import steward.match.MatchResult;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.replay.Recorded;

/** The bundled bots of every game but the pod race: no faults, each better than the one below, and no memory. */
@Execution(ExecutionMode.CONCURRENT)
class LineBotTest {

    static Set<String> scenes() {
        return BundledBots.LADDERS.keySet();
    }

    /**
     * Seeds from every side, the others being the bot below. Of what luck would give, the share of wins that is asked
     * for is half more; docs/series.md has the shares of hundreds of games.
     */
    @ParameterizedTest
    @Tag("slow")
    @Tag("sized")
    @MethodSource("scenes")
    void theStrongestWinsAgainstTheWeakest(String scene) {
        List<Supplier<LineBot>> ladder = BundledBots.LADDERS.get(scene);
        int players = TestScenes.open(scene).create(1).players();
        int games = TestSize.of(6, 24);
        double won = 0;
        for (int game = 0; game < games; game++) {
            won += players == 1 ? quicker(scene, game, ladder) : wins(scene, game, players, ladder);
        }
        assertTrue(won >= games * 2 / 3, "won " + won + " of " + games);
    }

    private static int wins(String scene, int game, int players, List<Supplier<LineBot>> ladder) {
        List<Bot> bots = new ArrayList<>();
        for (int player = 0; player < players; player++) {
            bots.add(BundledBots.of(ladder.get(player == game % players ? ladder.size() - 1 : 0).get()));
        }
        MatchResult result = Recorded.of(TestScenes.open(scene), game / players, bots).result();
        assertFalse(result.anyFault(), result.toString());
        return result.winner() == game % players ? 1 : 0;
    }

    private static int quicker(String scene, int seed, List<Supplier<LineBot>> ladder) {
        return time(scene, seed, ladder.get(ladder.size() - 1)) < time(scene, seed, ladder.get(0)) ? 1 : 0;
    }

    private static double time(String scene, long seed, Supplier<LineBot> bot) {
        Recorded match = Recorded.of(TestScenes.open(scene), seed, List.of(BundledBots.of(bot.get())));
        assertEquals(Recorded.whole(match.result().turns()), match.verify());
        assertEquals("finished after 3 laps", match.result().ending(), "seed " + seed);
        return match.result().players().get(0).score();
    }

    @Test
    @Tag("slow")
    void thePlainBotOfTheSearchRaceFinishesEveryOfficialMap() {
        for (long seed = 0; seed < 50; seed++) {
            assertTrue(time("search-race", seed, BundledBots.LADDERS.get("search-race").get(0)) < 600);
        }
    }

    /** A debugger that is fed the frames from some turn on sees the same bot. */
    @ParameterizedTest
    @Tag("slow")
    @MethodSource("scenes")
    void anAnswerFollowsFromTheSetupAndTheTurnAlone(String scene) {
        GameSetup setup = TestScenes.open(scene);
        for (Supplier<LineBot> step : BundledBots.LADDERS.get(scene)) {
            List<String> lines = new ArrayList<>();
            List<Bot> bots = new ArrayList<>(List.of(BundledBots.of(step.get(), lines::add)));
            while (bots.size() < setup.create(1).players()) {
                bots.add(BundledBots.of(BundledBots.LADDERS.get(scene).get(0).get()));
            }
            MatchResult result = Recorded.of(setup, 2, bots).result();
            assertFalse(result.anyFault(), result.toString());
            assertTrue(lines.size() > 6, "lines: " + lines.size());
            for (int k = 1; k + 2 < lines.size(); k += 2 * Math.max(1, lines.size() / 20)) {
                LineBot fresh = step.get();
                fresh.answer(lines.get(0));
                assertEquals(lines.get(k + 1), fresh.answer(lines.get(k)));
            }
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void anotherGameIsRefused(String scene) {
        for (Supplier<LineBot> step : BundledBots.LADDERS.get(scene)) {
            assertEquals("this bot plays " + scene + ", not pod-race", assertThrows(IllegalArgumentException.class,
                () -> step.get().answer("{\"type\":\"setup\",\"game\":\"pod-race\"}")).getMessage());
        }
    }
}

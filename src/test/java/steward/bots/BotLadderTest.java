package steward.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.FieldSource;
import steward.bot.Bot;
import steward.game.GameSetup;
import steward.match.MatchResult;
import steward.match.TestSize;

/** The ladder of bundled bots: each step beats the one below without a fault, and needs no more than it is sent now. */
@Execution(ExecutionMode.CONCURRENT)
class BotLadderTest {

    /** From the weakest to the strongest. */
    private static final List<Supplier<PodBot>> LADDER =
        List.of(Racer::new, Regular::new, Contender::new, Veteran::new);

    private static final List<String> SCENES =
        List.of("mad-pod-racing", "mad-pod-racing-silver", "walled-race", "duel");

    /** Seeds from both sides on all scenes together: a step shall win 0.75 of its games. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void everyStepBeatsTheOneBelow() {
        int seeds = TestSize.of(1, 3);
        for (int step = 1; step < LADDER.size(); step++) {
            int won = 0;
            for (String name : SCENES) {
                won += wins(name, seeds, step);
            }
            int games = 2 * seeds * SCENES.size();
            assertTrue(won >= 0.75 * games, "step " + step + " won " + won + " of " + games);
        }
    }

    /**
     * Equal bots would win 27 of 40 games, 20 seeds from both sides, once in 50 times. In 200 games on each of these
     * scenes, other seeds, every step won 0.84 or more.
     */
    @ParameterizedTest
    @Tag("campaign")
    @FieldSource("SCENES")
    void everyStepBeatsTheOneBelowOnEveryScene(String name) {
        for (int step = 1; step < LADDER.size(); step++) {
            int won = wins(name, 20, step);
            assertTrue(won >= 27, "step " + step + " won " + won + " of 40 on " + name);
        }
    }

    private static int wins(String name, int seeds, int step) {
        GameSetup scene = BundledBotMatches.scene(name);
        int won = 0;
        for (long seed = 1; seed <= seeds; seed++) {
            won += wins(scene, seed, step, step - 1, 0) + wins(scene, seed, step - 1, step, 1);
        }
        return won;
    }

    private static int wins(GameSetup scene, long seed, int first, int second, int player) {
        MatchResult result = BundledBotMatches.play(scene, seed, LADDER.get(first).get(), LADDER.get(second).get());
        assertFalse(result.anyFault(), result.toString());
        return result.winner() == player ? 1 : 0;
    }

    @ParameterizedTest
    @CsvSource({"1, 2", "3, 2", "8, 2", "2, 4", "8, 8"})
    @Tag("slow")
    void everyStepPlaysAnyNumberOfPodsAndPlayers(int pods, int players) {
        for (int[] steps : new int[][] {{3, 0}, {2, 1}}) {
            PodBot[] bots = IntStream.range(0, players).mapToObj(player -> LADDER.get(steps[player % 2]).get())
                .toArray(PodBot[]::new);
            MatchResult result = BundledBotMatches.play(BundledBotMatches.crowd(pods, players), 5, bots);
            assertFalse(result.anyFault(), result.toString());
            assertEquals(players, result.players().size());
        }
    }

    /** A debugger that is fed the frames from some turn on sees the same bot. */
    @Test
    void anAnswerFollowsFromTheSetupAndTheTurnAlone() {
        for (Supplier<PodBot> step : LADDER) {
            MatchResult result = BundledBotMatches.play(BundledBotMatches.scene("duel"), 1, new Doubled(step),
                BundledBotMatches.asBot(new Racer()));
            assertFalse(result.anyFault(), result.toString());
        }
    }

    /** Has every turn answered also by a new bot that has seen nothing before. */
    private static final class Doubled implements Bot {

        private final Supplier<PodBot> step;
        private final PodBot bot;
        private String setup;

        Doubled(Supplier<PodBot> step) {
            this.step = step;
            bot = step.get();
        }

        @Override
        public void setup(String line) {
            setup = line;
            bot.setup(line);
        }

        @Override
        public String turn(String line) {
            PodBot fresh = step.get();
            fresh.setup(setup);
            String answer = bot.turn(line);
            assertEquals(answer, fresh.turn(line));
            return answer;
        }
    }
}

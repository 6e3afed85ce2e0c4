package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameSetup;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.match.TimeControl;

/**
 * Bots as contestants write them, in three languages, each in matches against a bot that speaks JSON: the upper leagues
 * with two pods, the lower ones with one, from both sides.
 */
@Execution(ExecutionMode.CONCURRENT)
@Tag("process")
@Timeout(120)
class ContestantBotsTest {

    /** Each side once, each in another scene. */
    private static final int FEW = 2;
    private static final int MANY = 20;
    private static final List<String> SCENES = List.of("duel", "mad-pod-racing-silver", "mad-pod-racing", "duel");

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"pilot.cpp", "Pilot.java", "pilot.py"})
    @Tag("sized")
    void playWithoutAFault(String source, TestReporter report) throws IOException, InterruptedException {
        play(report, source, TestSize.of(FEW, MANY));
    }

    private void play(TestReporter report, String name, int matches) throws IOException, InterruptedException {
        List<String> command = new ContestantPrograms("codingame", folder).command(name).orElse(List.of());
        assumeTrue(!command.isEmpty(), "skipped: the language of " + name + " is not here");
        int wins = 0;
        int turns = 0;
        for (int match = 0; match < matches; match++) {
            GameSetup setup = TestScenes.open(SCENES.get((match + match / 4) % SCENES.size()));
            int side = match % 2;
            Seat bot = TextMatches.program(name, command);
            Seat[] seats = side == 0 ? new Seat[] {bot, TextMatches.racer()}
                : new Seat[] {TextMatches.racer(), bot};
            TextMatches played = TextMatches.play(setup, match, TimeControl.UNLIMITED, seats);
            for (int player = 0; player < seats.length; player++) {
                assertNull(played.player(player).fault(), setup.scene().name() + ", seed " + match);
                assertEquals(0, played.player(player).earlyTurns());
            }
            assertTrue(played.player(side).score() > 0, "it found a checkpoint: " + played.result());
            if (match % 4 == 0) {
                assertNull(played.verify().difference());
            }
            wins += played.result().winner() == side ? 1 : 0;
            turns += played.result().turns();
        }
        report.publishEntry(name + ": " + matches + " matches without a fault, " + wins + " won, " + turns + " turns");
    }
}

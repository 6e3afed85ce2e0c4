package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TimeControl;

/**
 * Three bots of a game as contestants write them, in three languages, on the site's lines with seats rotated; those
 * whose language is not there leave their seat to the one in Java. More games: {@code gradle campaigns
 * -Psteward.games=100}. Bots of the pod race: {@link ContestantBotsTest}.
 */
@Tag("process")
class ContestantsTest {

    @TempDir
    private Path folder;

    /** A game with its number of players, and its bots in Java, Python and C++. */
    enum Contest {
        FANTASTIC_BITS("fantastic-bits", 2, "Caller.java", "thrower.py", "pusher.cpp"),
        MEAN_MAX("mean-max", 3, "Ram.java", "harvester.py", "tar.cpp"),
        POKER_CHIP_RACE("poker-chip-race", 3, "Chaser.java", "coward.py", "centre.cpp");

        private final String scene;
        private final int players;
        private final String[] sources;

        Contest(String scene, int players, String... sources) {
            this.scene = scene;
            this.players = players;
            this.sources = sources;
        }
    }

    @Test
    void theyPlayWithoutAFault(TestReporter report) throws IOException, InterruptedException {
        play(report, Contest.FANTASTIC_BITS, 1);
    }

    @ParameterizedTest
    @EnumSource
    @Tag("campaign")
    void inMoreGamesTheyPlayWithoutAFault(Contest contest, TestReporter report)
            throws IOException, InterruptedException {
        play(report, contest, Integer.getInteger("steward.games", 6));
    }

    private void play(TestReporter report, Contest contest, int matches) throws IOException, InterruptedException {
        ContestantPrograms programs = new ContestantPrograms(contest.scene.replace("-", ""), folder);
        List<List<String>> commands = new ArrayList<>();
        StringBuilder languages = new StringBuilder();
        for (String source : contest.sources) {
            Optional<List<String>> command = programs.command(source);
            assumeTrue(command.isPresent() || !commands.isEmpty(), "skipped: this Java has no compiler");
            commands.add(command.orElseGet(() -> commands.get(0)));
            languages.append(", ").append(source).append(' ').append(command.isPresent());
        }
        int[] won = new int[3];
        int turns = 0;
        for (int match = 0; match < matches; match++) {
            int[] bots = {match % 3, (match + 1) % 3, (match + 2) % 3};
            bots[1] = contest.players == 2 ? (match + 1 + match / 3 % 2) % 3 : bots[1];
            Seat[] seats = new Seat[contest.players];
            for (int seat = 0; seat < seats.length; seat++) {
                seats[seat] = TextMatches.program("bot " + bots[seat], commands.get(bots[seat]));
            }
            TextMatches played = TextMatches.play(
                TestScenes.changed(contest.scene, "\"players\": " + (contest == Contest.POKER_CHIP_RACE ? 2
                    : contest.players), "\"players\": " + contest.players), match, TimeControl.UNLIMITED, seats);
            for (int seat = 0; seat < seats.length; seat++) {
                assertNull(played.player(seat).fault(), "seed " + match + ", seat " + seat);
                assertEquals(0, played.player(seat).earlyTurns());
                won[bots[seat]] += played.result().winner() == seat ? 1 : 0;
            }
            if (match % 3 == 0) {
                assertNull(played.verify().difference());
            }
            turns += played.result().turns();
        }
        report.publishEntry(contest.scene + ": " + matches + " matches without a fault, " + turns + " turns; won "
            + Arrays.toString(won) + languages);
        assertTrue(turns > 0);
    }
}

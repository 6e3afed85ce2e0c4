package steward.cli.machines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.ShellBots;

/** The short form of what the Gradle task {@code killedLeagues} does at length. */
@Tag("process")
@Tag("slow")
@Tag("campaign")
@Timeout(900)
class KilledLeaguesTest {

    @TempDir
    private Path folder;

    @Test
    void killedLeaguesComeToTheGamesOfUndisturbedOnes(TestReporter report) throws Exception {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        StringBuilder said = new StringBuilder();
        List<String> problems = KilledLeagues.kill(folder, 18, 60, 3, said::append);
        report.publishEntry(said.toString());
        assertEquals(List.of(), problems, said::toString);
    }
}

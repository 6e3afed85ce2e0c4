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
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.command.ProgramFinder;
import steward.cli.ShellBots;

/**
 * The short form of what the Gradle task {@code machines} does at length. Shorter still are {@code WorkerTest}, whose
 * connections are cut, and {@code LeagueProcessTest}, whose league is killed.
 */
@Tag("process")
@Tag("slow")
@Tag("campaign")
@Timeout(600)
@Execution(ExecutionMode.CONCURRENT)
class MachinesProofTest {

    @TempDir
    private Path folder;

    @Test
    void nothingIsLostOrDoubledWhenWorkersLeagueAndConnectionsEnd(TestReporter report) throws Exception {
        assumeTrue(ShellBots.runnable() && ProgramFinder.find("kill") != null, "skipped: there is no sh or kill");
        StringBuilder said = new StringBuilder();
        List<String> problems = MachinesProof.play(folder, 60, 1, 200, said::append);
        report.publishEntry(said.toString());
        assertEquals(List.of(), problems, said::toString);
    }
}

package steward.cli.check;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;

/** A bot tried with a referee of the scene's own. */
@Tag("process")
@Timeout(120)
class GuestCheckTest {

    @TempDir
    private Path folder;

    /** The referee says limits as it asks: later answers of more than a millisecond are not slow. */
    @Test
    void noLimitIsMadeUp() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null && ProgramFinder.find("sh") != null,
            "skipped: there is no python3 or no sh");
        Path scene = Files.writeString(folder.resolve("heap.json"), """
            {"name": "heap", "game": "guest", "players": 2,
             "referee": {"command": ["python3", "src/examples/referees/heap.py"]}}""");
        Path bot = Files.writeString(folder.resolve("bot.sh"), "while read heap; do sleep 0.01; echo 1; done\n");
        Cli cli = Cli.run("check", "--scene", scene.toString(), "--time-factor", "20", "codingame:sh " + bot).done();
        assertTrue(cli.out().matches("(?s).*the first answer took [0-9.]+ ms\n.*It is ready\\.\n"), cli.out());
    }
}

package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StderrHoldersTest {

    @TempDir
    private Path folder;

    /** Where process numbers have begun anew since, a bot's number is below that of the referee which started it. */
    @Test
    void theProgramItselfIsNoHolder() throws IOException {
        assumeTrue(Files.isDirectory(Path.of("/proc/self/fd")), "skipped: there is no /proc");
        Path file = folder.resolve("steward-of-this-test.stderr");
        try (OutputStream open = Files.newOutputStream(file)) {
            open.write('x');
            assertDoesNotThrow(() -> StderrHolders.kill(file, 1));
        }
    }
}

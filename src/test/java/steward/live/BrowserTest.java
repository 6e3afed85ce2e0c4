package steward.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Opening a page with programs that only look like browsers. */
@Tag("process")
@Timeout(8)
class BrowserTest {

    private static final URI PAGE = URI.create("http://127.0.0.1:1/");

    @TempDir
    private Path folder;

    @BeforeEach
    void shell() {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "there is no /bin/sh");
    }

    private static List<String> shell(String script) {
        return List.of("/bin/sh", "-c", script, "browser");
    }

    @Test
    void theAddressIsTheLastWord() throws Exception {
        Path told = folder.resolve("told");
        assertNull(new Browser(shell("echo \"$1\" >" + told)).open(PAGE));
        assertEquals(PAGE + "\n", Files.readString(told));
    }

    @Test
    void aProblemIsTold() throws InterruptedException {
        assertEquals("there is no no-such-program", new Browser(List.of("no-such-program")).open(PAGE));
        assertEquals("/bin/sh exited with status 3", new Browser(shell("exit 3")).open(PAGE));
        assertEquals("there is no display to show it on", new Browser(List.of()).open(PAGE));
    }

    /** Neither for its end nor for its input: one that reads finds nothing. */
    @Test
    void itIsNotWaitedFor() throws InterruptedException {
        assertNull(new Browser(shell("cat; sleep 10")).open(PAGE));
    }
}

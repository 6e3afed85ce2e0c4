package steward.bot.accounting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Memory of this JVM, which is one process. */
class TreeMemoryTest {

    private final long own = ProcessHandle.current().pid();

    /** A page that several processes share counts once where the sum would be too much. */
    @Test
    void aboveTheLimitSharedPagesAreCountedInProportion() {
        assumeTrue(Files.isReadable(Path.of("/proc/self/smaps_rollup")), "skipped: there is no smaps_rollup");
        byte[] kept = new byte[32 << 20];
        long resident = new TreeMemory().bytes(List.of(own), Long.MAX_VALUE);
        long shared = new TreeMemory().bytes(List.of(own), 1);
        assertTrue(shared > kept.length && resident > kept.length,
            resident + " resident, " + shared + " in proportion");
    }

    @Test
    void aProcessThatHasGoneUsesNothing() {
        assertEquals(0, new TreeMemory().bytes(List.of(Long.MAX_VALUE), 1));
    }
}

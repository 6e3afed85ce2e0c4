package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.bot.hold.HoldPolicy;

/** Limits in range, and how they are handed on. */
class ResourceLimitsTest {

    @Test
    void limitsOutOfRangeAreRefused() {
        String small = assertThrows(IllegalArgumentException.class,
            () -> new ResourceLimits(ResourceLimits.LEAST_MEMORY - 1, 0, 0, 0)).getMessage();
        assertEquals("memory: found 16777215, expected 16777216 to 1125899906842624", small);
        assertThrows(IllegalArgumentException.class, () -> new ResourceLimits(0, 1, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new ResourceLimits(0, 0, 1 << 20, 0));
        assertThrows(IllegalArgumentException.class, () -> new ResourceLimits(0, 0, 0, 3));
        assertThrows(IllegalArgumentException.class, () -> new ResourceLimits(-1, 0, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Isolation(SandboxLevel.OFF, false,
            new ResourceLimits(1L << 30, 0, 0, 0), BotEnvironment.USUAL, List.of(), List.of(),
            HoldPolicy.NEVER));
    }

    @Test
    void whatIsAskedForGoesBeforeWhatIsUsual() {
        ResourceLimits asked = new ResourceLimits(1L << 30, 16, 0, 0);
        assertEquals(new ResourceLimits(1L << 30, 16, ResourceLimits.STRICT.fileSize(),
            ResourceLimits.STRICT.openFiles()), asked.orElse(ResourceLimits.STRICT));
        assertTrue(ResourceLimits.NONE.isNone());
        assertFalse(asked.isNone());
    }

    /** A file may be in memory; stderr is a file, and not cut short. */
    @Test
    void aLimitOfMemoryBoundsFiles() {
        assertEquals(new ResourceLimits(1L << 30, 0, 1L << 30, 0),
            new ResourceLimits(1L << 30, 0, 0, 0).withoutLongFilesInMemory());
        assertEquals(new ResourceLimits(64L << 20, 0, ResourceLimits.LEAST_FILE_SIZE, 0),
            new ResourceLimits(64L << 20, 0, 1L << 40, 0).withoutLongFilesInMemory());
        assertEquals(ResourceLimits.STRICT, ResourceLimits.STRICT.withoutLongFilesInMemory());
    }

    /** In the units of {@code ulimit}: kilobytes of addresses, blocks of 512 bytes. */
    @Test
    void shellsGetTheirOwnUnits() {
        String lines = new ResourceLimits(64L << 20, 0, 1L << 30, 100).shell();
        assertEquals("ulimit -v 65536 2>/dev/null || :\nulimit -f 2097152 2>/dev/null || :\n"
            + "ulimit -n 100 2>/dev/null || :\n", lines);
        assertEquals("", ResourceLimits.NONE.shell());
    }

    @Test
    void processesAreLimitedOnlyWhereTheyAreCountedApart() {
        assertFalse(ResourceLimits.processesAreCountedApart("4.19.0-26-amd64"));
        assertFalse(ResourceLimits.processesAreCountedApart("5.13.9"));
        assertTrue(ResourceLimits.processesAreCountedApart("5.14.0"));
        assertTrue(ResourceLimits.processesAreCountedApart("6.1"));
        assertFalse(ResourceLimits.processesAreCountedApart("unknown"));
    }
}

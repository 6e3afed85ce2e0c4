package steward.cli.options;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** {@code --threads auto}. */
class ThreadsOptionTest {

    @Test
    void autoLeavesAProcessorForEverythingElse() {
        assertEquals(1, ThreadsOption.auto(1, true));
        assertEquals(1, ThreadsOption.auto(2, false));
        assertEquals(2, ThreadsOption.auto(2, true));
        assertEquals(7, ThreadsOption.auto(8, true));
        assertEquals(256, ThreadsOption.auto(1000, true));
    }
}

package steward.cli.options;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** {@code --threads auto}. */
class ThreadsOptionTest {

    @Test
    void autoLeavesAProcessorForEverythingElse() {
        assertEquals(1, ThreadsOption.auto(1));
        assertEquals(1, ThreadsOption.auto(2));
        assertEquals(7, ThreadsOption.auto(8));
        assertEquals(256, ThreadsOption.auto(1000));
    }
}

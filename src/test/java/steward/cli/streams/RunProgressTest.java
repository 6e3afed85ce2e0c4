package steward.cli.streams;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The time left of a run of parts of unequal length. */
class RunProgressTest {

    @Test
    void atTheBeginningItIsWhatWasExpected() {
        assertEquals(600, RunProgress.left(0, 0, 600));
    }

    /** Half of the expected work has taken three times as long: the other half will, but for the trust. */
    @Test
    void aSlowerMachineShowsAsTheRunGoesOn() {
        assertEquals((900.0 + 10) / (300 + 10) * 300, RunProgress.left(900, 300, 600));
        assertTrue(Math.abs(RunProgress.left(900, 300, 600) - 900) < 30);
    }

    @Test
    void nothingIsLeftAtTheEnd() {
        assertEquals(0, RunProgress.left(1000, 600, 600));
        assertEquals(0, RunProgress.left(1000, 601, 600));
    }

    /** The second part is nine times the first, so that the first is a tenth of all. */
    @Test
    void theLineIsOfAllParts() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        RunProgress run = new RunProgress(new Streams(new ByteArrayOutputStream(), err, true, true),
            List.of(10.0, 90.0));
        assertEquals(100, run.total());
        run.begin("short");
        run.end();
        run.begin("long");
        run.reach(0.5);
        run.end();
        String shown = err.toString(StandardCharsets.UTF_8);
        assertTrue(shown.contains("1 of 2: short") && shown.contains("2 of 2: long"), shown);
        assertTrue(shown.contains(" 550/1000 "), shown);
    }

    /** Four steps of a part that is expected to take a tenth of all; a fifth is no more than the whole part. */
    @Test
    void aPartMayReportItsSteps() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        RunProgress run = new RunProgress(new Streams(new ByteArrayOutputStream(), err, true, true),
            List.of(10.0, 90.0));
        run.begin("short");
        Runnable step = run.steps(4);
        for (int k = 0; k < 5; k++) {
            step.run();
        }
        run.end();
        String shown = err.toString(StandardCharsets.UTF_8);
        assertTrue(shown.contains(" 100/1000 ") && !shown.contains(" 125/1000 "), shown);
    }
}

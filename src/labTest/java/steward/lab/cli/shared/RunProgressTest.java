package steward.lab.cli.shared;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import steward.cli.streams.Streams;

/** The parts of a run on a terminal's line. */
class RunProgressTest {

    private final ByteArrayOutputStream err = new ByteArrayOutputStream();
    private final RunProgress run = new RunProgress(new Streams(new ByteArrayOutputStream(), err, true, true), 2);

    private String shown() {
        return err.toString(StandardCharsets.UTF_8);
    }

    @Test
    void theLineSaysWhichPart() {
        run.begin("short");
        run.end();
        run.begin("long");
        Runnable steps = run.steps(20);
        IntStream.range(0, 11).forEach(step -> steps.run());
        run.end();
        assertTrue(shown().contains("1 of 2: short") && shown().contains("2 of 2: long"), shown());
        assertTrue(shown().contains(" 550/1000 "), shown());
    }

    /** Four steps of a part; a fifth is no more than the whole part. */
    @Test
    void aPartMayReportItsSteps() {
        run.begin("short");
        Runnable step = run.steps(4);
        for (int k = 0; k < 5; k++) {
            step.run();
        }
        run.end();
        assertTrue(shown().contains(" 1000/1000 ") && !shown().contains(" 1250/1000 "), shown());
    }
}

package steward.cli.streams;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import org.junit.jupiter.api.Test;

class EventStreamTest {

    private static String logged(boolean json, String written) {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        PrintStream stream = new PrintStream(new EventStream(new PrintStream(log, true, StandardCharsets.UTF_8), json,
            () -> Instant.parse("2026-11-25T12:00:00.123456Z")), true, StandardCharsets.UTF_8);
        stream.print(written);
        return log.toString(StandardCharsets.UTF_8);
    }

    @Test
    void eachLineHasItsTime() {
        assertEquals("steward: 2026-11-25T12:00:00.123Z worker one plays again\n"
            + "steward: 2026-11-25T12:00:00.123Z Watch the league at here\n",
            logged(false, "steward: worker one plays again\n\nWatch the league at here\n"));
    }

    @Test
    void eachLineIsAnObject() {
        assertEquals("{\"time\":\"2026-11-25T12:00:00.123Z\",\"event\":\"found \\\"é\\\"\"}\n",
            logged(true, "steward: found \"é\"\nnot yet"));
    }
}

package steward.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The lines of a match that is being written. */
@Timeout(10)
class LiveRecordingTest {

    private final LiveRecording recording = new LiveRecording();

    private void write(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        recording.write(bytes, 0, bytes.length);
    }

    private String line(int number) throws InterruptedException {
        return new String(recording.line(number, 0), StandardCharsets.UTF_8);
    }

    @Test
    void linesAreTheSameHoweverTheyAreWritten() throws InterruptedException {
        write("first\nsec");
        write("ond");
        assertSame(LiveRecording.NOT_YET, recording.line(1, 0));
        recording.write('\n');
        write("\nthird");
        assertEquals("first", line(0));
        assertEquals("second", line(1));
        assertEquals("", line(2));
        assertEquals("first\nsecond\n\n", new String(recording.replay(), StandardCharsets.UTF_8));
    }

    @Test
    void aReaderWaitsForALine() throws InterruptedException {
        Thread writer = new Thread(() -> write("now\n"));
        writer.start();
        assertEquals("now", new String(recording.line(0, 5000), StandardCharsets.UTF_8));
        writer.join();
    }

    @Test
    void afterTheEndNothingIsWaitedFor() throws InterruptedException {
        write("one\n");
        recording.close();
        assertEquals("one", line(0));
        assertNull(recording.line(1, 60_000));
    }

    @Test
    void itIsCompleteWithItsResultOrWhenItWasClosed() {
        write("{\"type\":\"turn\"}\n");
        assertFalse(recording.isComplete());
        write("{\"type\":\"result\",\"turns\":1}\n");
        assertTrue(recording.isComplete());
        LiveRecording brokenOff = new LiveRecording();
        brokenOff.close();
        assertTrue(brokenOff.isComplete());
        assertEquals(0, brokenOff.replay().length);
    }
}

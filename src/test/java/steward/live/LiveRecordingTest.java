package steward.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** The lines of a match that is being written. */
class LiveRecordingTest {

    private final LiveRecording recording = new LiveRecording();

    private void write(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        recording.write(bytes, 0, bytes.length);
    }

    /** The event of a line. */
    private String event(int number) {
        return new String(recording.piece(number).bytes(), StandardCharsets.UTF_8);
    }

    @Test
    void linesAreTheSameHoweverTheyAreWritten() {
        write("first\nsec");
        write("ond");
        assertNull(recording.piece(1));
        recording.write('\n');
        write("\nthird");
        assertEquals("data: first\n\n", event(0));
        assertEquals("data: second\n\n", event(1));
        assertEquals("data: \n\n", event(2));
        assertEquals(3, recording.piece(2).next());
        assertEquals("first\nsecond\n\n", new String(recording.replay(), StandardCharsets.UTF_8));
    }

    @Test
    void everyChangeIsTold() {
        int[] told = new int[1];
        recording.onChange(() -> told[0]++);
        write("now\n");
        recording.close();
        assertEquals(2, told[0]);
    }

    @Test
    void afterTheEndNothingFollows() {
        write("one\n");
        recording.close();
        assertEquals("data: one\n\n", event(0));
        assertSame(LiveFeed.END, recording.piece(1));
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

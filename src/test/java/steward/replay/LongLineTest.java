package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.match.TestScenes;
import steward.replay.verify.Verification;

/** A line that is too long is refused before it fills the memory. */
class LongLineTest {

    /** One byte for ever, without taking any room. */
    private static final class Endless extends InputStream {

        private long given;

        @Override
        public int read() {
            given++;
            return 'x';
        }

        @Override
        public int read(byte[] into, int from, int count) {
            Arrays.fill(into, from, from + count, (byte) 'x');
            given += count;
            return count;
        }
    }

    private static String refusal(String begin, int longest, Endless rest) {
        byte[] first = begin.getBytes(StandardCharsets.UTF_8);
        InputStream in = new SequenceInputStream(new ByteArrayInputStream(first), rest);
        return assertThrows(ReplayException.class, () -> {
            try (ReplayReader reader = new ReplayReader(in, "r.jsonl", longest)) {
                RecordedMatch.read(reader);
            }
        }).getMessage();
    }

    @Test
    void aHeaderOrATurn() {
        String header = Recorded.of("duel", 1).lines().get(0);
        Endless rest = new Endless();
        assertEquals("r.jsonl:1: found a line of more than 5000 bytes, expected a line of a replay, which is shorter",
            refusal("{\"type\":\"steward-replay\",\"format\":3,\"game\":\"", 5000, rest));
        assertEquals("r.jsonl:2: found a line of more than 5000 bytes, expected a line of a replay, which is shorter",
            refusal(header + "\n{\"type\":\"turn\",\"turn\":1,\"messages\":[\"", 5000, rest));
        assertTrue(rest.given < 1 << 20, "read: " + rest.given);
    }

    /** A file of hundreds of megabytes without a line end, with the limit of the program. */
    @Test
    @Tag("slow")
    void theUsualLimitIsHeldWhileReading() {
        Endless rest = new Endless();
        assertTrue(refusal("{\"type\":\"steward-replay\",\"format\":3,\"game\":\"", ReplayReader.LONGEST_LINE, rest)
            .startsWith("r.jsonl:1: found a line of more than 134217728 bytes"));
        assertTrue(rest.given < ReplayReader.LONGEST_LINE + (1 << 20), "read: " + rest.given);
    }

    @Test
    void aLineOfJustThatLengthIsRead() {
        Recorded match = Recorded.of("duel", 1);
        byte[] replay = match.bytes();
        int longest = match.lines().stream().mapToInt(line ->
            line.getBytes(StandardCharsets.UTF_8).length).max().orElseThrow() + 200;      // times differ
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), "r.jsonl", longest)) {
            assertEquals(Recorded.whole(RecordedMatch.read(Recorded.reader(replay)).turns().size()),
                Verification.of(reader, TestScenes.TYPES));
        }
    }
}

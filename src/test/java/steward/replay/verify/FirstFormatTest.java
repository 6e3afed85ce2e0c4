package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;
import steward.replay.Recorded;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;

/** What was recorded in format 1, whose hashes took bytes one by one, is still read and verified. */
class FirstFormatTest {

    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    /** A player fails, so that a text enters a hash too; faults are not of ASCII alone. */
    private final Recorded match = Recorded.of(TestScenes.open("walled-race"), 20,
        List.of(new SeededBot(1, 0.8), new Stopping()));

    /** Says something unusable. */
    private static final class Stopping implements Bot {

        @Override
        public void setup(String line) {
            // whatever there is to know
        }

        @Override
        public String turn(String line) {
            return "st\u00f6p";
        }
    }

    private static long hash(byte[] bytes) {
        long hash = 0;
        for (byte one : bytes) {
            hash = SplitMix64.mix(hash + one + GAMMA);
        }
        return hash;
    }

    private static long hash(long before, String[] texts) {
        long hash = before;
        for (String text : texts) {
            hash = SplitMix64.mix(hash + (text == null ? -1 : text.length()) + GAMMA);
            for (int k = 0; text != null && k < text.length(); k++) {
                hash = SplitMix64.mix(hash + text.charAt(k) + GAMMA);
            }
        }
        return hash;
    }

    /** The same line with another hash. */
    private static String put(String line, String name, long hash) {
        String begin = ",\"" + name + "\":\"";
        int from = line.indexOf(begin) + begin.length();
        return line.substring(0, from) + String.format("%016x", hash) + line.substring(from + 16);
    }

    private static String putBefore(String line, String name) {
        String before = line.substring(0, line.indexOf(",\"" + name + "\":"));
        return put(line, name, hash(before.getBytes(StandardCharsets.UTF_8)));
    }

    /** The match as format 1 has it. */
    private List<String> asFirstFormat() {
        List<String> lines = new ArrayList<>(match.lines());
        ReplayReader reader = Recorded.reader(match.bytes());
        lines.set(0, putBefore(lines.get(0).replace("\"format\":2", "\"format\":1"), "headerHash"));
        for (int k = 1; k < lines.size() - 1; k++) {
            RecordedTurn turn = reader.next();
            long hash = hash(hash(hash(hash(turn.commands()), turn.faults()), turn.messages()), turn.stderr());
            lines.set(k, put(lines.get(k), "inputHash", hash));
        }
        int last = lines.size() - 1;
        lines.set(last, putBefore(lines.get(last), "resultHash"));
        return lines;
    }

    @Test
    void isVerified() {
        List<String> lines = asFirstFormat();
        assertNotEquals(match.lines().get(1), lines.get(1), "another hash");
        assertTrue(match.text().contains("\"faults\":[null,\""), "a text");
        Verification seen = Recorded.verify(String.join("\n", lines) + "\n");
        assertEquals(new Verification(match.result().turns(), null, null), seen);
    }

    /** Each of the three hashes is looked at, and those of one format are none of the other. */
    @Test
    void hashesOfTheOtherFormatDiffer() {
        List<String> lines = asFirstFormat();
        for (int k : new int[] {0, 1, lines.size() - 1}) {
            List<String> mixed = new ArrayList<>(lines);
            mixed.set(k, match.lines().get(k).replace("\"format\":2", "\"format\":1"));
            Verification seen = Recorded.verify(String.join("\n", mixed) + "\n");
            assertEquals(k == 0 ? "headerHash" : k == 1 ? "inputHash" : "resultHash", seen.difference().field(),
                "line " + (k + 1));
        }
    }
}

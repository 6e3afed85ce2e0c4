package steward.game.podrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/** One reader for all answers of a match says of each what a new reader says, whatever came before. */
@Execution(ExecutionMode.CONCURRENT)
class RepeatedAnswersTest {

    private static final List<String> LINES = List.of(
        "{\"pods\":[{\"x\":1,\"y\":2.5,\"thrust\":100},{\"x\":-1e3,\"y\":2,\"shield\":true}]}",
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}],\"message\":\"h\\u00e9\"}",
        " {\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}]}",
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}]} \t",
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}]} {",
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}]}x",
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}]",
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}], \"mesage\":1}",
        "{\"message\":\"first\",\"pods\":[{\"x\":7,\"y\":8}]}",
        "{\"pods\":[{\"x\":7", "{}", "[]", "7", "", "{", "\u0000",
        "{\"pods\":[{\"x\":1e999,\"y\":2,\"thrust\":100},{\"x\":1,\"y\":2,\"shield\":true}]}",
        "{\"message\":\"" + "m".repeat(20_000) + "\",\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},"
            + "{\"x\":9,\"y\":1,\"thrust\":0}]}" + " ".repeat(9000),
        "{\"pods\":[{\"x\":7,\"y\":8,\"boost\":true},{\"x\":9,\"y\":1,\"thrust\":0}]}" + " ".repeat(9000) + "1");

    private static String said(PodRaceAnswer answer, String line) {
        byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
        String wrong = answer.read(bytes, bytes.length);
        return wrong != null ? wrong : answer + ", " + answer.message();
    }

    @Test
    @Tag("sized")
    void whateverCameBefore() {
        SplitMix64 random = new SplitMix64(4);
        PodRaceAnswer reused = new PodRaceAnswer(2, 200);
        for (int k = 0; k < TestSize.of(1500, 5000); k++) {
            String line = LINES.get(random.nextInt(LINES.size()));

            assertEquals(said(new PodRaceAnswer(2, 200), line), said(reused, line), "seed 4, line " + k);
        }
    }

    /** Nothing but blanks may stand behind an answer, however plain it is. */
    @Test
    void nothingStandsBehindAPlainAnswer() {
        String good = "{\"pods\":[{\"x\":1,\"y\":2.5,\"thrust\":100},{\"x\":-3,\"y\":2,\"shield\":true}]}";
        PodRaceAnswer answer = new PodRaceAnswer(2, 200);
        String read = said(answer, good);
        assertTrue(read.startsWith("x [1.0, -3.0]"), read);
        for (char behind = 0; behind < 0x180; behind++) {
            boolean blank = " \t\r\n".indexOf(behind) >= 0;
            String said = said(answer, good + behind);
            assertEquals(blank, said.equals(read), "character " + (int) behind + " behind it: " + said);
            assertEquals(blank, said(answer, good + " " + behind + " ").equals(read));
        }
    }

    /**
     * A line that a plain reader can read is, with an empty message behind the pods, one that it cannot: both readers
     * must say the same, to the bit, of good lines and of lines in which something is out of place.
     */
    @Test
    @Tag("slow")
    @Tag("sized")
    void plainLinesAreReadAsByTheParser() {
        int lines = TestSize.of(4_000, 60_000);
        SplitMix64 random = new SplitMix64(6);
        int good = 0;
        for (int k = 0; k < lines; k++) {
            String pods = "{\"pods\":[" + pod(random) + "," + pod(random) + "]";
            String damaged = k % 2 == 0 ? pods : damaged(pods, random);
            String plain = said(new PodRaceAnswer(2, 200), damaged + "}");
            String parsed = said(new PodRaceAnswer(2, 200), damaged + ",\"message\":\"\"}");
            if (plain.startsWith("x [")) {
                good++;
                assertEquals(plain.substring(0, plain.lastIndexOf(',')),
                    parsed.substring(0, Math.max(0, parsed.lastIndexOf(','))), "seed 6, line " + k + ": " + damaged);
            } else {
                assertEquals(false, parsed.startsWith("x ["), "seed 6, line " + k + ": " + damaged);
            }
        }
        assertTrue(good > lines / 4, "good lines: " + good);
    }

    private static String pod(SplitMix64 random) {
        String blank = random.nextInt(3) == 0 ? " " : "";
        String third = switch (random.nextInt(6)) {
            case 0 -> "\"shield\":" + blank + "true";
            case 1 -> "\"boost\":" + blank + "true";
            case 2 -> "\"thrust\":" + random.nextInt(250);
            case 3 -> "\"thrust\":" + random.nextInt(200) + ".0";
            default -> "\"thrust\":" + blank + random.nextInt(201);
        };
        return "{" + blank + "\"x\":" + number(random) + blank + ",\"y\":" + blank + number(random) + "," + blank
            + third + blank + "}";
    }

    private static String number(SplitMix64 random) {
        long digits = random.nextLong() >>> 1 + random.nextInt(62);
        String whole = (random.nextInt(2) == 0 ? "-" : "") + digits;
        return switch (random.nextInt(5)) {
            case 0 -> whole + "." + (random.nextLong() >>> 1 + random.nextInt(62));
            case 1 -> whole + ".000" + random.nextInt(100);
            case 2 -> "0." + "0".repeat(random.nextInt(14)) + random.nextInt(1000);
            default -> whole;
        };
    }

    private static String damaged(String line, SplitMix64 random) {
        int at = random.nextInt(line.length());
        String inserted = new String[] {"", "0", "-", ".", " ", ",", "}", "\"", "e1", "\t", "x"}[random.nextInt(11)];
        return line.substring(0, at) + inserted + line.substring(at + random.nextInt(2));
    }

    /** A program that writes two bytes for a character was understood, if it did so from its first line on. */
    @Test
    void linesInOtherEncodings() {
        PodRaceAnswer reused = new PodRaceAnswer(2, 200);
        for (String line : List.of(LINES.get(0), LINES.get(1), LINES.get(0))) {
            for (var charset : List.of(StandardCharsets.UTF_16BE, StandardCharsets.UTF_8, StandardCharsets.UTF_16LE)) {
                byte[] bytes = line.getBytes(charset);

                assertEquals(new PodRaceAnswer(2, 200).read(bytes, bytes.length), reused.read(bytes, bytes.length),
                    charset.name());
            }
        }
    }
}

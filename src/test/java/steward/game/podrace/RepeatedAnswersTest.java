package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;

/** One reader for all answers of a match says of each what a new reader says, whatever came before. */
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

    private static String said(PodAnswer answer, String line) {
        byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
        String wrong = answer.read(bytes, bytes.length);
        return wrong != null ? wrong : answer + ", " + answer.message();
    }

    @Test
    void whateverCameBefore() {
        SplitMix64 random = new SplitMix64(4);
        PodAnswer reused = new PodAnswer(2, 200);
        for (int k = 0; k < 5000; k++) {
            String line = LINES.get(random.nextInt(LINES.size()));

            assertEquals(said(new PodAnswer(2, 200), line), said(reused, line), "seed 4, line " + k);
        }
    }

    /** A program that writes two bytes for a character was understood, if it did so from its first line on. */
    @Test
    void linesInOtherEncodings() {
        PodAnswer reused = new PodAnswer(2, 200);
        for (String line : List.of(LINES.get(0), LINES.get(1), LINES.get(0))) {
            for (var charset : List.of(StandardCharsets.UTF_16BE, StandardCharsets.UTF_8, StandardCharsets.UTF_16LE)) {
                byte[] bytes = line.getBytes(charset);

                assertEquals(new PodAnswer(2, 200).read(bytes, bytes.length), reused.read(bytes, bytes.length),
                    charset.name());
            }
        }
    }
}

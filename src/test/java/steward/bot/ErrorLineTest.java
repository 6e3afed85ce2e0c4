package steward.bot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

class ErrorLineTest {

    /** Stderr of programs of {@link FailingProgramsTest}, of CPython 3.11, Node 20, OpenJDK 17, g++ 12, Go and Rust. */
    private static final Path RECORDED = Path.of("src/test/resources/failing/recorded.txt");

    @TestFactory
    Stream<DynamicTest> theLineThatSaysWhyIsFoundInWhatProgramsWrote() throws IOException {
        String[] all = Files.readString(RECORDED).split("(?m)^=== ");
        return Arrays.stream(all).filter(each -> !each.isEmpty()).map(each -> {
            List<String> lines = each.lines().toList();
            String[] head = lines.get(0).split(" says: ");
            return dynamicTest(head[0], () -> {
                assertFound(head[1], lines.subList(1, lines.size()));
                assertFound(head[1], lines.subList(1, lines.size()).stream().filter(line -> !line.isBlank()).toList());
            });
        });
    }

    private static void assertFound(String expected, List<String> lines) {
        int index = ErrorLine.index(lines);
        String line = lines.get(index < 0 ? lines.size() - 1 : index);
        assertTrue(ErrorLine.text(line).contains(expected), () -> line + "\nis not '" + expected + "' in\n"
            + String.join("\n", lines));
    }

    @Test
    void whatLooksLikeAnErrorOnlyByAWordIsNone() {
        assertEquals(-1, ErrorLine.index(List.of("no Error", "Error: 0.25", "panic: too near", "error: 3",
            "Exceptions: 0", "terminated", "  at 5, 3", "File \"map\", line 3", "^", "^^^", "fatal error: none")));
        assertEquals(-1, ErrorLine.index(List.of()));
        assertEquals(-1, ErrorLine.index(List.of("", "a.js:3", "x", "^")));
    }

    @Test
    void theLastErrorThatAProgramPrintsIsTheOneThatEndsIt() {
        List<String> lines = List.of("java.lang.IllegalStateException: caught", "\tat Bot.main(Bot.java:3)", "turn 2",
            "Exception in thread \"main\" java.lang.IllegalStateException: not caught", "\tat Bot.main(Bot.java:9)");
        assertEquals(3, ErrorLine.index(lines));
    }
}

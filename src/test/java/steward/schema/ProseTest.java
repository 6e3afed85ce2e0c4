package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Documents can be read without stopping: no sentence is long, and the notes of a version are short. */
@Execution(ExecutionMode.CONCURRENT)
class ProseTest {

    private static final int MOST_WORDS = 35;
    private static final int VERSION_LINES = 120;
    /** Lines of figures, on pages that a command writes as a whole. */
    private static final Pattern FIGURES = Pattern.compile("(?m)^[|>].*$");

    private static List<String> longSentences(String path, String text) {
        return MarkdownPage.of(path, text).sentences().stream()
            .filter(one -> MarkdownProse.words(one.text()) > MOST_WORDS)
            .map(one -> path + ":" + one.line() + ": " + MarkdownProse.words(one.text()) + " words: " + one.text())
            .toList();
    }

    @Test
    void noSentenceIsLong() throws IOException {
        List<String> found = new ArrayList<>();
        for (MarkdownPage page : MarkdownPage.all()) {
            String text = Files.readString(Path.of(page.path()));
            boolean measured = DocsTest.GENERATED_PAGE.matcher(text).find();
            found.addAll(longSentences(page.path(), measured ? FIGURES.matcher(text).replaceAll("") : text));
        }
        assertEquals("", String.join("\n", found));
    }

    @Test
    void aLongSentenceIsFoundWhereverItStands() {
        String words = "word ".repeat(35);
        String page = "# " + words + "\n\n" + words + "more.\n\n    " + words + "code\n\n- " + words + ". " + words
            + ".\n- " + words + "\n  goes on\n\n| a | " + words + "in a cell | `" + words + "code` |\n\n```\n" + words
            + "code\n```\n" + words + "[" + words + "](nowhere) " + "1.5 is no end - of a sentence";

        assertEquals(List.of("36", "37", "38", "77"), longSentences("page", page).stream()
            .map(found -> found.replaceAll("page:\\d+: (\\d+) words.*", "$1")).toList());
        assertEquals(List.of("3", "8", "11", "16"), longSentences("page", page).stream()
            .map(found -> found.split(":")[1]).toList());
    }

    @Test
    void theNotesOfAVersionAreShort() throws IOException {
        String[] versions = Files.readString(Path.of("CHANGELOG.md")).split("(?m)^(?=## \\[)");
        assertTrue(versions.length > 3, versions.length + " parts");
        for (String version : versions) {
            long lines = version.lines().count();
            assertTrue(lines <= VERSION_LINES, version.lines().findFirst().orElse("") + " has " + lines
                + " lines, expected at most " + VERSION_LINES);
        }
    }
}

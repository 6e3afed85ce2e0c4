package steward.lab.bench;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The README's two ratios of speed are those of the published page, which a bench has written. */
class PublishedPerformanceTest {

    @Test
    void theReadmeSaysWhatThePageSays() throws IOException {
        String readme = Files.readString(Path.of("README.md")).replaceAll("\\s+", " ");
        for (String said : new String[] {
            said("race, simulator", "%.1f times as fast as a textbook port"),
            said("answer", "JSON answers are read %.1f times as fast as into a tree")}) {
            assertTrue(readme.contains(said), "README.md: expected \"" + said + "\", as in docs/performance.md");
        }
    }

    /** The sentence with the ratio of a row. */
    private static String said(String row, String sentence) throws IOException {
        Matcher found = Pattern.compile("(?m)^\\| " + row + " \\|(?: [^|]+\\|){3} ([0-9.]+) \\|")
            .matcher(Files.readString(Path.of("docs/performance.md")));
        assertTrue(found.find(), "docs/performance.md has no row \"" + row + "\"");
        return String.format(Locale.ROOT, sentence, Double.parseDouble(found.group(1)));
    }
}

package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The version is the same wherever it stands: of the build, of the notes, of the lines that other builds copy. */
class ReleaseTest {

    private static String first(String pattern, String file) throws IOException {
        Matcher found = Pattern.compile(pattern, Pattern.MULTILINE).matcher(Files.readString(Path.of(file)));
        assertTrue(found.find(), file + ": " + pattern);
        return found.group(1);
    }

    @Test
    void theVersionOfTheBuildHasNotesAndIsTheOneToDependOn() throws IOException {
        String version = first("^version = '([^']+)'$", "build.gradle");
        assertEquals(version, first("^## \\[([^\\]]+)\\] - \\d{4}-\\d\\d-\\d\\d$", "CHANGELOG.md"));
        TreeSet<String> named = new TreeSet<>();
        Matcher coordinates = Pattern.compile("steward(?:-engine)?(?::|</artifactId><version>)(\\d[\\w.]*)")
            .matcher(Files.readString(Path.of("docs/library.md")));
        while (coordinates.find()) {
            named.add(coordinates.group(1));
        }
        assertEquals(new TreeSet<>(Set.of(version)), named);
    }
}

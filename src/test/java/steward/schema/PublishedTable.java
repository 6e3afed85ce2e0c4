package steward.schema;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Tables that campaigns write into pages of the folder {@code -Psteward.tables=docs/tables}; without it, nowhere. */
public final class PublishedTable {

    private PublishedTable() { }

    /** Replaces the lines of a page between its comments {@code generated NAME} and {@code /generated}. */
    public static void write(String page, String name, List<String> lines) throws IOException {
        String folder = System.getProperty("steward.tables");
        if (folder == null) {
            return;
        }
        Path file = Path.of(folder, page);
        String text = Files.readString(file);
        String begin = "<!-- generated " + name + " -->\n";
        int from = text.indexOf(begin) + begin.length();
        int to = text.indexOf("<!-- /generated -->", from);
        assertTrue(from >= begin.length() && to >= 0, () -> file + ": found no comment " + begin);
        Files.writeString(file, text.substring(0, from) + String.join("\n", lines) + "\n" + text.substring(to));
    }
}

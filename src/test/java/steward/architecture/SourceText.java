package steward.architecture;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Texts of files in the repository, by path from its top, with slashes. */
public final class SourceText {

    private SourceText() {
    }

    /** One file; pictures, packed ones and others with a byte of 0 have no text, and what else is not UTF-8 fails. */
    public static String of(String file) {
        try {
            byte[] bytes = Files.readAllBytes(Path.of(file));
            return IntStream.range(0, bytes.length).anyMatch(k -> bytes[k] == 0) ? ""
                : StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** The text of a page below a heading of the second level, up to the next. */
    static String section(String page, String heading) {
        return of(page).split("(?m)^## " + heading + "\n", 2)[1].split("(?m)^## ", 2)[0];
    }

    /** Files below some folders whose names end so. */
    public static SortedMap<String, String> ofKind(String end, String... folders) {
        SortedMap<String, String> texts = new TreeMap<>();
        for (String folder : folders) {
            try (Stream<Path> files = Files.walk(Path.of(folder))) {
                files.filter(Files::isRegularFile).map(file -> file.toString().replace('\\', '/'))
                    .filter(file -> file.endsWith(end)).forEach(file -> texts.put(file, of(file)));
            } catch (IOException problem) {
                throw new UncheckedIOException(problem);
            }
        }
        return texts;
    }
}

package steward.guest;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;
import steward.files.Sha256;

/**
 * Digest of a referee's files, independent of where they are stored: its class path, or the files that its command
 * names. They are read when the digest is first asked for.
 */
final class RefereeDigest {

    private final GuestProgram program;
    private String text;

    RefereeDigest(GuestProgram program) {
        this.program = program;
    }

    /** Returns the digest, or {@code null} if there are no files. */
    synchronized String text() {
        List<String> entries = text == null ? program.files() : List.of();
        text = entries.isEmpty() ? text : read(entries);
        return text;
    }

    private static String read(List<String> entries) {
        try {
            MessageDigest digest = Sha256.begin();
            for (String entry : entries) {
                Path root = Path.of(entry);
                try (Stream<Path> files = Files.walk(root, FileVisitOption.FOLLOW_LINKS)) {
                    for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                        digest.update(root.relativize(file).toString().getBytes(StandardCharsets.UTF_8));
                        digest.update(Files.readAllBytes(file));
                    }
                }
            }
            return "sha256:" + HexFormat.of().formatHex(digest.digest());
        } catch (IOException | UncheckedIOException problem) {       // unchecked of a folder below
            throw new UncheckedIOException("referee: cannot be read: " + problem.getMessage(),
                new IOException(problem));
        }
    }
}

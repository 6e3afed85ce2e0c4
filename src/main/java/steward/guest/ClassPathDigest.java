package steward.guest;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;

/** Digest of all files on a class path, whatever the folders above are called; read when it is first asked for. */
final class ClassPathDigest {

    private final List<String> classPath;
    private String text;

    ClassPathDigest(List<String> classPath) {
        this.classPath = classPath;
    }

    /** Returns the digest, or {@code null} if there is no class path. */
    synchronized String text() {
        if (text == null && !classPath.isEmpty()) {
            text = read();
        }
        return text;
    }

    private String read() {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (String entry : classPath) {
                Path root = Path.of(entry);
                try (Stream<Path> files = Files.walk(root, FileVisitOption.FOLLOW_LINKS)) {
                    for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                        digest.update(root.relativize(file).toString().getBytes(StandardCharsets.UTF_8));
                        digest.update(Files.readAllBytes(file));
                    }
                }
            }
            return "sha256:" + HexFormat.of().formatHex(digest.digest());
        } catch (UncheckedIOException problem) {       // of a folder below
            throw new UncheckedIOException("referee.classPath: cannot be read: " + problem.getMessage(),
                problem.getCause());
        } catch (IOException problem) {
            throw new UncheckedIOException("referee.classPath: cannot be read: " + problem.getMessage(), problem);
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}

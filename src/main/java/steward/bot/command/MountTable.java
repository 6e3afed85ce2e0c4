package steward.bot.command;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Table of mounted file systems as Linux reports it, one line each: device, mount point, type, options (see {@code
 * fstab(5)}).
 */
final class MountTable {

    private static final Path FILE = Path.of("/proc/self/mounts");

    /** The mount point of a file system that holds the file and forbids to execute what it holds, or {@code null}. */
    static String noexec(Path file) {
        try {
            return noexec(Files.readString(FILE, StandardCharsets.UTF_8), file.toRealPath());
        } catch (IOException problem) {
            return null;                               // another system, or the file has gone
        }
    }

    /** The innermost mount decides, of those at one place the last. */
    static String noexec(String table, Path file) {
        Path innermost = null;
        boolean forbidden = false;
        for (String line : table.split("\n")) {
            String[] words = line.split(" ");
            if (words.length < 4) {
                continue;
            }
            Path point = Path.of(plain(words[1]));
            if (file.startsWith(point) && (innermost == null || point.startsWith(innermost))) {
                innermost = point;
                forbidden = Arrays.asList(words[3].split(",")).contains("noexec");
            }
        }
        return forbidden ? innermost.toString() : null;
    }

    /** Blanks and the like are written as three octal digits. */
    private static String plain(String escaped) {
        return escaped.replace("\\040", " ").replace("\\011", "\t").replace("\\012", "\n").replace("\\134", "\\");
    }
}

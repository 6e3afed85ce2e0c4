package steward.bot.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Processes to be ended, since they have left the group of their bot and still hold its stderr. That is an unnamed
 * file, which nothing bounds after the bot is over: they would fill the disk unseen. Only processes of the bot can have
 * it.
 *
 * <p>Caveats: for systems with {@code /proc}; elsewhere nothing is found. A process that has closed its stderr on
 * purpose, or runs as another user, is not found.
 */
final class StderrHolders {

    /** A process may have started another while it was looked for. */
    private static final int MOST_ROUNDS = 5;

    private static final Path PROC = Path.of("/proc");

    /**
     * Kills what has the file open, among the processes that were started after the bot.
     *
     * @param file under the name that it had
     * @param bot  number of the bot's first process
     */
    static void kill(Path file, long bot) {
        for (int round = 0; round < MOST_ROUNDS; round++) {
            List<ProcessHandle> found = of(file, bot);
            found.forEach(ProcessHandle::destroyForcibly);
            if (found.isEmpty()) {
                return;
            }
        }
    }

    private static List<ProcessHandle> of(Path file, long bot) {
        List<ProcessHandle> found = new ArrayList<>();
        String own = " " + ProcessHandle.current().pid() + " ";
        try {
            // Its last field is the process number given last: numbers go up, and begin anew after the greatest.
            String load = Files.readString(PROC.resolve("loadavg"), StandardCharsets.US_ASCII).strip();
            long last = Long.parseLong(load.substring(load.lastIndexOf(' ') + 1));
            try (DirectoryStream<Path> all = Files.newDirectoryStream(PROC, "[0-9]*")) {
                for (Path process : all) {
                    long pid = Long.parseLong(process.getFileName().toString());
                    boolean later = (last >= bot ? pid > bot && pid <= last : pid > bot || pid <= last)
                        && pid != ProcessHandle.current().pid();     // numbers may have begun anew below this one's
                    Optional<ProcessHandle> handle = later ? ProcessHandle.of(pid) : Optional.empty();
                    if (handle.isPresent() && hasOpen(process, file) && !isChildOf(process, own)) {
                        found.add(handle.get());
                    }
                }
            }
        } catch (IOException | NumberFormatException otherSystem) {
            return found;
        }
        return found;
    }

    private static boolean hasOpen(Path process, Path file) {
        String name = file.getFileName().toString();
        try (DirectoryStream<Path> open = Files.newDirectoryStream(process.resolve("fd"))) {
            for (Path descriptor : open) {
                if (Files.readSymbolicLink(descriptor).toString().contains(name)) {
                    return true;
                }
            }
            return false;
        } catch (IOException | DirectoryIteratorException gone) {
            return false;
        }
    }

    /** Such a child is about to become another bot, and has our descriptors for a moment. */
    private static boolean isChildOf(Path process, String parent) {
        try {
            String stat = Files.readString(process.resolve("stat"), StandardCharsets.ISO_8859_1);
            return stat.substring(stat.lastIndexOf(')') + 1).matches(" ." + parent + "(?s:.*)");
        } catch (IOException gone) {
            return true;
        }
    }
}

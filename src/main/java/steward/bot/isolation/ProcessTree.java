package steward.bot.isolation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Process numbers of a bot, at every level of isolation: the first process and all its descendants. In a PID namespace,
 * processes whose parents have ended become children of the namespace's first process, so that none is missed. The
 * programs that only create the namespaces and wait are included; they use a few milliseconds at the start and nothing
 * later.
 *
 * <p>Caveat: without a PID namespace a process whose parents have ended is no longer a descendant.
 */
public final class ProcessTree {

    private static final Path PROCESSES = Path.of("/proc");

    private ProcessTree() { }

    /**
     * A process and its descendants, in no order but that the process is first; the process alone where it has ended
     * or nothing is known of others. Reads a file for each thread of them, tens of microseconds for a small bot.
     */
    public static List<Long> of(long pid) {
        Set<Long> found = new LinkedHashSet<>();
        List<Long> open = new ArrayList<>(List.of(pid));
        boolean listed = false;
        while (!open.isEmpty()) {
            long next = open.remove(open.size() - 1);
            if (found.add(next)) {
                listed |= addChildren(next, open);
            }
        }
        if (!listed) {
            ProcessHandle.of(pid).ifPresent(first -> first.descendants().forEach(each -> found.add(each.pid())));
        }
        return List.copyOf(found);
    }

    /** Adds the children of all threads; returns whether the system lists them. */
    private static boolean addChildren(long pid, List<Long> into) {
        boolean listed = false;
        try (DirectoryStream<Path> threads = Files.newDirectoryStream(PROCESSES.resolve(pid + "/task"))) {
            for (Path thread : threads) {
                String children = Files.readString(thread.resolve("children"), StandardCharsets.US_ASCII);
                listed = true;
                for (String child : children.split(" ")) {
                    if (!child.isBlank()) {
                        into.add(Long.parseLong(child.strip()));
                    }
                }
            }
        } catch (IOException | NumberFormatException ended) {
            return listed;
        }
        return listed;
    }
}

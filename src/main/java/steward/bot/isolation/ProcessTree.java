package steward.bot.isolation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The processes of a bot as this machine numbers them, at every level of isolation: the first process and all that
 * descend from it. In a PID namespace processes whose parents have ended become children of the namespace's first
 * process, so that none of them is missed. The programs that only make the namespaces and wait are among them; they
 * use a few milliseconds at the start and nothing later.
 *
 * <p>Caveat: without a PID namespace a process whose parents have ended descends from them no longer;
 * {@link #withSession} finds it unless it has left the session too.
 */
public final class ProcessTree {

    private static final Path PROCESSES = Path.of("/proc");
    /** Where the fields of a {@code stat} line are, counted from the one after the name of the program. */
    private static final int PARENT = 1;
    private static final int SESSION = 3;

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

    /**
     * As {@link #of}, and the processes of the session that the process leads, with their descendants. Looks at every
     * process of the machine, which takes milliseconds.
     */
    public static List<Long> withSession(long leader) {
        Map<Long, List<Long>> children = new HashMap<>();
        Set<Long> found = new LinkedHashSet<>();
        List<Long> open = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(PROCESSES, "[0-9]*")) {
            for (Path process : all) {
                long pid = Long.parseLong(process.getFileName().toString());
                String[] fields = fields(process);
                if (fields.length > SESSION) {
                    children.computeIfAbsent(Long.parseLong(fields[PARENT]), parent -> new ArrayList<>()).add(pid);
                    if (Long.parseLong(fields[SESSION]) == leader) {
                        open.add(pid);
                    }
                }
            }
        } catch (IOException | NumberFormatException none) {
            return of(leader);
        }
        open.add(leader);
        while (!open.isEmpty()) {
            long next = open.remove(open.size() - 1);
            if (found.add(next)) {
                open.addAll(children.getOrDefault(next, List.of()));
            }
        }
        return List.copyOf(found);
    }

    /** The fields after the name of the program, which may hold anything; none when the process has ended. */
    private static String[] fields(Path process) {
        try {
            String line = Files.readString(process.resolve("stat"), StandardCharsets.ISO_8859_1);
            return line.substring(line.lastIndexOf(')') + 2).split(" ");
        } catch (IOException ended) {
            return new String[0];
        }
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

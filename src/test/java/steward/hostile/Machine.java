package steward.hostile;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;

/** Traces that a match may leave on this machine: processes, files, descriptors, threads. */
final class Machine {

    /** Time that a loaded machine may need for something that takes milliseconds. */
    private static final long PATIENCE_NANOS = 20_000_000_000L;

    private static final int NONE_LEFT = 10;

    private Machine() {
    }

    /** Waits for a condition; returns whether it holds. */
    static boolean await(BooleanSupplier condition) {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                return false;
            }
            try {
                Thread.sleep(5);
            } catch (InterruptedException broken) {
                throw new IllegalStateException(broken);
            }
        }
        return true;
    }

    /** Numbers of running processes whose command line has a mark, without this one. */
    static List<Long> marked(String mark) {
        List<Long> found = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(Path.of("/proc"), "[0-9]*")) {
            for (Path process : all) {
                long pid = Long.parseLong(process.getFileName().toString());
                if (pid != ProcessHandle.current().pid() && text(process.resolve("cmdline")).contains(mark)) {
                    found.add(pid);
                }
            }
            return found;
        } catch (IOException problem) {
            throw new IllegalStateException(problem);
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file, StandardCharsets.ISO_8859_1);
        } catch (IOException ended) {
            return "";
        }
    }

    /** Numbers of the running children of a process whose command line has a word. */
    static List<Long> children(long parent, String word) {
        return marked(word).stream().filter(pid -> text(Path.of("/proc/" + pid + "/status"))
            .contains("\nPPid:\t" + parent + "\n")).toList();
    }

    /**
     * Ends the processes with a mark, which this program has started, by their numbers; returns whether all are gone. A
     * process that forks may be missed between two numbers: none may be found many times in a row.
     */
    static boolean end(String mark) {
        int[] none = {0};
        return await(() -> {
            List<Long> found = marked(mark);
            found.forEach(pid -> ProcessHandle.of(pid).ifPresent(ProcessHandle::destroyForcibly));
            none[0] = found.isEmpty() ? none[0] + 1 : 0;
            return none[0] > NONE_LEFT;
        });
    }

    /** Names of files of ours in the folder for temporary files. */
    static Set<String> temporaryFiles(Path folder) {
        Set<String> names = new TreeSet<>(Arrays.asList(folder.toFile().list()));
        names.removeIf(name -> !name.startsWith("steward-"));
        return names;
    }

    static int descriptors() {
        return new File("/proc/self/fd").list().length;
    }

    /** Returns the number of our threads that are there for one bot. */
    static long threads() {
        return Thread.getAllStackTraces().keySet().stream().map(Thread::getName)
            .filter(name -> name.equals("steward-deadline") || name.equals("steward-spare")).count();
    }
}

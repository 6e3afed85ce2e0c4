package steward.lab.bench.section;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Iterator;

/**
 * CPU time of this JVM and the programs it has started, all threads together, from Linux's count for each thread in
 * {@code /proc/PID/task/TID/schedstat}: nanoseconds, while the JDK's own figures come in ticks of 10 ms. Threads and
 * programs that have ended no longer count, so read it while the programs run.
 */
final class ProcessTreeClock {

    private static final Path PROCESSES = Path.of("/proc");

    /** In nanoseconds; NaN where the system does not provide it. */
    static double nanos() {
        ProcessHandle self = ProcessHandle.current();
        try {
            double sum = nanos(self);
            for (Iterator<ProcessHandle> children = self.children().iterator(); children.hasNext();) {
                sum += nanos(children.next());
            }
            return sum;
        } catch (IOException | NumberFormatException none) {
            return Double.NaN;
        }
    }

    private static double nanos(ProcessHandle process) throws IOException {
        double sum = 0;
        Path threads = PROCESSES.resolve(process.pid() + "/task");
        try (DirectoryStream<Path> each = Files.newDirectoryStream(threads)) {
            for (Path thread : each) {
                sum += ofThread(thread.resolve("schedstat"));
            }
        }
        return sum;
    }

    /** The first of three numbers. */
    private static double ofThread(Path file) throws IOException {
        try {
            return Double.parseDouble(Files.readString(file, StandardCharsets.US_ASCII).split(" ")[0]);
        } catch (NoSuchFileException ended) {
            if (Files.exists(file.getParent())) {
                throw ended;                           // a system without this count
            }
            return 0;
        }
    }
}

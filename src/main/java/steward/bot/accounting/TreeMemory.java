package steward.bot.accounting;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Meter of the memory of a tree of processes, for machines where no control group counts it: mapped memory, and open
 * files in memory. Shared pages are counted for each process at first, and in proportion once the sum exceeds the
 * limit.
 *
 * <p>Caveat: files in memory are not found if a process does not let itself be inspected, or if they are in a message
 * under way. Page tables, pipes and other memory of the kernel are not counted.
 */
public final class TreeMemory {

    private static final long KILOBYTE = 1024;
    /** How the kernel names a file in memory that has no path. */
    private static final String IN_MEMORY = "/memfd:";

    private final ProcFile file = new ProcFile();

    /**
     * Returns the bytes that processes use, exact only above a limit.
     *
     * @param processes by number
     * @param limit     in bytes
     */
    public long bytes(List<Long> processes, long limit) {
        long files = files(processes);
        long resident = 0;
        for (long process : processes) {
            resident += field("/proc/" + process + "/status", "VmRSS:");
        }
        return resident + files > limit ? inProportion(processes, files) : resident + files;
    }

    /** Memory mapped of files in memory: counted with the files, or as mapped where that is more. */
    private long inProportion(List<Long> processes, long files) {
        long mapped = 0;
        long ofFiles = 0;
        for (long process : processes) {
            String rollup = "/proc/" + process + "/smaps_rollup";
            long share = field(rollup, "Pss:");
            long shared = field(rollup, "Pss_Shmem:");
            mapped += share > 0 ? share - shared : field("/proc/" + process + "/status", "VmRSS:");
            ofFiles += shared;
        }
        return mapped + Math.max(ofFiles, files);
    }

    /** A field of a file of lines such as {@code VmRSS: 1024 kB}, in bytes; 0 where there is none. */
    private long field(String path, String name) {
        return file.readAll(path) && file.skipPast(name) ? KILOBYTE * file.nextLong() : 0;
    }

    private static long files(List<Long> processes) {
        Map<Object, Long> sizes = new HashMap<>();
        for (long process : processes) {
            try (DirectoryStream<Path> open = Files.newDirectoryStream(Path.of("/proc/" + process + "/fd"))) {
                for (Path descriptor : open) {
                    if (Files.readSymbolicLink(descriptor).toString().startsWith(IN_MEMORY)) {
                        sizes.put(Files.getAttribute(descriptor, "unix:ino"), Files.size(descriptor));
                    }
                }
            } catch (IOException | DirectoryIteratorException gone) {
                continue;
            }
        }
        return sizes.values().stream().mapToLong(Long::longValue).sum();
    }
}

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
 * Memory of processes together, for machines where no control group counts it: what they have mapped, and files in
 * memory that they have open. Pages that several share are counted for each of them at first, and in proportion once
 * that is more than the limit.
 *
 * <p>Caveat: files in memory are not seen of a process that does not let itself be looked at, nor in a message that is
 * under way; neither are page tables, pipes and other memory of the kernel.
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

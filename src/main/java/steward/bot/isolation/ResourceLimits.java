package steward.bot.isolation;

import java.util.ArrayList;
import java.util.List;

/**
 * Limits on a bot's memory, processes, file sizes and open files; 0 for no limit.
 *
 * @param memory    in bytes, at least {@value #LEAST_MEMORY}
 * @param processes together with their threads
 * @param fileSize  of one file, in bytes
 * @param openFiles of one process
 */
public record ResourceLimits(long memory, long processes, long fileSize, long openFiles) {

    /** Bytes that programs need to start at all. */
    public static final long LEAST_MEMORY = 16L << 20;

    /** The most that a limit may be; more is a slip of the keyboard. */
    public static final long MOST_BYTES = 1L << 50;

    /** A bot must be able to start a thread. */
    public static final long LEAST_PROCESSES = 4;

    /** Most processes that a Linux machine can have. */
    public static final long MOST_PROCESSES = 4_194_304;

    /** More than what is kept of a bot's stderr, which is a file. */
    public static final long LEAST_FILE_SIZE = 512L << 20;

    /** Interpreters open some dozens at their start. */
    public static final long LEAST_OPEN_FILES = 64;

    /** Files that Linux allows a process at most, unless it was told otherwise. */
    public static final long MOST_OPEN_FILES = 1_048_576;

    public static final ResourceLimits NONE = new ResourceLimits(0, 0, 0, 0);

    /** Limits of {@link SandboxLevel#STRICT} where nothing else is asked for: memory is open. */
    public static final ResourceLimits STRICT = new ResourceLimits(0, 512, 1L << 30, 4096);

    /** From this version of Linux on processes are counted for each user namespace. */
    private static final int[] COUNTED_APART = {5, 14};

    private static final int KILOBYTE = 1024;
    /** The unit of {@code ulimit -f}, in bytes. */
    private static final int BLOCK = 512;

    /** @throws IllegalArgumentException if one is out of range */
    public ResourceLimits {
        check("memory", memory, LEAST_MEMORY, MOST_BYTES);
        check("processes", processes, LEAST_PROCESSES, MOST_PROCESSES);
        check("file size", fileSize, LEAST_FILE_SIZE, MOST_BYTES);
        check("open files", openFiles, LEAST_OPEN_FILES, MOST_OPEN_FILES);
    }

    private static void check(String name, long found, long least, long most) {
        if (found != 0 && !(found >= least && found <= most)) {
            throw new IllegalArgumentException(name + ": found " + found + ", expected " + least + " to " + most);
        }
    }

    /** Returns these limits, with the other's where this one has none. */
    public ResourceLimits orElse(ResourceLimits other) {
        return new ResourceLimits(or(memory, other.memory), or(processes, other.processes),
            or(fileSize, other.fileSize), or(openFiles, other.openFiles));
    }

    private static long or(long one, long other) {
        return one == 0 ? other : one;
    }

    ResourceLimits withoutMemory() {
        return new ResourceLimits(0, processes, fileSize, openFiles);
    }

    /** Returns these limits without those that a control group holds. */
    ResourceLimits withoutControlGroup() {
        return new ResourceLimits(0, 0, fileSize, openFiles);
    }

    /**
     * Returns these limits for where no control group holds the memory: a file may be in memory, and so is not longer
     * than that may be, or than stderr has to be.
     */
    ResourceLimits withoutLongFilesInMemory() {
        long most = Math.max(memory, LEAST_FILE_SIZE);
        return memory == 0 || fileSize > 0 && fileSize <= most ? this
            : new ResourceLimits(memory, processes, most, openFiles);
    }

    public boolean isNone() {
        return equals(NONE);
    }

    /**
     * Lines for a shell that set these limits for what it executes next. A limit that cannot be set is one that is
     * lower already. Shells call the number of processes by different letters.
     */
    String shell() {
        List<String> lines = new ArrayList<>();
        if (memory > 0) {
            lines.add("ulimit -v " + memory / KILOBYTE);
        }
        if (processes > 0 && processesAreCountedApart(System.getProperty("os.version", ""))) {
            lines.add("{ ulimit -u " + processes + " || ulimit -p " + processes + "; }");
        }
        if (fileSize > 0) {
            lines.add("ulimit -f " + fileSize / BLOCK);
        }
        if (openFiles > 0) {
            lines.add("ulimit -n " + openFiles);
        }
        StringBuilder all = new StringBuilder();
        lines.forEach(line -> all.append(line).append(" 2>/dev/null || :\n"));
        return all.toString();
    }

    /** Before, a limit counted all processes of the user, so that a bot could have none. */
    static boolean processesAreCountedApart(String version) {
        String[] parts = version.split("[^0-9]+");
        try {
            int major = parts.length == 0 ? 0 : Integer.parseInt(parts[0]);
            int minor = parts.length > 1 ? Integer.parseInt(parts[1]) : 0;
            return major > COUNTED_APART[0] || major == COUNTED_APART[0] && minor >= COUNTED_APART[1];
        } catch (NumberFormatException unknown) {
            return false;
        }
    }
}

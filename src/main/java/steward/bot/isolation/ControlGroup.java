package steward.bot.isolation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Control group (cgroup version 2) of one bot: pauses and kills all its processes at once, and limits their memory and
 * number. Steward can create groups as root, or in a group that was delegated to its user: {@code systemd-run --user
 * --scope -p Delegate=yes steward ...}. The limits hold if the system offers both controllers and Steward's group has
 * no foreign processes; Steward moves its own processes into a group below.
 */
public final class ControlGroup {

    private static final String PREFIX = "steward-";
    /** Group of this program's own processes: a group with controllers for its parts holds no processes. */
    private static final String REFEREE = "referee";
    private static final String PROCESSES = "cgroup.procs";
    private static final int ATTEMPTS = 50;
    private static final long PAUSE_MS = 10;
    private static final AtomicLong NUMBERS = new AtomicLong();

    private final Path folder;
    private final boolean limits;

    private ControlGroup(Path folder, boolean limits) {
        this.folder = folder;
        this.limits = limits;
    }

    private static final class Shared {
        static final Base BASE = Base.find(Path.of("/proc/self/cgroup"), Path.of("/proc/self/mounts"));
    }

    /**
     * Group in which groups can be created.
     *
     * @param limits whether its groups limit memory and processes
     */
    record Base(Path folder, boolean limits) {

        /** Returns the group of this process if it may create others there, or {@code null}. */
        static Base find(Path memberships, Path mounts) {
            try {
                Path mount = mount(mounts);
                String own = Files.readAllLines(memberships).stream().filter(line -> line.startsWith("0::"))
                    .map(line -> line.substring("0::".length())).findFirst().orElse(null);
                if (mount == null || own == null) {
                    return null;
                }
                return at(mount.resolve(own.substring(1)).normalize(), own.equals("/"));
            } catch (IOException | RuntimeException none) {
                return null;
            }
        }

        private static Path mount(Path mounts) throws IOException {
            for (String line : Files.readAllLines(mounts, StandardCharsets.ISO_8859_1)) {
                String[] fields = line.split(" ");
                if (fields.length > 2 && fields[2].equals("cgroup2")) {
                    return Path.of(fields[1]);
                }
            }
            return null;
        }

        /** @param root whether it is the machine's, which may hold processes and controllers at once */
        static Base at(Path folder, boolean root) throws IOException {
            if (!Files.isWritable(folder) || !Files.isWritable(folder.resolve(PROCESSES))) {
                return null;
            }
            removeOld(folder);
            return new Base(folder, enable(folder, root));
        }

        /** Gives the parts of the group the two controllers. @return true if they have them */
        private static boolean enable(Path folder, boolean root) {
            try {
                if (!words(folder.resolve("cgroup.controllers")).containsAll(List.of("memory", "pids"))) {
                    return false;
                }
                Path enabled = folder.resolve("cgroup.subtree_control");
                if (words(enabled).containsAll(List.of("memory", "pids"))) {
                    return true;
                }
                if (!root) {
                    if (!words(folder.resolve(PROCESSES)).stream().allMatch(Base::isOurs)) {
                        return false;
                    }
                    Path own = folder.resolve(PREFIX + REFEREE);
                    if (!Files.isDirectory(own)) {
                        Files.createDirectory(own);
                    }
                    for (String pid : words(folder.resolve(PROCESSES))) {
                        write(own.resolve(PROCESSES), pid);
                    }
                }
                write(enabled, "+memory +pids");
                return words(enabled).containsAll(List.of("memory", "pids"));
            } catch (IOException refused) {
                return false;
            }
        }

        /** True if the process is this program's; processes of others are not moved. */
        private static boolean isOurs(String pid) {
            return ProcessTree.of(ProcessHandle.current().pid()).contains(Long.valueOf(pid));
        }

        /** Removes the groups of referees that were killed; one that still has processes stays. */
        private static void removeOld(Path folder) throws IOException {
            try (DirectoryStream<Path> groups = Files.newDirectoryStream(folder, PREFIX + "[0-9]*-*")) {
                for (Path group : groups) {
                    long referee = Long.parseLong(group.getFileName().toString().split("-")[1]);
                    if (ProcessHandle.of(referee).isEmpty()) {
                        group.toFile().delete();
                    }
                }
            }
        }
    }

    /** Returns why bots cannot have groups here, or {@code null} if they can. */
    public static String problem() {
        return Shared.BASE == null ? "no control group was delegated to this program" : null;
    }

    /**
     * Returns the folders where control groups can be written to: a bot that could would kill and stop others there.
     */
    static List<String> mountPoints() {
        return Mounted.POINTS;
    }

    private static final class Mounted {
        static final List<String> POINTS = find();

        private static List<String> find() {
            try {
                return Files.readAllLines(Path.of("/proc/self/mounts"), StandardCharsets.ISO_8859_1).stream()
                    .map(line -> line.split(" ")).filter(fields -> fields.length > 3
                        && fields[2].matches("cgroup2?") && Files.isDirectory(Path.of(fields[1])))
                    .map(fields -> fields[1]).distinct().toList();
            } catch (IOException | RuntimeException none) {
                return List.of();
            }
        }
    }

    /** True if groups limit memory and processes. */
    public static boolean holdsLimits() {
        return Shared.BASE != null && Shared.BASE.limits();
    }

    /**
     * Creates a group for a bot. Returns {@code null} where there can be none or it is not needed: the bot is not to be
     * paused and has no limits that a group would hold.
     */
    public static ControlGroup forBot(Isolation isolation) {
        boolean useful = HoldMeans.of(isolation) == HoldMeans.CONTROL_GROUP
            || isolation.level() == SandboxLevel.STRICT && holdsLimits();
        return useful && Shared.BASE != null ? in(Shared.BASE, isolation) : null;
    }

    static ControlGroup in(Base base, Isolation isolation) {
        Path folder = base.folder().resolve(PREFIX + ProcessHandle.current().pid() + "-" + NUMBERS.incrementAndGet());
        boolean limits = base.limits() && isolation.level() == SandboxLevel.STRICT;
        try {
            Files.createDirectory(folder);
            if (limits && isolation.limits().memory() > 0) {
                write(folder.resolve("memory.max"), Long.toString(isolation.limits().memory()));
                if (Files.exists(folder.resolve("memory.swap.max"))) {
                    write(folder.resolve("memory.swap.max"), "0");
                }
            }
            if (limits && isolation.limits().processes() > 0) {
                write(folder.resolve("pids.max"), Long.toString(isolation.limits().processes()));
            }
            return new ControlGroup(folder, limits);
        } catch (IOException refused) {
            folder.toFile().delete();
            return null;
        }
    }

    /** The group's cgroup.procs file; a process joins the group by writing 0 to it. */
    Path joinFile() {
        return folder.resolve(PROCESSES);
    }

    /** True if it limits memory and processes. */
    public boolean limits() {
        return limits;
    }

    /** Stops all its processes, or lets them go on. @return false if that was not possible */
    public boolean pause(boolean stop) {
        try {
            write(folder.resolve("cgroup.freeze"), stop ? "1" : "0");
            return true;
        } catch (IOException refused) {
            return false;
        }
    }

    /** CPU time of all processes that were ever in it, in nanoseconds; -1 if that cannot be read. */
    public long cpu() {
        try {
            String[] words = Files.readString(folder.resolve("cpu.stat")).split("\\s+", 3);
            return words[0].equals("usage_usec") ? TimeUnit.MICROSECONDS.toNanos(Long.parseLong(words[1])) : -1;
        } catch (IOException gone) {
            return -1;
        }
    }

    /** Kills what is left in it and removes it; blocks until its processes have gone, at most half a second. */
    public void remove() {
        try {
            if (Files.exists(folder.resolve("cgroup.kill"))) {
                write(folder.resolve("cgroup.kill"), "1");
            }
        } catch (IOException gone) {
            // The group has no processes any more, or has gone.
        }
        for (int attempt = 0; attempt < ATTEMPTS && Files.exists(folder); attempt++) {
            if (folder.toFile().delete()) {
                return;
            }
            try {
                Thread.sleep(PAUSE_MS);
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
                return;
            }
        }
    }

    private static Set<String> words(Path file) throws IOException {
        Set<String> words = new TreeSet<>(List.of(Files.readString(file).split("\\s+")));
        words.remove("");
        return words;
    }

    private static void write(Path file, String text) throws IOException {
        Files.writeString(file, text, StandardOpenOption.WRITE);
    }
}

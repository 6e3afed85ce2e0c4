package steward.bot.accounting;

import java.io.File;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import steward.bot.accounting.TreeSample.ThreadTimes;

/**
 * Sampler of a process and its descendants, in any namespaces, which are found anew each time. Children are read from
 * {@code /proc/PID/task/TID/children}; if the kernel has no such file, they are found by their parents among all
 * processes.
 *
 * <p>Caveat: without a PID namespace, a descendant whose parent has exited becomes another process's child and leaves
 * the tree. The CPU time of processes that nobody has waited for is lost when they exit.
 */
public final class TreeSampler implements AutoCloseable {

    /** So many processes are looked at: a tree that grows faster than it can be read comes to an end. */
    private static final int MOST = 2048;

    private static final String PROC = "/proc/";

    /** Where the CPU times stand in /proc/PID/stat, counted from the state behind the name. */
    private static final int BEFORE_TIMES = 10;

    /** And, from there, the number of threads. */
    private static final int BEFORE_COUNT = 2;

    /** How the kernel names, cut to 15 characters, the threads by which a JVM compiles and collects. */
    private static final Pattern OF_JVM = Pattern.compile("(C1|C2) Compiler.*|GC Thread#.*|G1 .*|ParGC Thread.*"
        + "|VM Thread|Z(Worker|Driver|Director|Stat|Unmapper|Uncommitter).*|Shenandoah.*|Sweeper thread",
        Pattern.DOTALL);

    private final long root;
    private boolean excused;
    /** The processes of the last sample. */
    private Set<Long> known = Set.of();
    private final boolean byChildren;
    private final ProcFile file = new ProcFile();

    /** @param root number of the first process, as this JVM sees it */
    public TreeSampler(long root) {
        this(root, Support.CHILDREN);
    }

    /** @param byChildren whether children are read from their parents' files */
    TreeSampler(long root, boolean byChildren) {
        this.root = root;
        this.byChildren = byChildren;
    }

    /** Facilities of this system to look at this JVM, and so at other processes of the same user. */
    private static final class Support {
        static final boolean CPU = new ProcFile().read("/proc/self/stat");
        static final boolean THREADS = schedstat();
        static final boolean CHILDREN = new File("/proc/self/task/" + ProcessHandle.current().pid() + "/children")
            .canRead();
        static final int PROCESSORS = Math.max(processors(), Runtime.getRuntime().availableProcessors());

        /** A kernel that does not count has a file of zeros. */
        private static boolean schedstat() {
            ProcFile file = new ProcFile();
            return file.read("/proc/self/schedstat") && file.nextLong() > 0;
        }

        private static int processors() {
            String[] names = new File("/sys/devices/system/cpu").list();
            return names == null ? 0 : (int) Arrays.stream(names).filter(name -> name.matches("cpu\\d+")).count();
        }
    }

    /** True if the system shows the CPU time of processes. */
    public static boolean showsCpuTime() {
        return Support.CPU;
    }

    /** Returns how many processors the machine has. */
    public static int processors() {
        return Support.PROCESSORS;
    }

    /** Idle time of all processors together, in nanoseconds, in steps of {@link TreeSample#STEP}; -1 if not shown. */
    public static long idle() {
        return idle(new ProcFile());
    }

    private static long idle(ProcFile file) {
        if (!file.read("/proc/uptime")) {
            return -1;
        }
        file.skipWords(1);
        return file.hasNext() ? file.nextHundredths() * TreeSample.STEP : -1;
    }

    /** Samples the processes: their totals up to now. */
    public TreeSample sample(long at) {
        return sample(at, true, false);
    }

    /**
     * Samples as {@link #sample} does, but quicker, for processes that should be waiting: only threads of processes
     * that were not there at the last sample are taken for runnable, and the idle time of the machine is left out.
     */
    public TreeSample baseline(long at) {
        return sample(at, false, false);
    }

    /**
     * Samples as {@link #baseline} does, but without the threads by which a JVM compiles and collects; where there are
     * any, only what living threads used is known.
     */
    public TreeSample withoutCompilers(long at) {
        return sample(at, false, true);
    }

    /** @param often true if files are to stay open for the next sample, until {@link #close} */
    public synchronized TreeSampler keepingFiles(boolean often) {
        file.keep(often);
        return this;
    }

    /** Closes files that are kept. It can go on sampling. */
    @Override
    public synchronized void close() {
        file.close();
    }

    private synchronized TreeSample sample(long at, boolean whole, boolean excusing) {
        Map<Long, ThreadTimes> threads = Support.THREADS ? new HashMap<>() : null;
        Map<Long, List<Long>> children = byChildren ? null : childrenByParent();
        List<Long> found = new ArrayList<>(List.of(root));
        Set<Long> before = known;
        int seen = 0;
        long steps = 0;
        excused = false;
        for (int k = 0; k < found.size(); k++) {
            String folder = PROC + found.get(k);
            boolean begun = !before.contains(found.get(k));
            if (!file.read(folder + "/stat") || !file.skipName()) {
                if (begun && threads != null) {                  // it ran and ended since it was found
                    threads.put(found.get(k), new ThreadTimes(0, 0, 0, true));
                }
                continue;
            }
            seen++;
            file.skipWords(1 + BEFORE_TIMES);
            steps += file.nextLong() + file.nextLong() + file.nextLong() + file.nextLong();
            file.skipWords(BEFORE_COUNT);
            boolean single = file.nextLong() == 1;
            String[] names = threads == null && !byChildren ? new String[0]
                : single ? new String[] {Long.toString(found.get(k))} : new File(folder + "/task").list();
            for (String name : names == null ? new String[0] : names) {
                readThread(folder + "/task/", name, whole || begun, excusing, threads, found);
            }
            if (children != null) {
                found.addAll(children.getOrDefault(found.get(k), List.of()));
            }
        }
        known = new HashSet<>(found);
        return new TreeSample(at, seen > 0, seen, excused ? 0 : steps * TreeSample.STEP, threads,
            whole ? idle(file) : -1);
    }

    private void readThread(String folder, String name, boolean state, boolean excusing,
                            Map<Long, ThreadTimes> threads, List<Long> found) {
        String thread = folder + name;
        boolean out = excusing && file.read(thread + "/comm") && file.isMatch(OF_JVM);
        excused |= out;
        if (threads != null && !out && file.read(thread + "/schedstat")) {
            long run = file.nextLong();
            long waited = file.nextLong();
            long slices = file.nextLong();
            boolean runnable = state && (!file.read(thread + "/stat") || file.skipName()
                && file.nextCharacter() == 'R');       // one that has just ended ran
            boolean leader = folder.startsWith(name + "/", PROC.length());
            threads.put(Long.valueOf(name), new ThreadTimes(run, waited, slices, runnable, leader));
        }
        if (byChildren && file.readAll(thread + "/children")) {
            while (file.hasNext() && found.size() < MOST) {
                found.add(file.nextLong());
            }
        }
    }

    private Map<Long, List<Long>> childrenByParent() {
        Map<Long, List<Long>> children = new HashMap<>();
        String[] names = new File("/proc").list((folder, name) -> Character.isDigit(name.charAt(0)));
        for (String name : names == null ? new String[0] : names) {
            if (file.read("/proc/" + name + "/stat") && file.skipName()) {
                file.skipWords(1);
                children.computeIfAbsent(file.nextLong(), parent -> new ArrayList<>()).add(Long.valueOf(name));
            }
        }
        return children;
    }
}

package steward.bot.accounting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.bot.command.ProgramFinder;

/** Real processes; what is expected of them is only what no slow machine changes. */
@Tag("process")
class TreeSamplerTest {

    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(60);

    private Process process;

    @BeforeEach
    void linux() {
        assumeTrue(ProgramFinder.find("sh") != null, "there is no sh on the PATH");
        assumeTrue(TreeSampler.showsCpuTime(), "there is no /proc/self/stat");
    }

    @AfterEach
    void end() {
        if (process != null) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
    }

    /** Starts a script, and waits for its first line. */
    private long start(String script) throws IOException {
        process = new ProcessBuilder("sh", "-c", script).start();
        BufferedReader lines = process.inputReader(StandardCharsets.US_ASCII);
        assertEquals("ready", lines.readLine());
        return process.pid();
    }

    /** Files of a process that this JVM has open. */
    private static long open(long process) throws IOException {
        try (Stream<Path> files = Files.list(Path.of("/proc/self/fd"))) {
            return files.filter(file -> {
                try {
                    return Files.readSymbolicLink(file).startsWith("/proc/" + process);
                } catch (IOException closed) {
                    return false;
                }
            }).count();
        }
    }

    /** Waits until there are so many processes; returns the sample with them. */
    private static TreeSample await(TreeSampler tree, int processes) {
        long end = System.nanoTime() + PATIENCE_NANOS;
        TreeSample sample = tree.baseline(0);
        while (sample.processes() != processes && System.nanoTime() < end) {
            sample = tree.baseline(0);
        }
        return sample;
    }

    @Test
    void filesThatAreKeptShowWhatIsNewAndAreClosed() throws IOException, InterruptedException {
        long root = start("echo ready; read -r line; sh -c ': child'; sleep 1000 & read -r line; kill $!; wait");
        try (TreeSampler tree = new TreeSampler(root).keepingFiles(true)) {
            long before = await(tree, 1).threads().get(root).run();
            assertTrue(open(root) > 0, "none is kept");
            process.getOutputStream().write('\n');
            process.getOutputStream().flush();
            TreeSample after = await(tree, 2);
            long end = System.nanoTime() + PATIENCE_NANOS;
            while (after.threads().get(root).run() <= before && System.nanoTime() < end) {
                after = await(tree, 2);              // the root may have been read before it made its child
            }
            assertEquals(2, after.processes());
            assertTrue(after.threads().get(root).run() > before, after.toString());
            process.getOutputStream().close();
            process.waitFor();
            assertEquals(0, await(tree, 0).processes());
        }
        assertEquals(0, open(root));
    }

    /** The shell, its two children, and the child of one of them. */
    @Test
    void childrenOfChildrenAreFoundInBothWays() throws IOException {
        long root = start("sleep 1000 & sh -c 'sleep 1000 & wait; :' & echo ready; wait");
        for (TreeSampler tree : new TreeSampler[] {new TreeSampler(root, false), new TreeSampler(root)}) {
            long end = System.nanoTime() + PATIENCE_NANOS;
            while (tree.sample(0).processes() != 4 && System.nanoTime() < end) {
                Thread.onSpinWait();
            }
            assertEquals(4, tree.sample(0).processes());
            assertEquals(tree.sample(0).threads().keySet(), tree.baseline(0).threads().keySet());
        }
    }

    /** A child computes until the sum says so; the sum then has it, in nanoseconds and in steps. */
    @Test
    void theTimeOfAChildIsThatOfTheTree() throws IOException {
        long root = start("echo ready; sh -c 'while :; do :; done'; :");
        TreeSampler tree = new TreeSampler(root);
        TreeSample sample = tree.sample(0);
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (sample.steps() < 5 * TreeSample.STEP && System.nanoTime() < end) {
            sample = tree.sample(0);
        }
        assertTrue(sample.shown());
        assertTrue(sample.steps() >= 5 * TreeSample.STEP, sample + "");
        assumeTrue(sample.threads() != null, "this kernel does not count the waiting of threads");
        long run = sample.threads().values().stream().mapToLong(TreeSample.ThreadTimes::run).sum();
        // Whole steps of user and system time of two processes; a running thread's own count is brought up to date by
        // the clock interrupt, at the latest after 10 ms.
        assertTrue(run >= sample.steps() - 2 * TreeSample.STEP, run + " " + sample.steps());
    }

    /** The child has ended, and its parent has waited for it. */
    @Test
    void theTimeOfAChildThatHasEndedStays() throws IOException {
        long root = start("sh -c 'i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done'; echo ready; exec sleep 1000");
        TreeSample sample = new TreeSampler(root).sample(0);
        assertEquals(1, sample.processes());
        assertTrue(sample.steps() > 0, "300000 rounds of a shell took less than a step of 10 ms");
    }

    @Test
    void whoeverIsGoneShowsNothing() throws Exception {
        long root = start("echo ready");
        process.waitFor();
        assertFalse(new TreeSampler(root).sample(0).shown());
    }
}

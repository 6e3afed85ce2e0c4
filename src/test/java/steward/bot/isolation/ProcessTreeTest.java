package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Which processes belong to a bot, as the processes themselves say. */
@Tag("process")
class ProcessTreeTest {

    @BeforeEach
    void processes() {
        assumeTrue(Files.isDirectory(Path.of("/proc/self")), "skipped: there is no /proc");
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/setsid")), "skipped: there is no setsid");
    }

    /** Runs a script that prints numbers of processes and then waits for the end of its input. */
    private interface Look {
        void at(long leader, List<Long> said);
    }

    private static void run(String script, Look look) throws IOException, InterruptedException {
        Process process = new ProcessBuilder("setsid", "sh", "-c", script + "; read -r end; kill $all").start();
        try (BufferedReader reader = process.inputReader(StandardCharsets.US_ASCII)) {
            List<Long> said = Arrays.stream(reader.readLine().split(" ")).map(Long::valueOf).toList();
            look.at(process.pid(), said);
        } finally {
            process.getOutputStream().close();
            process.waitFor();
        }
    }

    @Test
    void childrenAndGrandchildrenAreFound() throws Exception {
        run("sleep 1000 & one=$!; sh -c 'sleep 1000; :' & all=\"$one $!\"; echo $all", (leader, said) -> {
            List<Long> found = awaitSize(leader, 4);
            assertEquals(leader, found.get(0));
            assertTrue(found.containsAll(said), found + " without one of " + said);
            found.stream().skip(1).forEach(pid -> ProcessHandle.of(pid).ifPresent(ProcessHandle::destroyForcibly));
        });
    }

    private static List<Long> awaitSize(long leader, int size) {
        long end = System.nanoTime() + 30_000_000_000L;
        while (ProcessTree.of(leader).size() < size && System.nanoTime() < end) {
            Thread.onSpinWait();
        }
        List<Long> found = ProcessTree.of(leader);
        assertEquals(size, found.size(), found::toString);
        return found;
    }

    @Test
    void ofAProcessThatHasEndedThereIsOnlyItsNumber() throws Exception {
        Process process = new ProcessBuilder("true").start();
        process.waitFor();
        assertEquals(List.of(process.pid()), ProcessTree.of(process.pid()));
    }
}

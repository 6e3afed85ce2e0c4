package steward.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.match.MatchResult;

/** The Python starter plays whole races as a program of its own; skipped where there is no Python 3. */
@Tag("process")
class PythonStarterTest {

    @Test
    void itFinishesARaceWithoutAFaultAndEndsByItself() throws Exception {
        try (Starter starter = new Starter()) {
            MatchResult result = BundledBotMatches.play(BundledBotMatches.scene("mad-pod-racing"), 3, starter,
                BundledBotMatches.asBot(new Racer()));
            assertFalse(result.anyFault(), result.toString());
            assertTrue(result.ending().startsWith("finished"), result.toString());
            assertEquals(0, starter.status());
        }
    }

    /** The program behind pipes. */
    private static final class Starter implements Bot, AutoCloseable {

        private final Process process;
        private final BufferedWriter to;
        private final BufferedReader from;

        Starter() {
            process = start();
            to = process.outputWriter();
            from = process.inputReader();
        }

        private static Process start() {
            try {
                return new ProcessBuilder("python3", "src/bots/python/starter.py")
                    .redirectError(ProcessBuilder.Redirect.INHERIT).start();
            } catch (IOException missing) {
                Assumptions.abort("no python3: " + missing.getMessage());
                throw new IllegalStateException(missing);
            }
        }

        @Override
        public void setup(String line) {
            send(line);
        }

        @Override
        public String turn(String line) {
            send(line);
            try {
                return from.readLine();
            } catch (IOException broken) {
                throw new UncheckedIOException(broken);
            }
        }

        @Override
        public void end(String line) {
            send(line);
        }

        private void send(String line) {
            try {
                to.write(line);
                to.write('\n');
                to.flush();
            } catch (IOException broken) {
                throw new UncheckedIOException(broken);
            }
        }

        int status() throws InterruptedException {
            assertTrue(process.waitFor(10, TimeUnit.SECONDS), "still running after the end frame");
            return process.exitValue();
        }

        @Override
        public void close() {
            process.destroyForcibly();
        }
    }
}

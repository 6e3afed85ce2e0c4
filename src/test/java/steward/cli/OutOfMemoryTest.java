package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.cli.shared.ErrorHandler;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.OutOfMemory;
import steward.cli.streams.Streams;

/** When the memory does not suffice: one line with advice, and exit status 1, wherever it happened. */
@Tag("process")
class OutOfMemoryTest {

    private static final String LINE =
        "steward: out of memory: Java may use [0-9]+ MB here; JAVA_OPTS=-Xmx4g gives it 4 GB\n";

    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private String said() {
        return err.toString(StandardCharsets.UTF_8);
    }

    /** The output runs out of memory, in the midst of a command. */
    @Test
    void inTheThreadOfTheCommand() {
        OutputStream out = new OutputStream() {
            @Override
            public void write(int one) {
                throw new OutOfMemoryError("Java heap space");
            }
        };
        Streams streams = new Streams(out, err, false, false);
        assertEquals(ExitStatus.FAILED, Main.run(streams, "match", "--scene", "duel", "--bot", "builtin:racer",
            "--bot", "builtin:racer", "--seed", "1", "--no-deadline", "--sandbox", "off"));
        assertTrue(said().matches(LINE), said());
    }

    @Test
    void inAnotherThreadThatIsWaitedFor() {
        Streams streams = new Streams(OutputStream.nullOutputStream(), err, false, false);
        Exception problem = new IllegalStateException("a game", new CompletionException(new OutOfMemoryError("heap")));
        assertEquals(ExitStatus.FAILED, new ErrorHandler(streams).handleExecutionException(problem, null, null));
        assertTrue(said().matches(LINE), said());
    }

    @Test
    void causesThatGoRoundInACircle() {
        Exception one = new Exception("one");
        Exception other = new Exception("other", one);
        one.initCause(other);
        assertFalse(OutOfMemory.isBehind(one));
        assertFalse(OutOfMemory.isBehind(null));
    }
}

package steward.cli.streams;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

/** A command that is ended from outside while it closes what its last words need. */
class InterruptionTest {

    /** A league that ended by SIGTERM closed its database while its last table was read. */
    @Test
    void whatIsClosedAfterwardsIsThereUntilTheLastWord() throws InterruptedException {
        List<Thread> added = new ArrayList<>();
        EndHooks hooks = new EndHooks() {
            @Override
            public void add(Thread hook) {
                added.add(hook);
            }

            @Override
            public void remove(Thread hook) {
                added.remove(hook);
            }
        };
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        CountDownLatch telling = new CountDownLatch(1);
        CountDownLatch closing = new CountDownLatch(1);
        StringBuffer order = new StringBuffer();
        Interruption interruption = new Interruption(new Streams(InputStream.nullInputStream(), false,
            OutputStream.nullOutputStream(), err, false, false, hooks), () -> {
                telling.countDown();
                waitFor(closing);
                order.append("told ");
                return "two games are stored";
            });
        added.get(0).start();
        waitFor(telling);
        Thread main = new Thread(() -> {
            interruption.close();
            order.append("closed");
        });
        main.start();
        while (main.getState() != Thread.State.WAITING && main.isAlive()) {
            Thread.onSpinWait();
        }
        closing.countDown();
        main.join();
        assertEquals("told closed", order.toString());
        assertEquals("steward: interrupted; two games are stored\n", err.toString());
    }

    private static void waitFor(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException end) {
            throw new IllegalStateException(end);
        }
    }
}

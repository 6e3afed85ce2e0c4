package steward.bot.accounting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

class OwnThreadTest {

    private static final long PATIENCE_NANOS = 60_000_000_000L;

    private static void await(OwnThread.State expected, OwnThread thread) {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (thread.state() != expected && System.nanoTime() < end) {
            Thread.onSpinWait();
        }
        assertEquals(expected, thread.state());
    }

    @Test
    void aThreadThatWaitsIsAsleepAndOneThatSpinsIsAwake() throws InterruptedException {
        assumeTrue(Files.isSymbolicLink(Path.of("/proc/thread-self")), "there is no /proc/thread-self");
        OwnThread own = new OwnThread();
        CountDownLatch wake = new CountDownLatch(1);
        AtomicBoolean stop = new AtomicBoolean();
        Thread thread = new Thread(() -> {
            own.enter();
            try {
                wake.await();
                while (!stop.get()) {
                    Thread.onSpinWait();
                }
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
        });
        thread.start();
        await(OwnThread.State.ASLEEP, own);
        wake.countDown();
        await(OwnThread.State.AWAKE, own);
        stop.set(true);
        thread.join();
        await(OwnThread.State.UNKNOWN, own);
    }

    @Test
    void aThreadThatNeverEnteredIsUnknown() {
        assertEquals(OwnThread.State.UNKNOWN, new OwnThread().state());
    }
}

package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Threads that work until nothing is left. */
@Timeout(60)
class WorkerThreadsTest {

    @Test
    void eachWorksByItsNumber() throws InterruptedException {
        AtomicInteger sum = new AtomicInteger();
        WorkerThreads.run("test", 4, number -> () -> {
            sum.addAndGet(1 << 8 * number);
            return null;
        });
        assertEquals(0x01010101, sum.get());
    }

    /** The first thread would wait for ever: it must not be waited for before the failure of the second is seen. */
    @Test
    void theFailureOfOneEndsTheOthers() throws InterruptedException {
        for (Throwable failure : List.of(new IllegalArgumentException("no"), new AssertionError("never"))) {
            CountDownLatch interrupted = new CountDownLatch(1);
            Throwable thrown = assertThrows(Throwable.class, () -> WorkerThreads.run("test", 2, number -> () -> {
                if (number == 1 && failure instanceof Error error) {
                    throw error;
                } else if (number == 1) {
                    throw (RuntimeException) failure;
                }
                try {
                    new CountDownLatch(1).await();
                } catch (InterruptedException end) {
                    interrupted.countDown();
                }
                return null;
            }));
            assertSame(failure, thrown);
            assertTrue(interrupted.await(30, TimeUnit.SECONDS));
        }
    }

    @Test
    void whatNobodyExpectsNamesItsThreads() {
        IllegalStateException thrown = assertThrows(IllegalStateException.class,
            () -> WorkerThreads.run("test", 1, number -> () -> {
                throw new IOException("gone");
            }));
        assertEquals("the threads of the test", thrown.getMessage());
        assertEquals("gone", thrown.getCause().getMessage());
    }
}

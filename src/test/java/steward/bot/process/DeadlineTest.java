package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

/** Of an answer and its deadline exactly one wins, whatever the timing. */
class DeadlineTest {

    private final Semaphore expired = new Semaphore(0);
    private final AtomicBoolean hopeless = new AtomicBoolean();

    private final Deadline.Owner owner = new Deadline.Owner() {
        @Override
        public void expired() {
            expired.release();
        }

        @Override
        public boolean tick(long now) {
            return hopeless.get();
        }
    };

    private void assertExpires() throws InterruptedException {
        assertTrue(expired.tryAcquire(60, TimeUnit.SECONDS), "the deadline was missed");
    }

    @Test
    void anAnswerInTimeWins() {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        deadline.arm(5000);
        deadline.check(4999);
        assertTrue(deadline.postpone(5000, 6000));
        deadline.check(5999);
        assertTrue(deadline.complete(6000));
        deadline.check(7000);
        assertFalse(deadline.isExpired());
        assertEquals(0, expired.availablePermits());
    }

    @Test
    void aDeadlineThatHasPassedWins() throws InterruptedException {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        deadline.arm(5000);
        deadline.check(5001);
        assertExpires();
        assertFalse(deadline.postpone(5000, 6000));
        assertFalse(deadline.complete(5000));
        assertTrue(deadline.isExpired());
        assertEquals(5001, deadline.passedAt());
        assertTrue(deadline.claim());
        assertFalse(deadline.abandon());
    }

    @Test
    void anAbandonedThreadHasLost() throws InterruptedException {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        deadline.arm(5000);
        deadline.check(5000);
        assertExpires();
        assertTrue(deadline.abandon());
        assertFalse(deadline.claim());
        assertFalse(deadline.complete(5000));
    }

    @Test
    void aHopelessWaitEndsBeforeItsDeadline() throws InterruptedException {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        deadline.arm(Long.MAX_VALUE);
        deadline.check(Long.MAX_VALUE - 1);
        assertEquals(0, expired.availablePermits());
        hopeless.set(true);
        deadline.check(5000);
        assertExpires();
        assertTrue(deadline.claim());
    }

    @Test
    void theWatchdogNeedNotWakeUpForTurnsThatAreAnswered() {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        long tick = Watchdog.TICK;
        assertEquals(1000 + tick, deadline.nextLook(1000));
        deadline.arm(5000);
        assertEquals(5000, deadline.nextLook(1000));
        assertTrue(deadline.complete(5000));
        assertEquals(5000, deadline.nextLook(1000));
        assertEquals(6000 + tick, deadline.nextLook(6000));
        deadline.arm(Long.MAX_VALUE);
        assertEquals(1000 + tick, deadline.nextLook(1000));
        assertTrue(deadline.complete(Long.MAX_VALUE));
        assertEquals(1000 + tick, deadline.nextLook(1000));
    }

    @Test
    void theWatchdogSeesEveryDeadlineOfManyPlayers() throws InterruptedException {
        long seed = new Random().nextLong();
        Thread[] players = new Thread[8];
        AtomicBoolean missed = new AtomicBoolean();
        for (int p = 0; p < players.length; p++) {
            Random random = new Random(seed + p);
            players[p] = new Thread(() -> {
                if (!play(random)) {
                    missed.set(true);
                }
            });
            players[p].start();
        }
        for (Thread player : players) {
            player.join();
        }
        assertFalse(missed.get(), "a deadline was missed; seed " + seed);
    }

    /** Answers half of its turns at once and waits for the deadline in the others; false when it waited in vain. */
    private static boolean play(Random random) {
        Semaphore passed = new Semaphore(0);
        Deadline deadline = new Deadline(Watchdog.shared(), new Deadline.Owner() {
            @Override
            public void expired() {
                passed.release();
            }

            @Override
            public boolean tick(long now) {
                return false;
            }
        });
        Watchdog.shared().add(deadline);
        try {
            for (int turn = 0; turn < 100; turn++) {
                long time = Watchdog.now() + 1 + random.nextInt(2_000_000);
                deadline.arm(time);
                boolean answered = random.nextBoolean() && deadline.complete(time);
                if (!answered && !(passed.tryAcquire(60, TimeUnit.SECONDS) && deadline.claim())) {
                    return false;
                }
            }
            return true;
        } catch (InterruptedException e) {
            return false;
        } finally {
            Watchdog.shared().remove(deadline);
        }
    }
}

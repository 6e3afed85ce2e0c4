package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** Of an answer and its deadline exactly one wins, whatever the timing. */
class DeadlineTest {

    private final Semaphore expired = new Semaphore(0);
    /** Answer of the owner at a look. */
    private final AtomicLong answer = new AtomicLong();
    private long overslept;

    private final Deadline.Owner owner = new Deadline.Owner() {
        @Override
        public void expired() {
            expired.release();
        }

        @Override
        public long look(long now, long late) {
            overslept = late;
            return answer.get();
        }
    };

    @Test
    void anAnswerInTimeWins() {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        deadline.arm(1000, 5000);
        answer.set(6000);
        deadline.check(4999, 7);
        assertEquals(7, overslept);
        assertTrue(deadline.isPending());
        assertTrue(deadline.complete());
        assertFalse(deadline.isPending());
        answer.set(QuestionClock.PASSED);
        deadline.check(7000, 0);
        assertFalse(deadline.isExpired());
        assertEquals(0, expired.availablePermits());
    }

    private Deadline passed(long now) throws InterruptedException {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        deadline.arm(1000, 5000);
        answer.set(QuestionClock.PASSED);
        deadline.check(now, 0);
        assertTrue(expired.tryAcquire(60, TimeUnit.SECONDS), "the deadline was missed");
        return deadline;
    }

    @Test
    void aDeadlineThatHasPassedWins() throws InterruptedException {
        Deadline deadline = passed(5001);
        assertFalse(deadline.isPending());
        assertFalse(deadline.complete());
        assertTrue(deadline.isExpired());
        assertTrue(deadline.claim());
        assertFalse(deadline.abandon());
    }

    @Test
    void anAbandonedThreadHasLost() throws InterruptedException {
        Deadline deadline = passed(5000);
        assertTrue(deadline.abandon());
        assertFalse(deadline.claim());
        assertFalse(deadline.complete());
    }

    /** While the owner looks, the answer comes: the owner's verdict is void, and so is its next look. */
    @Test
    void anAnswerDuringTheLookWins() {
        Deadline[] one = new Deadline[1];
        one[0] = new Deadline(Watchdog.shared(), new Deadline.Owner() {
            @Override
            public void expired() {
                expired.release();
            }

            @Override
            public long look(long now, long late) {
                assertTrue(one[0].complete());
                return answer.get();
            }
        });
        for (long next : new long[] {QuestionClock.PASSED, 9000}) {
            answer.set(next);
            one[0].arm(1000, 5000);
            one[0].check(5000, 0);
            assertFalse(one[0].isExpired() || one[0].isPending());
        }
        assertEquals(0, expired.availablePermits());
    }

    /** Looks come a quarter of the limit after a question, so 4000 after the one at 1000. */
    @Test
    void theWatchdogNeedNotWakeUpForTurnsThatAreAnswered() {
        Deadline deadline = new Deadline(Watchdog.shared(), owner);
        long tick = Watchdog.TICK;
        assertEquals(1000 + tick, deadline.nextLook(1000));
        deadline.arm(1000, 5000);
        assertEquals(5000, deadline.nextLook(1000));
        assertTrue(deadline.complete());
        assertEquals(5000, deadline.nextLook(1000));
        assertEquals(6000 + 4000, deadline.nextLook(6000));
        deadline.arm(1000, Long.MAX_VALUE);
        assertEquals(1000 + tick, deadline.nextLook(1000));
        assertTrue(deadline.complete());
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
        AtomicLong due = new AtomicLong();
        Deadline deadline = new Deadline(Watchdog.shared(), new Deadline.Owner() {
            @Override
            public void expired() {
                passed.release();
            }

            @Override
            public long look(long now, long late) {
                return now < due.get() ? due.get() : QuestionClock.PASSED;
            }
        });
        Watchdog.shared().add(deadline);
        try {
            for (int turn = 0; turn < 100; turn++) {
                long now = Watchdog.now();
                due.set(now + 1 + random.nextInt(2_000_000));
                deadline.arm(now, due.get());
                boolean answered = random.nextBoolean() && deadline.complete();
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

package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.Answer;
import steward.bot.Player;
import steward.game.Game;
import steward.game.GameJson;

/** The loop when something fails: listeners that throw, players that are stuck, callers that are interrupted. */
@Timeout(20)
class RefereeThreadsTest {

    private final List<String> log = Collections.synchronizedList(new ArrayList<>());

    /** Throws in one of the calls. */
    private record Throwing(String where, Throwable problem) implements MatchListener {

        private void at(String call) {
            if (call.equals(where)) {
                if (problem instanceof Error error) {
                    throw error;
                }
                throw (RuntimeException) problem;
            }
        }

        @Override
        public void start(Game game, GameJson codec) {
            at("start");
        }

        @Override
        public void commands(Turn turn) {
            at("commands");
        }

        @Override
        public void played(Turn turn) {
            at("played");
        }

        @Override
        public void end(MatchResult result) {
            at("end");
        }
    }

    private Referee referee(MatchListener listener, Player... players) {
        return new Referee(TestScenes.duel(players.length), 1, List.of(players), TimeControl.UNLIMITED, listener);
    }

    private ScriptedPlayer idle(String name) {
        return new ScriptedPlayer(name, log, ScriptedPlayer::idle);
    }

    @ParameterizedTest
    @ValueSource(strings = {"start", "commands", "played", "end"})
    void whatAListenerThrowsReachesTheCallerAndThePlayersAreClosed(String where) {
        RuntimeException problem = new IllegalStateException("full disk");
        Referee referee = referee(new Throwing(where, problem), idle("A"), idle("B"));

        assertSame(problem, assertThrows(IllegalStateException.class, referee::play));
        // The end is told to the players first: what they say then still counts.
        String how = where.equals("end") ? " end" : " close";
        assertEquals(List.of("A" + how, "B" + how), log.subList(log.size() - 2, log.size()));
    }

    @Test
    void anErrorReachesTheCallerAsTheCause() {
        Error problem = new StackOverflowError("deep");
        Referee referee = referee(new Throwing("played", problem), idle("A"), idle("B"));

        assertSame(problem, assertThrows(CompletionException.class, referee::play).getCause());
        assertTrue(log.contains("A close") && log.contains("B close"));
    }

    /** The caller gets the first exception, and does not wait for ever. */
    @Test
    void aPlayerThatCannotBeClosedKeepsNobodyWaiting() throws Exception {
        CompletableFuture<Throwable> uncaught = new CompletableFuture<>();
        RuntimeException problem = new IllegalStateException("full disk");
        ScriptedPlayer bad = new ScriptedPlayer("B", log, ScriptedPlayer::idle) {
            @Override
            public void close() {
                Thread.currentThread().setUncaughtExceptionHandler((thread, thrown) -> uncaught.complete(thrown));
                throw new IllegalStateException("cannot be closed");
            }
        };
        Referee referee = referee(new Throwing("played", problem), idle("A"), bad);

        assertSame(problem, assertThrows(IllegalStateException.class, referee::play));
        assertEquals("cannot be closed", uncaught.get(10, TimeUnit.SECONDS).getMessage());
    }

    /** Blocks in {@code ask} until it is released; meanwhile another thread is handed the fault. */
    private final class StuckPlayer extends ScriptedPlayer {

        private final int stuckAt;
        private final CountDownLatch letGo = new CountDownLatch(1);
        private final CountDownLatch left = new CountDownLatch(1);
        private volatile Thread stuckThread;
        private int questions;

        StuckPlayer(String name, int stuckAt) {
            super(name, RefereeThreadsTest.this.log, ScriptedPlayer::idle);
            this.stuckAt = stuckAt;
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            if (++questions < stuckAt) {
                return super.ask(frame, length, answerLines, limitNanos, answer);
            }
            stuckThread = Thread.currentThread();
            Answer fault = new Answer();
            fault.setFault("no answer within 75 ms, and it cannot be stopped");
            fault.setNanos(175_000_000L);
            Thread rescue = new Thread(() -> continuation().accept(fault));
            rescue.setDaemon(true);
            rescue.start();
            try {
                letGo.await(10, TimeUnit.SECONDS);
            } catch (InterruptedException nobodyDoes) {
                throw new AssertionError(nobodyDoes);
            }
            left.countDown();
            return Ending.ABANDONED;
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void aStuckPlayerIsLeftBehindAndTheMatchGoesOn(int stuckAt) throws InterruptedException {
        StuckPlayer stuck = new StuckPlayer("B", stuckAt);
        ScriptedPlayer last = new ScriptedPlayer("C", log,
            k -> k < stuckAt + 3 ? ScriptedPlayer.idle(k) : ScriptedPlayer.FAULT + "late");

        MatchResult result = referee(new MatchListener() { }, idle("A"), stuck, last).play();

        assertEquals(List.of(0, 1, 1), result.players().stream().map(MatchResult.PlayerResult::rank).toList());
        assertEquals("no answer within 75 ms, and it cannot be stopped", result.players().get(1).fault());
        assertEquals(stuckAt + 3, result.turns());
        assertEquals(stuckAt, result.players().get(1).answers());
        List<String> seen = List.copyOf(log);
        assertEquals(seen.indexOf("B close") + 1, seen.indexOf("C ask " + stuckAt), "asked in the same turn");

        stuck.letGo.countDown();
        assertTrue(stuck.left.await(10, TimeUnit.SECONDS));
        awaitOutOfTheLoop(stuck.stuckThread);
        assertEquals(seen, log, "the thread that was stuck has touched nothing");
    }

    /** The thread is kept for other work, or has ended. */
    private static void awaitOutOfTheLoop(Thread thread) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
        String loop = Referee.class.getName();
        while (Arrays.stream(thread.getStackTrace()).anyMatch(at -> at.getClassName().equals(loop))) {
            assertTrue(System.nanoTime() < end, "it is still in the loop");
            Thread.sleep(1);
        }
    }

    @Test
    void theLastPlayerStuckToo() throws InterruptedException {
        StuckPlayer stuck = new StuckPlayer("B", 2);

        MatchResult result = referee(new MatchListener() { }, idle("A"), stuck).play();

        stuck.letGo.countDown();
        assertEquals(0, result.winner());
        assertEquals(2, result.turns());
        assertEquals("A end", log.get(log.size() - 1));
    }

    @Test
    void twoStuckInOneTurn() throws InterruptedException {
        StuckPlayer first = new StuckPlayer("A", 2);
        StuckPlayer second = new StuckPlayer("B", 2);

        MatchResult result = referee(new MatchListener() { }, first, second).play();

        first.letGo.countDown();
        second.letGo.countDown();
        assertEquals(-1, result.winner());
        assertEquals(2, result.turns());
    }

    @Test
    void whatAListenerThrowsAfterAnAbandonedQuestionReachesTheCallerToo() {
        RuntimeException problem = new IllegalStateException("full disk");
        StuckPlayer stuck = new StuckPlayer("B", 1);
        Referee referee = referee(new Throwing("played", problem), idle("A"), stuck);

        assertSame(problem, assertThrows(IllegalStateException.class, referee::play));
        stuck.letGo.countDown();
    }

    /** A player that thinks until it is closed, and then fails, as a killed program does. */
    private final class Thinker extends ScriptedPlayer {

        private final CountDownLatch asked = new CountDownLatch(1);
        private final CountDownLatch closed = new CountDownLatch(1);
        private volatile Thread thread;

        Thinker(String name) {
            super(name, RefereeThreadsTest.this.log, k -> FAULT + "killed");
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            thread = Thread.currentThread();
            asked.countDown();
            try {
                closed.await();
            } catch (InterruptedException nobodyDoes) {
                throw new AssertionError(nobodyDoes);
            }
            return super.ask(frame, length, answerLines, limitNanos, answer);
        }

        @Override
        public void finish(byte[] lines, int length) {
            super.finish(lines, length);
            closed.countDown();
        }
    }

    @Test
    void anInterruptedCallerLeavesClosedPlayersAndNoInventedTurn() throws InterruptedException {
        Thinker thinker = new Thinker("A");
        List<String> heard = Collections.synchronizedList(new ArrayList<>());
        Referee referee = referee(new MatchListener() {
            @Override
            public void commands(Turn turn) {
                heard.add("turn " + turn.number() + " " + turn.fault(0));
            }
        }, thinker, idle("B"));
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        Thread caller = new Thread(() -> thrown.set(assertThrows(InterruptedException.class, referee::play)));
        caller.start();
        assertTrue(thinker.asked.await(10, TimeUnit.SECONDS));

        caller.interrupt();
        caller.join(10_000);
        awaitOutOfTheLoop(thinker.thread);

        assertTrue(thrown.get() instanceof InterruptedException);
        assertTrue(log.contains("A close") && log.contains("B close"), log::toString);
        assertFalse(log.contains("B ask 1"), "nobody is asked after the players were closed");
        assertEquals(List.of(), heard, "a turn that was broken off is not recorded as a fault");
    }
}

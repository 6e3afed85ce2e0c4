package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.Answer;
import steward.bot.Player;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.match.DirectBot;
import steward.match.MatchListener;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TimeControl;
import steward.match.Turn;

/**
 * The referee loop allocates nothing from turn to turn: frames, answers, the turn itself and its line in a replay,
 * counted by the JVM to the byte. Turns with an event are not counted: its text is made when a line tells it.
 */
@Execution(ExecutionMode.CONCURRENT)
class MatchAllocationTest {

    /** One match is played every time; what the JVM itself adds once does not show in every count. */
    private static final int COUNTS = 5;
    private static final int TURNS = 100;
    private static final byte[] ANSWER = ("{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":80},"
        + "{\"x\":100,\"y\":200,\"thrust\":70}]}").getBytes(StandardCharsets.UTF_8);

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final GameSetup setup = TestScenes.open("mad-pod-racing");

    /** Counts what is allocated from the end of one turn to the end of the next. */
    private final class Counter implements MatchListener {

        private final MatchListener writer;
        private final long[] least = new long[TURNS + 2];
        private int impacts;
        private Game game;
        private long before;

        Counter(MatchListener writer) {
            this.writer = writer;
            Arrays.fill(least, Long.MAX_VALUE);
        }

        @Override
        public void start(Game started, GameJson codec) {
            game = started;
            writer.start(started, codec);
        }

        @Override
        public void commands(Turn turn) {
            writer.commands(turn);
        }

        @Override
        public void played(Turn turn) {
            writer.played(turn);
            long now = threads.getCurrentThreadAllocatedBytes();
            if (turn.number() <= TURNS && game.events().isEmpty()) {
                least[turn.number()] = now - before;
            }
            impacts += game.log().impacts();
            before = threads.getCurrentThreadAllocatedBytes();
        }
    }

    /** Pods of both players meet in the middle of the map. */
    private static final class Direct implements DirectBot {
        private PodSeat seat;

        @Override
        public void start(Game game, int player) {
            seat = new PodSeat((PodRace) game, player);
        }

        @Override
        public void turn() {
            seat.thrust(seat.first(), 8000, 4500, 80);
            seat.thrust(seat.first() + 1, 100, 200, 70);
        }
    }

    /** Gives the same commands as a line. */
    private static final class SameLine implements Player {
        @Override
        public String name() {
            return "same line";
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            answer.clear();
            answer.append(ANSWER, 0, ANSWER.length);
            return Ending.ANSWERED;
        }
    }

    private void check(Supplier<Seat> seat, Supplier<MatchListener> writer) throws InterruptedException {
        long[] least = new long[TURNS + 2];
        Arrays.fill(least, Long.MAX_VALUE);
        int impacts = 0;
        for (int count = 0; count < COUNTS; count++) {
            Counter counter = new Counter(writer.get());
            Referee.of(setup, 1, List.of(seat.get(), seat.get()), TimeControl.UNLIMITED, counter).play();
            for (int turn = 0; turn < least.length; turn++) {
                least[turn] = Math.min(least[turn], counter.least[turn]);
            }
            impacts = counter.impacts;
        }
        assertTrue(impacts > 10, impacts + " impacts");
        StringBuilder found = new StringBuilder();
        for (int turn = TURNS / 2; turn <= TURNS; turn++) {
            found.append(least[turn] > 0 && least[turn] < Long.MAX_VALUE ? " turn " + turn + ": " + least[turn] : "");
        }
        assertEquals("", found.toString(), "bytes");
    }

    @Test
    void directBotsWithoutAReplay() throws InterruptedException {
        check(() -> Seat.direct("bot", new Direct()), () -> new MatchListener() { });
    }

    @Test
    void directBotsWithAReplay() throws InterruptedException {
        check(() -> Seat.direct("bot", new Direct()), MatchAllocationTest::replay);
    }

    @Test
    void linesWithAReplay() throws InterruptedException {
        check(() -> new Seat(new SameLine(), Protocol.JSON), MatchAllocationTest::replay);
    }

    private static MatchListener replay() {
        List<String> names = List.of("a", "b");
        return new ReplayWriter(OutputStream.nullOutputStream(), new ReplayHeader("pod-race",
            TestScenes.open("mad-pod-racing").scene().json(), 1, names, names, Double.POSITIVE_INFINITY));
    }
}

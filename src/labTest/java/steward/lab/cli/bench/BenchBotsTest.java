package steward.lab.cli.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.InProcessPlayer;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.game.podrace.PodState;
import steward.lab.bench.section.MatchFixture;
import steward.match.Dialogue;
import steward.match.DirectBot;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.Scene;

/** Bots that read the game directly: the same matches as by lines, and nothing allocated in a turn. */
class BenchBotsTest {

    private static final MatchListener NO_LISTENER = new MatchListener() { };
    private final MatchFixture fixture = BenchSuite.fixture();

    private Seat direct(String name) {
        return Seat.direct(name, new BenchDirectBot());
    }

    private Seat lines(String name) {
        return new Seat(new InProcessPlayer(name, new BenchLineBot()), Protocol.JSON);
    }

    private ReplayWriter writer(OutputStream file, long seed) {
        Scene scene = fixture.setup().scene();
        return new ReplayWriter(file, new ReplayHeader(scene.gameId(), scene.json(), seed,
            List.of("a", "b"), List.of("a", "b"), 1));
    }

    private String recording(long seed, List<Seat> seats) throws InterruptedException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        Referee.of(fixture.setup(), seed, seats, TimeControl.UNLIMITED, writer(file, seed)).play();
        return file.toString(StandardCharsets.UTF_8).replaceAll(",\"times\":\\{[^}]*}", "");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aRecordingIsTheSameByLinesAndWithout(long seed) throws InterruptedException {
        String byLines = recording(seed, List.of(lines("a"), lines("b")));

        assertTrue(byLines.lines().count() > 50);
        assertEquals(byLines, recording(seed, List.of(direct("a"), direct("b"))));
        assertEquals(byLines, recording(seed, List.of(lines("a"), direct("b"))), "side by side");
    }

    @Test
    void whatABotThrowsIsItsFault() throws InterruptedException {
        DirectBot wild = new DirectBot() {
            private PodSeat seat;

            @Override
            public void start(Game game, int player) {
                seat = new PodSeat((PodRace) game, player);
            }

            @Override
            public void turn() {
                seat.thrust(seat.first(), 0, 0, 201);
            }
        };
        MatchResult result = Referee.of(fixture.setup(), 1, List.of(Seat.direct("wild", wild), direct("b")),
            TimeControl.UNLIMITED, NO_LISTENER).play();

        assertEquals("threw java.lang.IllegalArgumentException: thrust: found 201, expected 0..200",
            result.players().get(0).fault());
        assertEquals(1, result.winner());
    }

    @Test
    void commandsAreCheckedAsThoseOfLines() {
        PodSeat seat = new PodSeat((PodRace) fixture.setup().create(1), 1);

        assertEquals(2, seat.first());
        assertThrows(IllegalArgumentException.class, () -> seat.thrust(1, 0, 0, 100), "another player's pod");
        assertThrows(IllegalArgumentException.class, () -> seat.thrust(4, 0, 0, 100));
        assertThrows(IllegalArgumentException.class, () -> seat.thrust(2, Double.NaN, 0, 100));
        assertThrows(IllegalArgumentException.class, () -> seat.boost(2, 0, Double.POSITIVE_INFINITY));
        assertThrows(IllegalArgumentException.class, () -> seat.thrust(2, 0, 0, -1));
    }

    @Test
    void anInterruptedCallerPlaysNoFurther() {
        Thread.currentThread().interrupt();
        assertThrows(InterruptedException.class, () -> Referee.of(fixture.setup(), 1, List.of(direct("a"), direct("b")),
            TimeControl.UNLIMITED, NO_LISTENER).play());
    }

    /** Turns without impacts, each played in several matches: what the JVM allocates once does not count. */
    @Test
    void aRecordedTurnAllocatesNothing() throws InterruptedException {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long[] least = new long[500];
        java.util.Arrays.fill(least, Long.MAX_VALUE);
        boolean[] quiet = new boolean[500];
        for (int match = 0; match < 40; match++) {
            ReplayWriter writer = writer(OutputStream.nullOutputStream(), 1);
            List<Seat> seats = List.of(direct("a"), direct("b"));
            Referee.of(fixture.setup(), 1, seats, TimeControl.UNLIMITED, new MatchListener() {
                private Game game;
                private long before;

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
                    int number = turn.number() - 1;
                    least[number] = Math.min(least[number], now - before);
                    quiet[number] = number > 0 && game.log().impacts() == 0 && game.events().isEmpty();
                    before = threads.getCurrentThreadAllocatedBytes();
                }
            }).play();
        }
        int counted = 0;
        for (int turn = 0; turn < least.length; turn++) {
            if (quiet[turn]) {
                assertEquals(0, least[turn], "bytes in turn " + (turn + 1));
                counted++;
            }
        }
        assertTrue(counted > 100, "hardly any turn was counted");
    }

    @Test
    void writingAFrameAndReadingAnAnswerAllocateNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        PodRace game = (PodRace) fixture.setup().create(1);
        Dialogue dialogue = Dialogue.of(Protocol.JSON, fixture.setup(), game, fixture.setup().codec(game),
            Map.of());
        byte[] answer = "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50},{\"x\":-80,\"y\":45,\"shield\":true}]}"
            .getBytes(StandardCharsets.UTF_8);
        List<PodState[]> states = states();
        long least = Long.MAX_VALUE;
        for (int count = 0; count < 30 && least > 0; count++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int k = 0; k < 300; k++) {
                PodState[] pods = states.get(k % states.size());
                for (int pod = 0; pod < pods.length; pod++) {
                    game.setPod(pod, pods[pod]);
                }
                assertTrue(dialogue.turn(k % 2).size() > 300);
                assertTrue(dialogue.readAnswer(k % 2, answer, answer.length) == null);
            }
            least = threads.getCurrentThreadAllocatedBytes() - before;
        }
        assertEquals(0, least, "bytes for 300 frames and answers");
    }

    /** The pods of a race turn by turn, so that all have moved. */
    private List<PodState[]> states() {
        PodRace race = (PodRace) fixture.setup().create(1);
        List<BenchDirectBot> bots = List.of(new BenchDirectBot(), new BenchDirectBot());
        for (int player = 0; player < bots.size(); player++) {
            bots.get(player).start(race, player);
        }
        List<PodState[]> states = new ArrayList<>();
        while (!race.isOver()) {
            bots.forEach(BenchDirectBot::turn);
            race.play();
            states.add(IntStream.range(0, 4).mapToObj(race::pod).toArray(PodState[]::new));
        }
        return states;
    }
}

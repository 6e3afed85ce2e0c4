package steward.lab.cli.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
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
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.game.podrace.PodState;
import steward.lab.bench.section.MatchFixture;
import steward.match.Allocated;
import steward.match.Dialogue;
import steward.match.DirectBot;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
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

    @Test
    void writingAFrameReadingAnAnswerAndADirectBotAllocateNothing() {
        PodRace game = (PodRace) fixture.setup().create(1);
        Dialogue dialogue = Dialogue.of(Protocol.JSON, fixture.setup(), game, fixture.setup().codec(game),
            Map.of());
        byte[] answer = "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50},{\"x\":-80,\"y\":45,\"shield\":true}]}"
            .getBytes(StandardCharsets.UTF_8);
        List<PodState[]> states = states();
        BenchDirectBot bot = new BenchDirectBot();
        bot.start(game, 0);
        Allocated.assertNone(30, "300 frames and answers", () -> Allocated.by(() -> {
            for (int k = 0; k < 300; k++) {
                PodState[] pods = states.get(k % states.size());
                for (int pod = 0; pod < pods.length; pod++) {
                    game.setPod(pod, pods[pod]);
                }
                assertTrue(dialogue.turn(k % 2).size() > 300);
                assertTrue(dialogue.readAnswer(k % 2, answer, answer.length) == null);
                bot.turn();
            }
        }));
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

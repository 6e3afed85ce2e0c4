package steward.game.bodies;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.CodecText;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.TurnEvent;
import steward.match.TestScenes;
import steward.physics.TurnLog;

/** Zones that bodies reach in flight: when, in which order, and what has been taken out meets nothing. */
class ZonesTest {

    private static final List<String> EVENTS = List.of("event/official", "event/double", "event/compensated",
        "event/exact");

    private static GameSetup open(int players, String rung, String bodies, String zones) {
        String accuracy = rung.startsWith("step/") ? "\"step\", \"steps\": " + rung.substring(5)
            : "\"event\", \"arithmetic\": \"" + rung.substring(6) + "\"";
        return TestScenes.TYPES.open("{\"name\": \"s\", \"game\": \"bodies\", \"players\": " + players
            + ", \"field\": {\"width\": 1000, \"height\": 1000, \"walls\": \"box\"}, \"bodies\": {" + bodies
            + "}, \"play\": {\"maximumTurns\": 9" + (players > 0 ? ", \"maximumThrust\": 1" : "") + ", \"zones\": ["
            + zones + "]}, \"time\": {\"firstAnswerMs\": 1000, \"answerMs\": 100}, \"accuracy\": {\"advance\": "
            + accuracy + "}}", "s.json");
    }

    private static String disc(double x, double y, double vx, double vy, String more) {
        return "{\"x\": " + x + ", \"y\": " + y + ", \"vx\": " + vx + ", \"vy\": " + vy + ", \"radius\": 10" + more
            + "}";
    }

    private static String zone(double x, double y, String label, String more) {
        return "{\"x\": " + x + ", \"y\": " + y + ", \"radius\": 20, \"label\": \"" + label + "\"" + more + "}";
    }

    /** The centre flies 300 u a turn from 100.5: it touches the circle of 20 around 500 at (480 - 100.5) / 300. */
    @Test
    void aBodyReachesAZoneInFlight() {
        for (String rung : EVENTS) {
            Game game = open(0, rung, "\"listed\": [" + disc(100.5, 500, 300, 0, "") + "]",
                zone(500, 500, "hole", ", \"ends\": true")).create(0);
            game.play();
            assertTrue(!game.isOver());
            game.play();
            assertEquals("body 0 has reached the zone hole", game.ending());
            assertEquals(1, game.events().size());
            TurnEvent event = game.events().get(0);
            assertEquals((480 - 100.5) / 300, 1 + event.time(), 1e-15);
            assertEquals(480, event.x(), 1e-12);
        }
    }

    /** In the zone in flight, but not at the end of a turn: points are counted at rest if nothing else is said. */
    @Test
    void pointsAreForResting() {
        for (String when : List.of("", ", \"when\": \"resting\"", ", \"when\": \"passing\"")) {
            Game game = open(1, "event/double", "\"listed\": [" + disc(400, 500, 200, 0, ", \"owner\": 0") + "]",
                zone(500, 500, "hole", ", \"points\": 3" + when) + ", " + zone(790, 500, "end", ", \"points\": 10"))
                .create(0);
            game.play();
            assertArrayEquals(new double[] {when.contains("passing") ? 3 : 0}, game.scores());
            game.play();
            assertArrayEquals(new double[] {when.contains("passing") ? 13 : 10}, game.scores());
        }
    }

    /**
     * Player 0 reaches the goal at 0.3 of the turn, player 1 at 0.2: the game ends there, the points at 0.3 and those
     * for resting no longer count. Entered and left twice, by a wall, a zone counts twice.
     */
    @Test
    void entriesCountInTheOrderOfTime() {
        String bodies = "\"listed\": [" + disc(420, 500, 200, 0, ", \"owner\": 0") + ", "
            + disc(500, 560, 0, -200, ", \"owner\": 1") + "]";
        Game game = open(2, "event/double", bodies, zone(500, 500, "goal", ", \"points\": 1, \"ends\": true"))
            .create(0);
        game.play();
        assertArrayEquals(new double[] {0, 1}, game.scores());
        assertEquals("body 1 has reached the zone goal", game.ending());

        Game twice = open(1, "event/double", "\"listed\": [" + disc(900, 500, 400, 0, ", \"owner\": 0") + "]",
            zone(950, 500, "goal", ", \"points\": 1, \"when\": \"passing\"")).create(0);
        twice.play();
        assertArrayEquals(new double[] {2}, twice.scores());
        assertEquals(List.of(30 / 400.0, 110 / 400.0), twice.events().stream().map(TurnEvent::time).toList());
    }

    /**
     * The first disc would hit the second at 0.7 of the turn; it is taken out at 0.3, and nothing meets it after that.
     * <pre>
     *   0 -&gt;   (pocket)   1
     * </pre>
     */
    @ParameterizedTest
    @ValueSource(strings = {"event/official", "event/double", "event/compensated", "event/exact", "step/200"})
    void whatIsTakenOutMeetsNothing(String rung) {
        for (boolean crowd : new boolean[] {false, true}) {
            String bodies = "\"listed\": [" + disc(420, 500, 200, 0, "") + ", " + disc(580, 500, 0, 0, "") + "]"
                + (crowd ? ", \"fill\": {\"count\": 60, \"radius\": 5, \"shape\": \"lattice\", \"in\": {\"x\": 0, "
                + "\"y\": 700, \"width\": 1000, \"height\": 300}}" : "");
            Game game = open(0, rung, bodies, zone(500, 500, "pocket", ", \"removes\": true")).create(0);
            int size = game.bodies().size();
            game.play();
            assertEquals(size - 1, game.bodies().size());
            assertEquals(1, game.bodies().id(0));
            assertEquals(580, game.bodies().x[0]);
            assertEquals(0, game.log().impacts());
            assertEquals(TurnEvent.Kind.DEATH, game.events().get(0).kind());
            assertEquals(0.3, game.events().get(0).time(), 1e-15);
            game.play();
            assertTrue(game.events().isEmpty());
        }
    }

    /**
     * The first disc hits the second at 0.2, which is taken out on its way at 0.2 + 0.3; the third would have been hit
     * by it at 0.9 of the turn. The fourth is taken out before, at 0.45.
     */
    @Test
    void impactsBeforeAPocketStay() {
        String bodies = "\"listed\": [" + disc(400, 500, 200, 0, "") + ", " + disc(460, 500, 0, 0, "") + ", "
            + disc(620, 500, 0, 0, "") + ", " + disc(520, 850, 0, 200, "") + "]";
        for (String rung : EVENTS) {
            Game game = open(0, rung, bodies, zone(540, 500, "a", ", \"removes\": true") + ", "
                + zone(520, 960, "b", ", \"removes\": true")).create(0);
            game.play();
            assertEquals(List.of("3 zone b", "1 zone a"), game.events().stream()
                .map(event -> event.body() + " " + event.text()).toList());
            assertEquals(0.45, game.events().get(0).time(), 1e-15);
            assertEquals(0.5, game.events().get(1).time(), 1e-15);
            assertEquals(1, game.log().impacts());
            assertEquals(440, game.bodies().x[0]);
            assertEquals(620, game.bodies().x[1]);
        }
    }

    /** Eighty discs and four large pockets: every rung and both ways to find impacts, again and again. */
    @Test
    void aCrowdInPocketsIsTheSameEveryTime() {
        for (String rung : EVENTS) {
            GameSetup setup = open(0, rung, "\"fill\": {\"count\": 80, \"radius\": [10, 20], \"speed\": [100, 300], "
                + "\"restitution\": 0.9}", IntStream.range(0, 4).mapToObj(k -> zone(k % 2 * 960 + 20, k / 2 * 960 + 20,
                "p" + k, ", \"removes\": true").replace("\"radius\": 20", "\"radius\": 60"))
                .collect(Collectors.joining(", ")));
            Game game = setup.create(5);
            Game again = setup.create(5);
            int deaths = 0;
            while (!game.isOver()) {
                game.play();
                again.play();
                assertEquals(game.hash(), again.hash());
                deaths += (int) game.events().stream().filter(event -> event.kind() == TurnEvent.Kind.DEATH).count();
                TurnLog log = game.log();
                for (TurnEvent event : game.events()) {
                    for (int k = 0; k < log.kept(); k++) {
                        boolean takesPart = log.impactA(k) == event.body() || log.impactB(k) == event.body();
                        assertTrue(!takesPart || log.impactTime(k) <= event.time(), "an impact after its end");
                    }
                }
            }
            assertTrue(deaths > 5, deaths + " were taken out");
            assertEquals(80 - deaths, game.bodies().size());
        }
    }

    /** A bot of lines finds the disc at the centre of the zone that has taken it. */
    @Test
    void framesHaveWhatIsLeft() {
        GameSetup setup = open(1, "event/double", "\"listed\": [" + disc(450, 500, 100, 0, ", \"owner\": 0") + ", "
            + disc(100, 100, 0, 0, ", \"owner\": 0") + "]", zone(500, 500, "hole", ", \"removes\": true"));
        Game game = setup.create(0);
        game.play();
        assertEquals("0\n500 500 0 0\n100 100 0 0\n", CodecText.turn(setup.textCodec(game).orElseThrow(), 0));
        assertEquals(null, CodecText.read(setup.codec(game), 0, "{\"thrusts\":[{\"x\":1,\"y\":0},{\"x\":0,\"y\":1}]}"));
        game.play();
        assertEquals(1, game.bodies().vy[0]);
        Game copy = game.copy();
        game.play();
        copy.play();
        assertEquals(game.hash(), copy.hash());
    }

    /** Nobody is left. */
    @Test
    void itEndsWhenAllAreTakenOut() {
        Game game = open(0, "event/double", "\"listed\": [" + disc(450, 500, 50, 0, "") + "]",
            zone(500, 500, "hole", ", \"removes\": true, \"when\": \"resting\"")).create(0);
        game.play();
        assertEquals("no body is left", game.ending());
    }
}

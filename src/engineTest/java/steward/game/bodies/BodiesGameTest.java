package steward.game.bodies;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.game.CodecText;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.TextCodec;
import steward.match.TestScenes;

/** The rules of bodies: forces, thrusts, zones, points, ends. */
class BodiesGameTest {

    private static GameSetup open(int players, String bodies, String play) {
        return TestScenes.TYPES.open("{\"name\": \"s\", \"game\": \"bodies\", \"players\": " + players
            + ", \"field\": {\"width\": 1000, \"height\": 500}, \"bodies\": {\"listed\": [" + bodies
            + "]}, \"play\": {" + play + "}, \"time\": {\"firstAnswerMs\": 1000, \"answerMs\": 100}, "
            + "\"accuracy\": {\"advance\": \"event\", \"arithmetic\": \"double\"}}", "s.json");
    }

    /** An impulse moves by 1 / mass, gravity moves all alike, an infinite mass is moved by neither. */
    @Test
    void forceAndGravityWorkAtTheStartOfATurn() {
        Game game = open(0, "{\"x\": 100, \"y\": 100, \"radius\": 1, \"mass\": 2}, {\"x\": 200, \"y\": 100, "
            + "\"radius\": 1, \"mass\": \"infinite\"}", "\"maximumTurns\": 2, \"force\": {\"x\": 3, \"y\": 0}, "
            + "\"gravity\": {\"x\": 0, \"y\": 5}").create(0);
        game.play();
        assertEquals(101.5, game.bodies().x[0]);
        assertEquals(105, game.bodies().y[0]);
        assertEquals(200, game.bodies().x[1]);
        assertEquals(100, game.bodies().y[1]);
        game.play();
        assertEquals(104.5, game.bodies().x[0]);
        assertEquals("at most 2 turns are played", game.ending());
    }

    /** Speeds 8, 4, 2, 1: below 1.5 after the third turn. */
    @Test
    void itEndsWhenAllIsAtRest() {
        Game game = open(0, "{\"x\": 100, \"y\": 100, \"radius\": 1, \"vx\": 8, \"drag\": 0.5}",
            "\"maximumTurns\": 9, \"restBelow\": 1.5").create(0);
        while (!game.isOver()) {
            game.play();
        }
        assertEquals(3, game.turn());
        assertEquals("all bodies are slower than the scene's restBelow", game.ending());
    }

    /** A disc of radius 10 falls on a bumper: slow at the top of each bounce, at rest where it lies. */
    @Test
    void aBodyUnderGravityRestsInContact() {
        for (double restitution : new double[] {0.8, 1}) {
            Game game = open(0, "{\"x\": 500, \"y\": 100, \"radius\": 10, \"restitution\": " + restitution + "}, "
                + "{\"x\": 500, \"y\": 400, \"radius\": 90, \"mass\": \"infinite\"}",
                "\"maximumTurns\": 500, \"restBelow\": 0.9, \"gravity\": {\"x\": 0, \"y\": 2}").create(0);
            while (!game.isOver()) {
                game.play();
            }
            assertEquals(restitution == 1 ? "at most 500 turns are played"
                : "all bodies are slower than the scene's restBelow", game.ending());
            assertEquals(300, game.bodies().y[0], restitution == 1 ? 201 : 0.05);
        }
    }

    /**
     * Two discs of radius 10 on a bumper each, the second lets fall from 300 above: one rests, then both. Where nothing
     * loses speed there is nothing to count.
     */
    @Test
    void bodiesAtRestAreCounted() {
        String bodies = "{\"x\": 200, \"y\": 300, \"radius\": 10, \"restitution\": 0.5}, {\"x\": 600, \"y\": 100, "
            + "\"radius\": 10, \"restitution\": 0.5}, {\"x\": 200, \"y\": 400, \"radius\": 90, "
            + "\"mass\": \"infinite\"}, {\"x\": 600, \"y\": 400, \"radius\": 90, \"mass\": \"infinite\"}";
        Game game = open(0, bodies, "\"maximumTurns\": 200, \"gravity\": {\"x\": 0, \"y\": 2}").create(0);
        game.play();
        assertEquals(1, game.bodiesAtRest());
        while (!game.isOver()) {
            game.play();
        }
        assertEquals(2, game.bodiesAtRest());
        String elastic = bodies.replace("0.5", "1");
        assertEquals(-1, open(0, elastic, "\"maximumTurns\": 9").create(0).bodiesAtRest());
        assertEquals(2, open(0, elastic, "\"maximumTurns\": 9, \"restBelow\": 1").create(0).bodiesAtRest());
    }

    /**
     * Player 0 pushes its body onto that of player 1, and from there into the zone.
     * <pre>
     *   0 -&gt;   1 -&gt;       (zone)
     * </pre>
     */
    @Test
    void zonesAndContactsGivePoints() {
        GameSetup setup = open(2, "{\"x\": 100, \"y\": 100, \"radius\": 10, \"owner\": 0}, {\"x\": 150, \"y\": 100, "
            + "\"radius\": 10, \"owner\": 1}", "\"maximumTurns\": 9, \"maximumThrust\": 50, \"contactPoints\": 2, "
            + "\"zones\": [{\"x\": 170, \"y\": 100, \"radius\": 5, \"label\": \"hole\", \"points\": 7, "
            + "\"ends\": true}]");
        Game game = setup.create(0);
        assertNull(CodecText.read(setup.codec(game), 0, "{\"thrusts\":[{\"x\":50,\"y\":0}]}"));
        game.play();
        assertEquals(1, game.log().impacts());
        assertArrayEquals(new double[] {2, 9}, game.scores());
        assertArrayEquals(new int[] {1, 0}, game.ranks());
        assertEquals("body 1 has reached the zone hole", game.ending());
    }

    @Test
    void answersInLinesAndTheirErrors() {
        GameSetup setup = open(1, "{\"x\": 100, \"y\": 100, \"radius\": 10, \"owner\": 0}, {\"x\": 200, \"y\": 100, "
            + "\"radius\": 10, \"owner\": 0}", "\"maximumTurns\": 9, \"maximumThrust\": 5");
        Game game = setup.create(0);
        TextCodec lines = setup.textCodec(game).orElseThrow();
        assertEquals("0 1 2 0\n0 10 1\n0 10 1\n", CodecText.setup(lines, 0));
        assertEquals("0\n100 100 0 0\n200 100 0 0\n", CodecText.turn(lines, 0));
        assertEquals(2, lines.answerLines(0));
        assertEquals("line 2 of 2: found \"x 1\", expected two numbers X Y", CodecText.read(lines, 0, "0 0\nx 1"));
        assertEquals("line 1 of 2: found a thrust of length 5.830951894845301, expected at most 5.0",
            CodecText.read(lines, 0, "3 5\n0 0"));
        assertEquals("found 1 lines, expected 2", CodecText.read(lines, 0, "3 4"));
        assertNull(CodecText.read(lines, 0, "3 4 off we go\n-1 0.5"));
        assertEquals("off we go", lines.message(0));
        game.play();
        assertEquals(3, game.bodies().vx[0]);
        assertEquals(0.5, game.bodies().vy[1]);
    }

    /** A copy and its original go on alike, also when one player is out. */
    @Test
    void aCopyGoesOnAlike() {
        GameSetup setup = open(2, "{\"x\": 100, \"y\": 100, \"radius\": 10, \"owner\": 0, \"vx\": 9}, {\"x\": 150, "
            + "\"y\": 100, \"radius\": 10, \"owner\": 1}", "\"maximumTurns\": 9, \"maximumThrust\": 50");
        Game game = setup.create(0);
        game.play();
        Game copy = game.copy();
        game.play();
        copy.play();
        assertEquals(game.hash(), copy.hash());
        copy.eliminate(1, "a fault");
        copy.play();
        assertTrue(copy.isOver());
        assertArrayEquals(new double[] {0, -1}, copy.scores());
    }
}

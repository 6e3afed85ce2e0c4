package steward.game.podrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.CodecText;
import steward.game.podrace.PodRace;
import steward.game.podrace.Races;

/** CodinGame's lines of the lower leagues, one pod a player, and the scene for them. */
class SinglePodTextTest {

    private static final double[][] MAP = {{3000, 4500}, {9000, 4500}, {9000, 8000}};

    private final PodRace race = Races.setup("mad-pod-racing-silver").create(MAP);
    private final PodRaceText codec = new PodRaceText(race);

    private String turn(int player) {
        return CodecText.turn(codec, player);
    }

    private String answer(String line) {
        return CodecText.read(codec, 0, line);
    }

    @Test
    void thereIsNoSetupAndOneLineIsAnswered() {
        assertEquals("", CodecText.setup(codec, 0));
        assertEquals(1, codec.answerLines(0));
    }

    @Test
    void aTurnIsThePodItsCheckpointAndTheOpponent() {
        // From (3000, 4000) to (9000, 4500): sqrt(6000^2 + 500^2) = 6020.8; headings are unset at the start.
        assertEquals("3000 4000 9000 4500 6021 0\n3000 5000\n", turn(0));
        assertEquals("3000 5000 9000 4500 6021 0\n3000 4000\n", turn(1));
    }

    /** Headings against a checkpoint in the direction of x, of -x (180) and straight below (90). */
    @ParameterizedTest
    @CsvSource({"0, 1, 0, 0", "30, 1, 0, -30", "-30, 1, 0, 30", "350, 1, 0, 10", "190, 1, 0, 170", "170, 1, 0, -170",
        "180.4, 1, 0, 180", "179.6, 1, 0, -180", "0, -1, 0, 180", "10, -1, 0, 170", "-10, -1, 0, -170", "0, 0, 1, 90",
        "271, 0, 1, 179", "269, 0, 1, -179", "765, 1, 0, -45", "NaN, -1, 0, 0"})
    void theAngleIsRelativeToTheHeading(double heading, double dx, double dy, long expected) {
        assertEquals(expected, PodRaceText.relativeAngle(Math.toRadians(heading), dx, dy));
    }

    @Test
    void thrustIsAtMost100() {
        assertNull(answer("9000 4000 100"));
        assertEquals("line 1 of 1: thrust: found \"101\", expected a whole number 0..100, SHIELD or BOOST",
            answer("9000 4000 101"));
        assertNotNull(answer(""));
        assertNull(answer("9000 4000"));
        assertEquals(100, race.thrust(0));
    }

    @Test
    void aUsedUpBoostIsWorth100() {
        assertNull(answer("90000 4000 BOOST"));
        race.command(1, 3000, 5000, 0);
        race.play();
        assertEquals(552, race.pod(0).vx(), "650 x 0.85, cut");
        assertNull(answer("90000 4000 boost"));
        race.command(1, 3000, 5000, 0);
        race.play();
        assertEquals(554, race.pod(0).vx(), "(552 + 100) x 0.85, cut");
    }
}

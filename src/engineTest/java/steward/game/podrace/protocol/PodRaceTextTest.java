package steward.game.podrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.CodecText;
import steward.game.TextCodec;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Recordings;
import steward.match.TestScenes;

/** CodinGame's lines of the upper leagues, two pods a player: what bots see, and what they may answer. */
class PodRaceTextTest {

    private static final double[][] MAP = {{3000, 4500}, {9000, 4500}, {9000, 8000}};
    private static final int FULL = 200;

    private final PodRace race = Recordings.official().create(MAP);
    private final TextCodec codec = new PodRaceText(race);

    private static PodState pod(double heading, int passed) {
        return new PodState(3000, 4000, -12, 250, heading, 0, true, passed);
    }

    private String turn(int player) {
        return CodecText.turn(codec, player);
    }

    private String answer(String lines) {
        return CodecText.read(codec, 0, lines);
    }

    @Test
    void theSetupIsLapsAndCheckpoints() {
        assertEquals("3\n3\n3000 4500\n9000 4500\n9000 8000\n", CodecText.setup(codec, 1));
    }

    @Test
    void ownPodsComeFirstAndHeadingsAreUnsetAtTheStart() {
        // Start places beside checkpoint 0, which faces along x: offsets -500, +500, -1500, +1500 across.
        assertEquals("3000 4000 0 0 -1 1\n3000 5000 0 0 -1 1\n3000 3000 0 0 -1 1\n3000 6000 0 0 -1 1\n", turn(0));
        assertEquals("3000 3000 0 0 -1 1\n3000 6000 0 0 -1 1\n3000 4000 0 0 -1 1\n3000 5000 0 0 -1 1\n", turn(1));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "90, 90", "-90, 270", "359.4, 359", "359.5, 360", "-0.4, 360", "-0.6, 359", "720.4, 0",
        "-1081, 359", "NaN, -1"})
    void anglesAreWholeDegreesFrom0To360(double degrees, long expected) {
        assertEquals(expected, PodRaceText.angle(Math.toRadians(degrees)));
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 2", "2, 0", "3, 1", "8, 0"})
    void theNextCheckpointIsCountedModuloTheirNumber(int passed, int expected) {
        race.setPod(0, pod(0, passed));
        assertEquals("3000 4000 -12 250 0 " + expected, turn(0).lines().findFirst().orElseThrow());
    }

    @Test
    void oneLineForEachPod() {
        assertEquals(2, codec.answerLines(0));
        assertNull(answer("100 200 50\n300 400 0"));
        assertPod(0, 100, 200, 50);
        assertPod(1, 300, 400, 0);
    }

    private void assertPod(int pod, double x, double y, int thrust) {
        assertEquals(x, race.targetX(pod));
        assertEquals(y, race.targetY(pod));
        assertEquals(thrust, race.thrust(pod));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "1 2 3              | 1     | 2     | 3",
        "`  1   2 \t 3  `   | 1     | 2     | 3",
        "`1 2 3\r`          | 1     | 2     | 3",
        "-1 +2 200          | -1    | 2     | 200",
        "1.5 -2.75 3        | 1.5   | -2.75 | 3",
        "5. .5 3            | 5     | 0.5   | 3",
        "1.2e+06 -1E-3 3    | 1.2e6 | -1e-3 | 3",
        "-0 -0.0 3          | 0     | 0     | 3",
        "1 2 SHIELD         | 1     | 2     | -2",
        "1 2 shield         | 1     | 2     | -2",
        "1 2 Boost          | 1     | 2     | -3",
        "1 2                | 1     | 2     | 200",
        "1 2 007            | 1     | 2     | 7",
        "1 2 100.0          | 1     | 2     | 100",
        "1 2 3 SHIELD BOOST | 1     | 2     | 3"})
    void whatRealBotsPrint(String line, double x, double y, int thrust) {
        assertNull(answer(line + "\n7 7 7"));
        assertPod(0, x, y, thrust);
    }

    @Test
    void anythingBehindTheThirdWordIsAMessage() {
        assertNull(answer("1 2 3  Hallo, Welt: \"x\" \u00e4\u20ac\ud83d\ude80\t|  \\ 5 \r\n1 2 BOOST"));
        assertEquals("Hallo, Welt: \"x\" \u00e4\u20ac\ud83d\ude80\t|  \\ 5", codec.message(0));
        assertNull(answer("1 2 3 one\n1 2 3 two"));
        assertEquals("one | two", codec.message(0));
        assertNull(answer("1 2 3\n1 2 3"));
        assertNull(codec.message(0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "``          | line 1 of 2: found \"\", expected X Y and a thrust, SHIELD or BOOST",
        "WAIT        | line 1 of 2: found \"WAIT\", expected X Y and a thrust, SHIELD or BOOST",
        "1           | line 1 of 2: found \"1\", expected X Y and a thrust, SHIELD or BOOST",
        "a 2 3       | line 1 of 2: X: found \"a\", expected a finite number",
        "1 NaN 3     | line 1 of 2: Y: found \"NaN\", expected a finite number",
        "Infinity 1 3| line 1 of 2: X: found \"Infinity\", expected a finite number",
        "1e999 1 3   | line 1 of 2: X: found \"1e999\", expected a finite number",
        "0x1p3 1 3   | line 1 of 2: X: found \"0x1p3\", expected a finite number",
        "1d 1 3      | line 1 of 2: X: found \"1d\", expected a finite number",
        "1 2 201     | line 1 of 2: thrust: found \"201\", expected a whole number 0..200, SHIELD or BOOST",
        "1 2 -1      | line 1 of 2: thrust: found \"-1\", expected a whole number 0..200, SHIELD or BOOST",
        "1 2 NaN     | line 1 of 2: thrust: found \"NaN\", expected a whole number 0..200, SHIELD or BOOST",
        "1 2 5.5     | line 1 of 2: thrust: found \"5.5\", expected a whole number 0..200, SHIELD or BOOST",
        "1 2 FAST    | line 1 of 2: thrust: found \"FAST\", expected a whole number 0..200, SHIELD or BOOST"})
    void whatCannotBeUnderstoodIsTold(String line, String expected) {
        assertEquals(expected, answer(line + "\n1 2 3"));
    }

    /** Two blanks behind Y: the thrust is left out, and full. */
    @ParameterizedTest
    @CsvSource(ignoreLeadingAndTrailingWhitespace = false, value = {"1 2  hello,hello", "1 2  on my way 3,on my way 3",
        "1 2 \t go,go", "-10 20   x,x"})
    void aMessageWithoutThrustStandsBehindTwoBlanks(String line, String message) {
        assertNull(answer(line + "\n7 7 7"));
        assertEquals(FULL, race.thrust(0));
        assertEquals(message, codec.message(0));
    }

    private static String site(String line) {
        PodRace strict = ((PodRaceType.PodRaceSetup) TestScenes.changed("mad-pod-racing", "\"rules\": \"live\"",
            "\"rules\": \"live\", \"commands\": \"site\"")).create(MAP);
        TextCodec lines = new PodRaceText(strict);
        String wrong = CodecText.read(lines, 0, line + "\n7 7 7");
        return wrong != null ? wrong : strict.targetX(0) + " " + strict.targetY(0) + " " + strict.thrust(0) + " "
            + lines.message(0);
    }

    /** Lines that the published pattern takes; BOOST and a message behind a thrust are the live server's. */
    @ParameterizedTest
    @CsvSource(ignoreLeadingAndTrailingWhitespace = false, value = {"1 2 200,1.0 2.0 200 null",
        "1 2 BOOST,1.0 2.0 -3 null", "1 2 BOOST go,1.0 2.0 -3 go", "-1 -0 SHIELD,-1.0 0.0 -2 null",
        "1 2 200 some words,1.0 2.0 200 some words", "1 2 ,1.0 2.0 200 null", "1 2  go go,1.0 2.0 200 go go",
        "1\t 2\t100,1.0 2.0 100 null", "0001 000000002 0100,1.0 2.0 100 null", "1 2 5 x ,1.0 2.0 5 x "})
    void theSiteTakes(String line, String expected) {
        assertEquals(expected, site(line));
    }

    /** Each is taken leniently. */
    @ParameterizedTest
    @ValueSource(strings = {"1 2", "1.5 2 100", "+1 2 100", "1 2 shield", " 1 2 100", "1e5 2 100", "1 2 100.0",
        "1 2 Boost", "1234567890 2 100", "1 2 100 ", "1 2 SHIELD ", "1 2 100\r"})
    void theSiteRefuses(String line) {
        assertNull(answer(line + "\n7 7 7"));
        assertEquals("line 1 of 2: found \"" + line + "\", expected as the site does: X Y of at most nine digits, a "
            + "blank, and digits, SHIELD or BOOST; behind them nothing, or a blank and a message", site(line));
    }

    @Test
    void theSiteRefusesAThrustOutOfRange() {
        assertEquals("line 1 of 2: thrust: found \"201\", expected a whole number 0..200, SHIELD or BOOST",
            site("1 2 201"));
    }

    @Test
    void theSecondLineIsNamedAndTheFirstCounts() {
        assertEquals("line 2 of 2: found \"x\", expected X Y and a thrust, SHIELD or BOOST", answer("1 2 3\nx"));
        assertEquals(3, race.thrust(0));
        assertEquals(PodRace.NO_COMMAND, race.thrust(1));
        assertEquals("line 2 of 2: X: found \"" + "y".repeat(40) + "...\", expected a finite number",
            answer("1 2 3\n" + "y".repeat(5000) + " 2 3"));
    }

    @Test
    void aTargetThatIsNoWholeNumberIsAimedAtExactly() {
        PodRace other = Recordings.official().create(MAP);
        assertNull(answer("5000.25 4100.5 " + FULL + "\n5000 5000 0"));
        other.command(0, 5000.25, 4100.5, FULL);
        other.command(1, 5000, 5000, 0);
        race.play();
        other.play();
        assertEquals(other.pod(0), race.pod(0));
        assertEquals(StrictMath.atan2(100.5, 2000.25), race.pod(0).heading());
    }
}

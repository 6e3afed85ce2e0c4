package steward.game.searchrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.CodecText;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.game.TurnEvent;
import steward.game.searchrace.SearchRace;
import steward.game.searchrace.SearchRaceMaps;
import steward.numerics.SplitMix64;
import steward.scene.json.SceneException;

/** The rules, one at a time. The course leads to the right: checkpoints of radius 600 every 5000 u. */
@Execution(ExecutionMode.CONCURRENT)
class SearchRaceTest {

    private static final String COURSE = "0 0;5000 0;10000 0";

    private final SearchRace race = SearchRaces.onMap(COURSE);

    private void set(double x, double y, double vx, double vy, int degrees, int passed) {
        race.set(x, y, vx, vy, StrictMath.toRadians(degrees), passed, 10, 2);
    }

    private void turn(int degrees, int thrust) {
        race.turn(degrees, thrust);
        race.play();
    }

    private static void command(GameSetup setup, SearchRace game, SplitMix64 random) {
        assertEquals(null, CodecText.read(setup.codec(game), 0, setup.pilot(Pilot.Aim.WIN).answer(game, 0, random)));
    }

    /** 200 to the right, 85% of 200 kept; then 170 + 200 more, and 85% of 370 is 314.5, cut to 314. */
    @Test
    void thrustAddsToTheSpeedOfWhichMostIsKept() {
        turn(0, 200);
        assertEquals(200, race.bodies().x[0]);
        assertEquals(170, race.bodies().vx[0]);
        turn(0, 200);
        assertEquals(570, race.bodies().x[0]);
        assertEquals(314, race.bodies().vx[0]);
        assertEquals(0, race.bodies().y[0]);
    }

    /** Straight to the left of where it looks: 18 degrees and no more; cos 18 = 0.951057, sin 18 = 0.309017. */
    @Test
    void theCarTurnsByEighteenDegreesAtMost() {
        race.toward(0, 1000, 200);
        race.play();
        assertEquals(StrictMath.toRadians(18), race.heading(), 1e-15);
        assertEquals(190, race.bodies().x[0]);
        assertEquals(61, race.bodies().y[0]);
        assertEquals(161, race.bodies().vx[0]);
        assertEquals(52, race.bodies().vy[0]);
    }

    @Test
    void towardItsOwnPlaceThereIsNeitherTurnNorThrust() {
        set(100, 200, 0, 0, 30, 0);
        race.toward(100, 200, 200);
        race.play();
        assertEquals(100, race.bodies().x[0]);
        assertEquals(StrictMath.toRadians(30), race.heading(), 1e-15);
    }

    @ParameterizedTest
    @CsvSource({"350, 18, 8", "350, 10, 360", "10, -10, 0"})
    void headingsAreWholeDegreesFromZeroToThreeHundredAndSixty(int before, int by, double after) {
        set(100, 2000, 0, 0, before, 0);
        turn(by, 0);
        assertEquals(after, StrictMath.toDegrees(race.heading()), 1e-12);
    }

    /** At atan2(4000, 3000) = 53.13 degrees. */
    @Test
    void theStartLooksAtTheFirstCheckpointInWholeDegrees() {
        assertEquals(53, StrictMath.toDegrees(SearchRaces.onMap("0 0;3000 4000").heading()), 1e-12);
    }

    /** From x = 4300 at 200 a turn the edge at x = 4400 is reached after half a turn. */
    @Test
    void aCheckpointIsPassedAtTheTimeOfItsEdge() {
        set(4300, 0, 200, 0, 0, 0);
        turn(0, 0);
        assertEquals(1, race.passed());
        assertEquals(0.5, race.passTime());
        assertEquals(2, race.nextCheckpoint());
        TurnEvent event = race.events().get(0);
        assertEquals(0.5, event.time());
        assertEquals(4400, event.x());
        assertEquals("checkpoint 1", event.text());
        turn(0, 0);
        assertEquals(SearchRace.NOT_PASSED, race.passTime());
    }

    /** All three contain the place of the start: three laps are nine passes at time 0. */
    @Test
    void overlappingCheckpointsArePassedInOneTurn() {
        SearchRace all = SearchRaces.onMap("0 0;300 0;0 300");
        all.turn(0, 0);
        all.play();
        assertEquals(9, all.passed());
        assertTrue(all.isOver());
        assertEquals(0, all.scores()[0]);
        assertEquals(3, all.events().stream().filter(TurnEvent::headline).count());
    }

    /** With timer 10 and the last pass at 0.5 the time is 10.5. */
    @Test
    void theScoreIsTheTimeAndLowerIsBetter() {
        set(-700, 0, 200, 0, 0, 8);
        assertEquals(1000, race.scores()[0]);
        turn(0, 0);
        assertEquals("finished after 3 laps", race.ending());
        assertEquals(10.5, race.scores()[0]);
        assertTrue(race.lowerScoreIsBetter());
        assertThrows(IllegalStateException.class, race::play);
    }

    @ParameterizedTest
    @CsvSource({"598, -700, 8, 598.5, finished after 3 laps",
        "599, -700, 8, 1000, 'lost: finished in the last of 600 turns, too late to be declared'",
        "599, 5000, 0, 1000, lost: not finished in 600 turns"})
    void aFinishInTheLastTurnComesTooLate(int timer, double x, int passed, double score, String ending) {
        race.set(x, 0, 200, 0, 0, passed, timer, 2);
        turn(0, 0);
        assertEquals(score, race.scores()[0]);
        assertEquals(ending, race.ending());
    }

    @Test
    void aFaultLosesAtOnceAndTheCarStays() {
        set(100, 200, 300, 0, 0, 2);
        race.eliminate(0, "no answer within 50 ms");
        race.play();
        assertEquals("lost: no answer within 50 ms", race.ending());
        assertEquals(100, race.bodies().x[0]);
        assertEquals(10, race.timer());
        assertEquals(1000, race.scores()[0]);
    }

    /** The generic rungs fly in one go: the same rounded places, and times that differ by rounding alone. */
    @Test
    void otherRungsGiveTheSameRaces() {
        GameSetup official = SearchRaces.changed();
        GameSetup generic = SearchRaces.changed("\"arithmetic\": \"official\"", "\"arithmetic\": \"double\"");
        for (long seed = 0; seed < 10; seed++) {
            SearchRace one = (SearchRace) official.create(seed);
            SearchRace other = (SearchRace) generic.create(seed);
            while (!one.isOver()) {
                command(official, one, new SplitMix64(seed + one.turn()));
                command(generic, other, new SplitMix64(seed + other.turn()));
                one.play();
                other.play();
                String when = "seed " + seed + ", turn " + one.turn();
                assertEquals(one.bodies().x[0], other.bodies().x[0], when);
                assertEquals(one.bodies().vy[0], other.bodies().vy[0], when);
                assertEquals(one.passed(), other.passed(), when);
                assertEquals(one.passTime(), other.passTime(), 1e-9, when);
            }
            assertEquals(one.scores()[0], other.scores()[0], "seed " + seed);
        }
    }

    @Test
    void theMapIsOfficialOrTheSeedsOrAListOfPoints() {
        assertEquals(50, SearchRaceMaps.COUNT);
        assertEquals(List.of(1, 2, 7), SearchRaceMaps.numbers().subList(0, 3));
        assertEquals(704, SearchRaceMaps.numbers().get(49));
        SearchRace bySeed = SearchRaces.changed().create(51);
        assertEquals(11141, bySeed.checkpoints()[0][0], "51 mod 50 is 1, which is test 2");
        assertEquals(1000, SearchRaces.changed().create(-1).checkpoints()[0][0], "-1 mod 50 is 49, which is test 704");
        SearchRace numbered = SearchRaces.changed("\"by seed\"", "700").create(3);
        assertEquals(12000, numbered.checkpoints()[1][0]);
    }

    private static String refusal(String from, String to) {
        return assertThrows(SceneException.class, () -> SearchRaces.changed(from, to)).getMessage()
            .replaceFirst(":[0-9]+:[0-9]+:", ":");
    }

    @Test
    void scenesThatAreNoneAreRefusedWithTheirPlace() {
        assertEquals("search-race.json: map.official: found 3, expected the number of an official map: 1, 2, 7..50, "
            + "700, 701, 702 or 704", refusal("\"by seed\"", "3"));
        assertEquals("search-race.json: map.points: found 1 checkpoints, expected 2..64",
            refusal("\"official\": \"by seed\"", "\"points\": [ { \"x\": 1, \"y\": 2 } ]"));
        assertEquals("search-race.json: map: found official and points, expected one of them",
            refusal("\"by seed\"", "7, \"points\": []"));
        assertTrue(refusal("\"map\"", "\"pods\": {}, \"map\"").contains("pods"), "a block of another game");
        assertEquals("search-race.json: impacts: found a block, expected none: in a search race nothing meets anything",
            refusal("\"map\"", "\"impacts\": {}, \"map\""));
        assertTrue(refusal("\"map\"", "\"maps\"").contains("map"), "a block is missing");
    }
}

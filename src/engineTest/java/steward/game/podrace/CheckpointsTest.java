package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.TurnEvent;

/** When a checkpoint counts as passed. */
class CheckpointsTest {

    /** Checkpoint 1 at (5000, 0). */
    private static final double[][] AHEAD = {{0, 90_000}, {5000, 0}};

    /**
     * By live rules a path has to come nearer than the radius; by those of the contest it counts if it touches the
     * circle, and its start counts too. A pod at rest passes where it stands near enough. The path ends at the rounded
     * place: 600.4 before the checkpoint becomes 600, 600.6 becomes 601.
     * <pre>
     *   start o=========> end        at height d above the checkpoint
     *              ^
     *              d
     *              v
     *              1
     * </pre>
     */
    @ParameterizedTest
    @CsvSource({"4000, 600, 2000, 6000, 0, 1", "4000, 601, 2000, 6000, 0, 0", "4000, -600, 2000, 6000, 0, 1",
        "4000, -601, 2000, 6000, 0, 0", "4000, -599, 2000, 6000, 1, 1", "4000, 599, 2000, 6000, 1, 1",
        "4000, 0, 2000, 6000, 1, 1", "4400, 0, 0, 4400, 1, 1", "4399, 0, 0, 4399, 0, 0", "5600, 0, 0, 5600, 1, 1",
        "5601, 0, 0, 5601, 0, 0", "5600, 0, 100, 5700, 0, 1", "4300, 0, 99.6, 4400, 1, 1", "4300, 0, 99.4, 4399, 0, 0"})
    void aPathThatComesNearEnoughPasses(double x, double y, double vx, double end, int live, int contest) {
        for (boolean byLiveRules : new boolean[] {true, false}) {
            PodRace race = byLiveRules ? Races.official(AHEAD) : Races.contest(AHEAD);
            Races.put(race, 0, x, y, vx, 0);
            race.play();

            assertEquals(end, race.pod(0).x());
            assertEquals(byLiveRules ? live : contest, race.pod(0).passed());
        }
    }

    @Test
    void whoHasFinishedGoesOnToShowCheckpointZeroByLiveRules() {
        double[][] map = {{0, 0}, {9000, 0}};
        PodRace live = Races.official(map);
        PodRace contest = Races.contest(map);
        for (PodRace race : List.of(live, contest)) {
            Races.put(race, 0, 100, 0, 5);
            race.play();
            assertEquals("finished after 3 laps", race.ending());
        }

        assertEquals(0, live.nextCheckpoint(0));
        assertEquals(1, contest.nextCheckpoint(0));
        assertEquals(8900, live.toNext(0), "to the one behind the finish, which decides between two who finish");
    }

    /** Several in one turn, in their order; where the next one is not on the way, none. */
    @ParameterizedTest
    @CsvSource({"2000, 2", "8000, 0"})
    void onlyTheNextOneCounts(double x, int passed) {
        PodRace race = Races.official(new double[][] {{0, 90_000}, {3000, 0}, {4500, 0}, {9000, 0}});
        Races.put(race, 0, x, 0, 3000, 0);
        race.play();

        assertEquals(passed, race.pod(0).passed());
        assertEquals(1 + passed, race.nextCheckpoint(0));
        assertEquals(List.of("pod 0, checkpoint 1", "pod 0, checkpoint 2").subList(0, passed),
            race.events().stream().map(TurnEvent::text).toList());
    }

    @Test
    void aLapIsDoneAtCheckpointZero() {
        PodRace race = Races.official(new double[][] {{0, 0}, {90_000, 0}});
        Races.put(race, 0, 100, 0, 1);
        race.play();

        assertEquals(2, race.pod(0).passed());
        assertEquals(1, race.lap(0));
        assertEquals(1, race.nextCheckpoint(0));
        assertEquals("pod 0, lap 1 of 3 done", race.events().get(0).text());
        assertTrue(race.events().get(0).headline());
    }

    /**
     * Pod 0 flies right, hits the shielded pod 2 (mass 10) at x = 1200 and t = 0.6. With f = 2000 / 1.1 it is given
     * -2f and flies back at 1636, 654.5 in the rest of the turn, to 545. Its straight way from start to end stays 1155
     * away from the checkpoint; its path came as near as 500.
     * <pre>
     *   0 ---------------> corner       (1)
     *         end <-------- 1200        1700   2000: pod 2
     * </pre>
     */
    @Test
    void aCheckpointOnTheWayOfAPathThatAnImpactBent() {
        PodRace race = Races.official(new double[][] {{0, 90_000}, {1700, 0}});
        Races.put(race, 0, 0, 0, 2000, 0);
        Races.put(race, 2, 2000, 0, 0, 0);
        race.command(2, 90_000, 0, PodRace.SHIELD);
        race.play();

        assertEquals(1, race.log().impacts());
        assertEquals(0.6, race.log().impact(0).time());
        assertEquals(545, race.pod(0).x());
        assertEquals(1155, CheckpointSweep.distance(1700, 0, 0, 0, 545, 0));
        assertEquals(1, race.pod(0).passed());
    }

    @ParameterizedTest
    @CsvSource({"0, 3, 0, 0, 10, 0, 3", "-4, 3, 0, 0, 10, 0, 5", "14, 3, 0, 0, 10, 0, 5", "3, 4, 0, 0, 0, 0, 5",
        "5, 5, 0, 0, 10, 10, 0"})
    void distanceOfAPointFromASegment(double x, double y, double ax, double ay, double bx, double by, double expected) {
        assertEquals(expected, CheckpointSweep.distance(x, y, ax, ay, bx, by));
    }

    @Test
    void aPlayersTurnsStartAnewWhenEitherPodPasses() {
        PodRace race = Races.official(AHEAD);
        Races.coast(race, 10);
        assertEquals(90, race.turnsLeft(0));
        Races.put(race, 1, 5000, 0, 0, 0);
        race.play();

        assertEquals(100, race.turnsLeft(0));
        assertEquals(89, race.turnsLeft(1));
    }

    /** Pods of a player who is out pass nothing any more. */
    @Test
    void whoIsOutPassesNothing() {
        PodRace race = Races.duel(3, AHEAD);
        Races.put(race, 0, 5000, 0, 0, 0);
        race.eliminate(0, "for a test");
        race.play();

        assertEquals(0, race.pod(0).passed());
    }
}

package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;

/** Who is out, who wins, and in what order the others stand. */
class EndTest {

    /** On this map checkpoint 1 is at the origin; the duel has one lap and lets 50 turns pass without a checkpoint. */
    private static final double[][] MAP = {{90_000, 0}, {0, 0}};

    /** By live rules a player with 0 turns left is asked once more. */
    @Test
    void aPlayerIsOutAfterAHundredTurnsWithoutACheckpointAndByLiveRulesAfterOneMore() {
        isOutAfter(101, Races.official(MAP));
        isOutAfter(100, Races.contest(MAP));
    }

    private static void isOutAfter(int turns, PodRace race) {
        Races.coast(race, 1);
        Races.put(race, 3, 0, 0, 0, 0);
        Races.coast(race, turns - 2);
        assertTrue(race.isIn(0));
        race.play();

        assertEquals(100 - turns, race.turnsLeft(0));
        assertEquals("no checkpoint in " + turns + " turns", race.eliminationReason(0));
        assertNull(race.eliminationReason(1));
        assertTrue(race.isOver());
        assertEquals("all others are out", race.ending());
        assertArrayEquals(new int[] {1, 0}, race.ranks());
        assertArrayEquals(new double[] {-1, 1}, race.scores());
    }

    @Test
    void bothOutInOneTurnIsADraw() {
        PodRace race = Races.official(MAP);
        Races.coast(race, 101);

        assertEquals("all are out", race.ending());
        assertArrayEquals(new int[] {0, 0}, race.ranks());
    }

    @Test
    void aCheckpointInTheLastTurnSaves() {
        PodRace race = Races.official(MAP);
        Races.coast(race, 100);
        assertEquals(0, race.turnsLeft(0));
        Races.put(race, 0, 0, 0, 0, 0);
        race.play();

        assertTrue(race.isIn(0));
        assertFalse(race.isIn(1));
        assertEquals(100, race.turnsLeft(0));
    }

    /** The server's game 891670242: of two, one at -1 and one at 0, only the first is out. */
    @Test
    void byLiveRulesOnlyTheOneWithLessThanNoTurnsLeftIsOut() {
        PodRace race = Races.official(MAP);
        race.setTurnsLeft(0, 0);
        race.setTurnsLeft(1, 1);
        race.play();

        assertEquals(-1, race.turnsLeft(0));
        assertEquals(0, race.turnsLeft(1));
        assertEquals("all others are out", race.ending());
        assertArrayEquals(new int[] {1, 0}, race.ranks());
    }

    @Test
    void theThirdLapWins() {
        PodRace race = Races.official(MAP);
        Races.put(race, 2, 90_000, 0, 5);
        Races.put(race, 0, 80_000, 0, 5);
        race.play();

        assertEquals("finished after 3 laps", race.ending());
        assertArrayEquals(new int[] {1, 0}, race.ranks());
        assertArrayEquals(new double[] {5, 6}, race.scores());
    }

    @Test
    void bothFinishedInOneTurnIsADraw() {
        PodRace race = Races.official(MAP);
        Races.put(race, 1, 90_000, 500, 5);
        Races.put(race, 2, 90_000, -500, 5);
        race.play();

        assertArrayEquals(new int[] {0, 0}, race.ranks());
        assertEquals("finished after 3 laps", race.ending());
    }

    @Test
    void aPodOnAllCheckpointsPassesEachOnceATurn() {
        PodRace race = Races.official(new double[][] {{0, 0}, {500, 0}});
        Races.put(race, 0, 0, 0, 0);
        race.play();

        assertEquals(2, race.pod(0).passed(), "two checkpoints that a pod at rest covers");
    }

    /**
     * Both are on their last checkpoint. One has the next one on its path too, behind the finish; one is nearer to it;
     * or they are mirrored about the line through both checkpoints, exactly as near.
     */
    @ParameterizedTest
    @CsvSource({"5000, 0, -590, 0, -300, 590, 5400, 3, 1", "9000, -599, 0, 0, 599, 0, 0, 2, 1",
        "9000, 0, -450, 0, 0, 450, 0, 2, 0"})
    void bothFinishInOneTurn(double next, double x, double y, double vx, double otherX, double otherY, double otherVx,
                             int otherPassed, int rank) {
        PodRace race = Races.duel(2, new double[][] {{0, 0}, {next, 0}});
        race.setPod(0, new PodState(x, y, vx, 0, 0, 0, true, 1));
        race.setPod(1, new PodState(otherX, otherY, otherVx, 0, 0, 0, true, 1));
        race.play();

        assertEquals("finished after 1 lap", race.ending());
        assertEquals(2, race.pod(0).passed());
        assertEquals(otherPassed, race.pod(1).passed());
        assertArrayEquals(new int[] {rank, 0}, race.ranks());
    }

    /** Pods far from each other and from all checkpoints. */
    private static PodRace apart(int players) {
        PodRace race = Races.duel(players, MAP);
        for (int pod = 0; pod < players; pod++) {
            Races.put(race, pod, 50_000, 5000 * pod, 0);
        }
        return race;
    }

    /** Shield up, then a fault: it weighs 10 in the turn of the fault and from then on. */
    @Test
    void aPodWithoutACommandKeepsItsMass() {
        PodRace race = apart(3);
        race.command(0, 0, 0, PodRace.SHIELD);
        race.play();
        assertEquals(10, race.bodies().mass[0]);
        race.eliminate(0, "fault");
        race.play();
        race.play();

        assertEquals(10, race.bodies().mass[0]);
        assertEquals(2, race.pod(0).shieldTimer());
        assertEquals(1, race.bodies().mass[1]);
    }

    /** Commands given before the fault take effect in its turn, and no later. */
    @Test
    void whatWasCommandedBeforeTheFaultTakesEffect() {
        PodRace race = apart(3);
        race.command(0, 60_000, 0, 100);
        race.eliminate(0, "fault");
        race.play();
        assertEquals(85, race.pod(0).vx());
        race.play();
        assertEquals(72, race.pod(0).vx());
    }

    @Test
    void finishingCountsMoreThanBeingTheLastOneIn() {
        PodRace race = Races.duel(3, MAP);
        Races.put(race, new double[][] {{90_000, 0, 1}, {50_000, 0, 1}, {50_000, 5000, 1}});
        race.eliminate(2, "fault");
        race.play();

        assertEquals("finished after 1 lap", race.ending());
        assertArrayEquals(new int[] {0, 1, 2}, race.ranks());
    }

    private static PodRace shortRace(int players) {
        return ((PodRaceType.PodRaceSetup) TestScenes.TYPES.open(TestScenes.text("duel")
            .replace("\"maximumTurns\": 200", "\"maximumTurns\": 2")
            .replace("\"players\": 2", "\"players\": " + players), "short")).create(MAP);
    }

    /** At the last turn more checkpoints win, with as many the nearer one, and as near is a draw. */
    @ParameterizedTest
    @CsvSource({"700, 0, 0, 10000, 0, 1, 1, 0", "701, 0, 0, -700, 0, 0, 1, 0", "0, 800, 0, -800, 0, 0, 0, 0"})
    void theLastTurnEndsAsTheyStand(double x, double y, int passed, double otherX, double otherY, int otherPassed,
                                    int rank, int otherRank) {
        PodRace race = shortRace(2);
        Races.put(race, new double[][] {{x, y, passed}, {otherX, otherY, otherPassed}});
        race.play();
        assertFalse(race.isOver());
        race.play();
        assertEquals("at most 2 turns are played", race.ending());
        assertArrayEquals(new int[] {rank, otherRank}, race.ranks());
        assertArrayEquals(new double[] {passed, otherPassed}, race.scores());
    }

    @Test
    void thePlayersBetterPodCounts() {
        PodRace race = ((PodRaceType.PodRaceSetup) TestScenes.changed("mad-pod-racing", "\"maximumTurns\": 500",
            "\"maximumTurns\": 1")).create(MAP);
        Races.put(race, new double[][] {{30_000, 0, 0}, {2000, 0, 0}, {3000, 3000, 0}, {3000, -3000, 0}});
        race.play();

        assertArrayEquals(new int[] {0, 1}, race.ranks());
    }

    @Test
    void fiveHundredTurnsAreTheOfficialLimit() {
        PodRace race = Races.official(MAP);
        for (int turn = 1; turn <= 500; turn++) {
            assertFalse(race.isOver(), "before turn " + turn);
            for (int pod = 0; pod < 4; pod += 2) {         // both pass one every turn, but never finish
                Races.put(race, pod, 100 * pod, 0, 0);
                Races.put(race, pod + 1, 50_000 + 5000 * pod, 0, 0);
            }
            race.play();
        }
        assertEquals("at most 500 turns are played", race.ending());
        assertEquals(500, race.turn());
    }

    @Test
    void tiesShareARank() {
        PodRace race = shortRace(5);
        Races.put(race, new double[][] {{2000, 0, 0}, {90_000, 2000, 1}, {90_000, -2000, 1}, {-2000, 0, 0},
            {5000, 0, 0}});
        race.play();
        assertArrayEquals(new int[] {2, 0, 0, 2, 4}, race.ranks(), "the standing is there at any time");
        race.play();

        assertArrayEquals(new int[] {2, 0, 0, 2, 4}, race.ranks());
        assertArrayEquals(new double[] {0, 1, 1, 0, 0}, race.scores());
    }

    @Test
    void allWhoAreOutShareTheLastRank() {
        PodRace race = apart(4);
        race.eliminate(2, "first");
        race.eliminate(2, "once more");
        race.play();
        race.eliminate(0, "second");
        race.eliminate(3, "too");
        race.play();

        assertEquals("first", race.eliminationReason(2));
        assertEquals("all others are out", race.ending());
        assertArrayEquals(new int[] {1, 0, 1, 1}, race.ranks());
    }

    /** Player 0 is out and player 1 breaks the rule in the same turn: both leave in it, nobody wins. */
    @Test
    void aFaultAndARuleInOneTurnAreADraw() {
        PodRace race = apart(2);
        Races.coast(race, 50);
        race.eliminate(0, "fault");
        race.play();

        assertEquals("all are out", race.ending());
        assertEquals("fault", race.eliminationReason(0));
        assertEquals("no checkpoint in 51 turns", race.eliminationReason(1));
        assertArrayEquals(new int[] {0, 0}, race.ranks());
    }

    @Test
    void thePodsOfAPlayerWhoIsOutCoastAndCanBeHit() {
        PodRace race = Races.duel(3, MAP);
        race.setPod(0, new PodState(50_000, 0, 100, 0, 1.5, 3, true, 0));
        Races.put(race, 1, 50_000, 9000, 0);
        Races.put(race, 2, 50_000, -9000, 0);
        race.eliminate(0, "fault");
        race.play();
        assertEquals(new PodState(50_100, 0, 85, 0, 1.5, 2, true, 0), race.pod(0));

        Races.put(race, 1, 51_000, 0, 0);
        Races.put(race, 2, 50_000, -9000, 0);
        race.setPod(0, new PodState(50_100, 0, 400, 0, 1.5, 0, true, 0));
        race.play();
        assertEquals(1, race.log().impacts());
        assertTrue(race.pod(1).vx() > 300, "pushed away: " + race.pod(1));
    }

    @Test
    void noTurnIsPlayedAfterTheEnd() {
        PodRace race = Races.official(MAP);
        Races.coast(race, 101);

        assertEquals("the game is over: all are out",
            assertThrows(IllegalStateException.class, race::play).getMessage());
        assertEquals(101, race.turn());
    }

    @Test
    void theHashCoversEveryPartOfTheState() {
        PodState base = new PodState(1, 2, 3, 4, 0.5, 1, true, 1);
        PodState[] others = {
            new PodState(9, 2, 3, 4, 0.5, 1, true, 1), new PodState(1, 9, 3, 4, 0.5, 1, true, 1),
            new PodState(1, 2, 9, 4, 0.5, 1, true, 1), new PodState(1, 2, 3, 9, 0.5, 1, true, 1),
            new PodState(1, 2, 3, 4, 0.25, 1, true, 1), new PodState(1, 2, 3, 4, Double.NaN, 1, true, 1),
            new PodState(1, 2, 3, 4, 0.5, 2, true, 1), new PodState(1, 2, 3, 4, 0.5, 1, false, 1),
            new PodState(1, 2, 3, 4, 0.5, 1, true, 2)};
        PodRace race = Races.official(MAP);
        race.setPod(3, base);
        long hash = race.hash();
        for (PodState other : others) {
            race.setPod(3, other);
            assertTrue(hash != race.hash(), other::toString);
        }
        race.setPod(3, base);
        assertEquals(hash, race.hash());
        race.eliminate(0, "out");
        assertTrue(hash != race.hash());
    }
}

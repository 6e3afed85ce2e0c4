package steward.minigame;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.game.TurnEvent;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.scene.json.SceneException;

/**
 * The rules of the pond, one touch at a time. Hunters have mass 10 and radius 15 sqrt(10) = 47.4, stand still unless
 * told, and the arena is 1,200 u wide around (1200, 1200).
 */
class PondTest {

    private final Pond pond = alone();
    private final Bodies bodies = pond.bodies();

    /** A pond with its three hunters alone, none of them within 300 u of the middle; nothing loses speed. */
    private static Pond alone() {
        return (Pond) MiniScenes.pond("\"drag\": 0.05", "\"drag\": 0", "\"restitution\": 0.9", "\"restitution\": 1",
            "\"bubbles\": 8, \"cells\": 6", "\"bubbles\": 0, \"cells\": 0", "\"fogs\": 3", "\"fogs\": 0").create(1);
    }

    /** Hunter 0 in the middle, flying right at 100 u per turn. */
    private void start() {
        bodies.setPosition(0, 1200, 1200);
        bodies.setVelocity(0, 100, 0);
    }

    @Test
    void aBubbleBurstsWithoutAnImpulse() {
        start();
        int id = bodies.id(pond.add(Pond.BUBBLE, 1290, 1200, 2));
        pond.play();
        assertEquals(-1, bodies.indexOf(id));
        assertEquals(0, pond.log().impacts());
        assertEquals(1300, bodies.x[0], 1e-9);
        assertEquals(100, bodies.vx[0]);
        TurnEvent event = pond.events().get(0);
        assertEquals(TurnEvent.Kind.DEATH, event.kind());
        assertEquals(id, event.body());
        assertEquals((90 - 15 * Math.sqrt(10) - 15 * Math.sqrt(2)) / 100, event.time(), 1e-12);
    }

    /** Mass 10 at 100 u per turn eats mass 5 at rest: mass 15, radius 15 sqrt(15), 100 * 10 / 15 u per turn. */
    @Test
    void aSmallCellIsEatenAndTheHunterGrows() {
        start();
        pond.add(Pond.CELL, 1290, 1200, 5);
        pond.play();
        assertEquals(3, bodies.size());
        assertEquals(15, bodies.mass[0]);
        assertEquals(1 / 15.0, bodies.inverseMass[0]);
        assertEquals(15 * Math.sqrt(15), bodies.radius[0]);
        assertEquals(1000 / 15.0, bodies.vx[0], 1e-12);
        assertArrayEquals(new double[] {15, 10, 10}, pond.scores());
        assertArrayEquals(new int[] {0, 1, 1}, pond.ranks(), "the others tie");
    }

    /** Mass 16 becomes two of mass 8 on either side; mass and momentum stay, the hunter flies on. */
    @Test
    void aCellSplitsInTwo() {
        start();
        int cell = pond.add(Pond.CELL, 1400, 1200, 16);
        bodies.setVelocity(cell, -3, 4);
        pond.play();
        assertEquals(5, bodies.size());
        assertEquals(8, bodies.mass[3]);
        assertEquals(8, bodies.mass[4]);
        assertEquals(-6, bodies.vx[3] + bodies.vx[4], 1e-12);
        assertEquals(8, bodies.vy[3] + bodies.vy[4], 1e-12);
        assertTrue((bodies.y[3] - 1200) * (bodies.y[4] - 1200) < 0);
        assertEquals(100, bodies.vx[0]);
        assertEquals(java.util.List.of(TurnEvent.Kind.DEATH, TurnEvent.Kind.BIRTH, TurnEvent.Kind.BIRTH),
            pond.events().stream().map(TurnEvent::kind).toList());
        assertEquals(4, pond.events().get(1).body(), "the first free id");
    }

    @Test
    void equalHuntersBounce() {
        start();
        bodies.setPosition(1, 1300, 1200);
        pond.play();
        assertEquals(1, pond.log().impacts());
        Impact impact = pond.log().impact(0);
        assertEquals(2 * 100 * 10 * 10 / 20.0, impact.impulse(), 1e-9, "2 u ma mb / (ma + mb)");
        assertEquals(0, bodies.vx[0], 1e-12);
    }

    @Test
    void aHeavierHunterEatsALighterOneWhosePlayerIsOut() {
        start();
        bodies.setPosition(1, 1300, 1200);
        bodies.setMass(1, 12.5);
        pond.play();
        assertFalse(pond.isIn(0));
        assertEquals("eaten by player 1", pond.eliminationReason(0));
        assertEquals(-1, bodies.indexOf(pond.hunterId(0)));
        assertEquals(22.5, bodies.mass[bodies.indexOf(pond.hunterId(1))]);
        assertArrayEquals(new int[] {2, 0, 1}, pond.ranks());
        assertFalse(pond.isOver());
    }

    /** Touched once, passed for three turns, and part of the state all the while. */
    @Test
    void fogIsPassedAndThePassageIsInTheHash() {
        start();
        pond.add(Pond.FOG, 1300, 1200, 30);
        int marks = 0;
        for (int turn = 0; turn < 4; turn++) {
            pond.play();
            marks += pond.events().size();
            assertEquals(turn < 2 ? 1 : 0, bodies.passing().size(), "turn " + turn);
        }
        assertEquals(1, marks);
        assertEquals(1600, bodies.x[0], 1e-9);
    }

    /** Two ponds that differ only in an ignored pair go on differently: one will ask, the other will not. */
    @Test
    void twoStatesThatDifferInAPassageAloneHaveDifferentHashes() {
        start();
        pond.add(Pond.FOG, 1300, 1200, 30);
        Pond other = alone();
        other.bodies().setPosition(0, 1200, 1200);
        other.add(Pond.FOG, 1300, 1800, 30);
        pond.play();
        other.play();
        for (int k = 0; k < bodies.size(); k++) {
            other.bodies().setPosition(k, bodies.x[k], bodies.y[k]);
            other.bodies().setVelocity(k, bodies.vx[k], bodies.vy[k]);
        }
        assertEquals(1, bodies.passing().size());
        assertEquals(0, other.bodies().passing().size());
        assertNotEquals(pond.hash(), other.hash());
        other.bodies().copyFrom(bodies);
        assertEquals(pond.hash(), other.hash());
    }

    /** At the rim a hunter grows inward. */
    @Test
    void whoGrowsAtTheWallStaysInside() {
        bodies.setPosition(0, 2400 - 48, 1200);
        bodies.setVelocity(0, 0, 50);
        pond.add(Pond.CELL, 2300, 1285, 7.9);
        for (int turn = 0; turn < 40; turn++) {
            pond.play();
            for (int k = 0; k < bodies.size(); k++) {
                assertTrue(pond.settings().arena().gap(bodies.x[k], bodies.y[k], bodies.radius[k]) > -1e-9,
                    "turn " + turn + " body " + k);
            }
            assertFalse(pond.log().limited(), "turn " + turn);
        }
        assertEquals(17.9, bodies.mass[0], 1e-12);
    }

    @Test
    void anEliminatedPlayerHasNoBody() {
        pond.eliminate(1, "no answer");
        pond.eliminate(1, "again");
        pond.play();
        assertEquals("no answer", pond.eliminationReason(1));
        assertEquals(-1, bodies.indexOf(pond.hunterId(1)));
        assertEquals(2, bodies.size());
        assertArrayEquals(new int[] {0, 2, 0}, pond.ranks());
        pond.eliminate(0, "a");
        pond.eliminate(2, "b");
        pond.play();
        assertArrayEquals(new int[] {0, 2, 0}, pond.ranks(), "out in one turn: a tie");
        assertEquals("no hunter is left", pond.ending());
    }

    @Test
    void aMisspeltFieldOfTheGamesOwnBlockIsLocated() {
        SceneException error = assertThrows(SceneException.class,
            () -> MiniScenes.pond("\"bubbles\"", "\"bubles\""));
        assertTrue(error.getMessage().startsWith("pond.json:11:") && error.getMessage().contains("pond.bubbles")
            && error.getMessage().contains("\"bubles\""), error.getMessage());
        SceneException wall = assertThrows(SceneException.class,
            () -> MiniScenes.pond("[ { \"type\": \"arena\", \"x\": 1200, \"y\": 1200, \"radius\": 1200, "
                + "\"restitution\": 0.9 } ]", "\"box\""));
        assertTrue(wall.getMessage().contains("no arena"), wall.getMessage());
    }
}

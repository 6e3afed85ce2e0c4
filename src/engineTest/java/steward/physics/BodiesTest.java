package steward.physics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.match.Refusal.refused;

import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;

/** Which bodies can be, what they are called, and what adding, removing and copying leaves as it was. */
class BodiesTest {

    private static final double NAN = Double.NaN;
    private static final double INFINITY = Double.POSITIVE_INFINITY;

    /** Ids 0, 2, 5: the body at index 1 is called 2, and the next will be 6. */
    private static Bodies three() {
        Bodies bodies = new Bodies(8);
        for (int k = 0; k < 6; k++) {
            bodies.add(10 * k, 0, 1, 1);
        }
        bodies.remove(4);
        bodies.remove(3);
        bodies.remove(1);
        return bodies;
    }

    @Test
    void aNewBodyIsRefusedByItsFutureIdAndTheValue() {
        Bodies bodies = three();
        refused("body 6: x NaN, expected a finite number", () -> bodies.add(NAN, 0, 1, 1));
        refused("body 6: y -Infinity, expected a finite number", () -> bodies.add(0, -INFINITY, 1, 1));
        refused("body 6: radius 0.0, expected finite and above 0", () -> bodies.add(0, 0, 0, 1));
        refused("body 6: radius -1.0, expected finite and above 0", () -> bodies.add(0, 0, -1, 1));
        refused("body 6: radius NaN, expected finite and above 0", () -> bodies.add(0, 0, NAN, 1));
        refused("body 6: radius Infinity, expected finite and above 0", () -> bodies.add(0, 0, INFINITY, 1));
        refused("body 6: mass 0.0, expected above 0 (or infinite)", () -> bodies.add(0, 0, 1, 0));
        refused("body 6: mass -2.0, expected above 0 (or infinite)", () -> bodies.add(0, 0, 1, -2));
        refused("body 6: mass NaN, expected above 0 (or infinite)", () -> bodies.add(0, 0, 1, NAN));
        assertEquals(3, bodies.size(), "a refused body is not there");
        assertEquals(6, bodies.nextId(), "and has used up no id");
    }

    @Test
    void aChangeIsRefusedByIdAndValueAndChangesNothing() {
        Bodies bodies = three();
        bodies.setVelocity(1, 3, 4);
        refused("body 2: x Infinity, expected a finite number", () -> bodies.setPosition(1, INFINITY, 0));
        refused("body 2: y NaN, expected a finite number", () -> bodies.setPosition(1, 0, NAN));
        refused("body 2: vx NaN, expected a finite number", () -> bodies.setVelocity(1, NAN, 0));
        refused("body 2: vy -Infinity, expected a finite number", () -> bodies.setVelocity(1, 0, -INFINITY));
        refused("body 2: radius -0.5, expected finite and above 0", () -> bodies.setRadius(1, -0.5));
        refused("body 2: mass 0.0, expected above 0 (or infinite)", () -> bodies.setMass(1, 0));
        refused("body 5: restitution 1.5, expected 0..1", () -> bodies.setRestitution(2, 1.5));
        refused("body 5: restitution -0.1, expected 0..1", () -> bodies.setRestitution(2, -0.1));
        refused("body 5: restitution NaN, expected 0..1", () -> bodies.setRestitution(2, NAN));
        refused("body 0: drag 2.0, expected 0..1", () -> bodies.setDrag(0, 2));
        refused("body 0: drag NaN, expected 0..1", () -> bodies.setDrag(0, NAN));
        refused("body 0: kind -1, expected at least 0", () -> bodies.setKind(0, -1));
        assertArrayEquals(new double[] {20, 0, 3, 4, 1, 1},
            new double[] {bodies.x[1], bodies.y[1], bodies.vx[1], bodies.vy[1], bodies.radius[1], bodies.mass[1]});
    }

    /** 1 / 4.9e-324 is infinite: such a body would get an infinite speed from any impulse. */
    @Test
    void aMassWithoutAFiniteInverseIsRefused() {
        Bodies bodies = three();
        refused("body 6: mass 4.9E-324, expected above 0 (or infinite)", () -> bodies.add(0, 0, 1, Double.MIN_VALUE));
        refused("body 0: mass 4.9E-324, expected above 0 (or infinite)", () -> bodies.setMass(0, Double.MIN_VALUE));
        bodies.setMass(0, Double.MIN_NORMAL);
        assertEquals(0x1p1022, bodies.inverseMass[0]);
    }

    @Test
    void theEdgesOfEachRangeAreAllowed() {
        Bodies bodies = new Bodies(1);
        bodies.add(-Double.MAX_VALUE, Double.MAX_VALUE, Double.MIN_VALUE, INFINITY);
        assertEquals(0, bodies.inverseMass[0]);
        bodies.setMass(0, Double.MAX_VALUE);
        assertTrue(bodies.inverseMass[0] > 0, "the heaviest finite mass can still be moved");
        bodies.setMass(0, 4);
        assertEquals(0.25, bodies.inverseMass[0]);
        bodies.setRestitution(0, 0);
        bodies.setRestitution(0, 1);
        bodies.setDrag(0, 1);
        bodies.setDrag(0, 0);
    }

    @Test
    void capacityIsFixed() {
        refused("capacity 0, expected at least 1", () -> new Bodies(0));
        Bodies bodies = new Bodies(2);
        double[] xs = bodies.x;
        bodies.add(0, 0, 1, 1);
        bodies.add(1, 0, 1, 1);
        assertEquals("capacity of 2 bodies is used up",
            assertThrows(IllegalStateException.class, () -> bodies.add(2, 0, 1, 1)).getMessage());
        bodies.remove(0);
        assertEquals(1, bodies.add(2, 0, 1, 1), "room again, at the end");
        assertEquals(2, bodies.id(1), "with an id of its own");
        assertEquals(2, bodies.capacity());
        assertTrue(xs == bodies.x, "the arrays never move");
    }

    @Test
    void aNewBodyInAReusedPlaceHasNothingOfTheOldOne() {
        Bodies bodies = new Bodies(1);
        bodies.add(1, 2, 3, 4);
        bodies.setVelocity(0, 5, 6);
        bodies.setRestitution(0, 0.5);
        bodies.setDrag(0, 0.25);
        bodies.setKind(0, 3);
        bodies.remove(0);
        bodies.add(7, 8, 9, 10);
        assertArrayEquals(new double[] {7, 8, 0, 0, 9, 10, 0.1, 1, 0},
            new double[] {bodies.x[0], bodies.y[0], bodies.vx[0], bodies.vy[0], bodies.radius[0], bodies.mass[0],
                bodies.inverseMass[0], bodies.restitution[0], bodies.drag[0]});
        assertEquals(0, bodies.kind[0]);
    }

    @Test
    void removalOutsideIsRefused() {
        Bodies bodies = three();
        for (int body : new int[] {-1, 3, 7}) {
            assertEquals("body " + body + " of 3",
                assertThrows(IndexOutOfBoundsException.class, () -> bodies.remove(body)).getMessage());
        }
    }

    /** A body's numbers all say its id, so that a mix-up of places shows. */
    @Test
    void idsAreStableUnderAddingAndRemoving() {
        for (long seed = 1; seed <= 50; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = new Bodies(12);
            for (int step = 0; step < 300; step++) {
                if (bodies.size() < 12 && random.nextInt(2) == 0) {
                    int id = bodies.nextId();
                    int body = bodies.add(id, -id, 1 + id, 2 + id);
                    bodies.setVelocity(body, 3 + id, 4 + id);
                    bodies.setRestitution(body, 1.0 / (1 + id));
                    bodies.setDrag(body, 1.0 / (2 + id));
                    bodies.setKind(body, id);
                } else if (bodies.size() > 0) {
                    int gone = random.nextInt(bodies.size());
                    int id = bodies.id(gone);
                    bodies.remove(gone);
                    assertEquals(-1, bodies.indexOf(id), "seed " + seed);
                }
                checkEachSaysItsId(bodies, "seed " + seed + ", step " + step);
            }
            assertEquals(-1, bodies.indexOf(bodies.nextId()), "seed " + seed);
            assertEquals(-1, bodies.indexOf(-1), "seed " + seed);
        }
    }

    private static void checkEachSaysItsId(Bodies bodies, String when) {
        for (int k = 0; k < bodies.size(); k++) {
            int id = bodies.id(k);
            assertEquals(k, bodies.indexOf(id), when);
            assertTrue(k == 0 || bodies.id(k - 1) < id, when + ": ids ascend");
            assertEquals(id, bodies.kind[k], when);
            assertArrayEquals(
                new double[] {id, -id, 3 + id, 4 + id, 1 + id, 2 + id, 1.0 / (2 + id), 1.0 / (1 + id), 1.0 / (2 + id)},
                new double[] {bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k], bodies.radius[k], bodies.mass[k],
                    bodies.inverseMass[k], bodies.restitution[k], bodies.drag[k]}, when);
        }
    }

    @Test
    void aCopyIsExactAndIndependent() {
        Bodies bodies = three();
        bodies.setVelocity(1, 3, 4);
        bodies.passing().add(5, 0);
        bodies.passing().add(2, ~7);
        Bodies copy = new Bodies(8);
        for (int k = 0; k < 8; k++) {
            copy.add(99, 99, 9, 9);
        }
        for (int k = 0; k < 20; k++) {
            copy.passing().add(k, k + 1);
        }
        copy.copyFrom(bodies);
        assertEquals(3, copy.size());
        assertEquals(6, copy.nextId());
        assertArrayEquals(new int[] {0, 2, 5}, new int[] {copy.id(0), copy.id(1), copy.id(2)});
        assertArrayEquals(new double[] {20, 3, 4}, new double[] {copy.x[1], copy.vx[1], copy.vy[1]});
        assertEquals(2, copy.passing().size());
        assertTrue(copy.passing().contains(0, 5) && copy.passing().contains(2, ~7));
        copy.remove(0);
        copy.passing().remove(0);
        assertEquals(3, bodies.size());
        assertTrue(bodies.passing().contains(0, 5));
        refused("capacity 8, expected 9", () -> new Bodies(9).copyFrom(bodies));
    }

    /** Things that are no bodies are counted with them. */
    @Test
    void anIdCanBeTakenWithoutABody() {
        Bodies bodies = three();
        assertEquals(6, bodies.takeId());
        assertEquals(7, bodies.id(bodies.add(0, 0, 1, 1)));
        assertEquals(-1, bodies.indexOf(6));
    }

    @Test
    void columnsMoveDieAndAreCopiedWithTheirBodies() {
        Bodies bodies = new Bodies(4, 2);
        for (int k = 0; k < 4; k++) {
            bodies.add(k, 0, 1, 1);
            bodies.columns[1][k] = 10 * k;
        }
        bodies.remove(1);
        Bodies copy = new Bodies(4, 2);
        copy.copyFrom(bodies);
        assertEquals(3, copy.size());
        assertArrayEquals(new double[] {0, 20, 30},
            new double[] {copy.columns[1][0], copy.columns[1][1], copy.columns[1][2]});
        copy.add(0, 0, 1, 1);
        assertEquals(0, copy.columns[1][3], "not what was there before");
        assertEquals(30, bodies.columns[1][2]);
        refused("2 columns, expected 0", () -> new Bodies(4).copyFrom(bodies));
        refused("-1 columns, expected at least 0", () -> new Bodies(4, -1));
    }

    @Test
    void aPointHasNoRadius() {
        Bodies bodies = new Bodies(1);
        bodies.addPoint(3, 4, 1);
        assertEquals(0, bodies.radius[0]);
        refused("body 0: radius 0.0, expected finite and above 0", () -> bodies.setRadius(0, 0));
    }

    @Test
    void passingPairsKnowNoOrderAndTellWallsFromBodies() {
        PassingPairs pairs = new PassingPairs();
        assertTrue(pairs.isEmpty());
        for (int k = 0; k < 40; k++) {
            pairs.add(k + 1, k);
            pairs.add(k, ~k);
        }
        assertEquals(80, pairs.size());
        for (int k = 0; k < 40; k++) {
            assertTrue(pairs.contains(k, k + 1) && pairs.contains(k + 1, k) && pairs.contains(k, ~k), "pair " + k);
            assertFalse(pairs.contains(k, k + 2) || pairs.contains(k, ~(k + 1)), "pair " + k);
            assertEquals(k, pairs.first(2 * k));
            assertEquals(k + 1, pairs.second(2 * k));
            assertEquals(~k, pairs.second(2 * k + 1));
        }
        for (int k = pairs.size() - 1; k >= 0; k--) {
            pairs.remove(k);
        }
        assertTrue(pairs.isEmpty() && !pairs.contains(0, 1));
    }

    /** PassingPairs of a copy with more pairs than its own list has room for. */
    @Test
    void aCopyTakesManyPassingPairs() {
        Bodies bodies = new Bodies(2);
        for (int k = 0; k < 100; k++) {
            bodies.passing().add(k, k + 1);
        }
        Bodies copy = new Bodies(2);
        copy.copyFrom(bodies);
        assertEquals(100, copy.passing().size());
        copy.passing().add(500, 501);
        assertTrue(copy.passing().contains(99, 100) && copy.passing().contains(500, 501));
    }
}

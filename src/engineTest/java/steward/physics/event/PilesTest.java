package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * Random piles without restitution that are pressed together anew each turn, on every event rung, by all pairs and as a
 * crowd: they come to rest within 500 impacts a turn without a bound, and never gain energy. Piles with restitution
 * that forces press, which have no more impacts once they lie still.
 */
@Execution(ExecutionMode.CONCURRENT)
class PilesTest {

    private static final int MOST_IMPACTS = 500;
    private static final double ROOM = 400;

    /** Where a pile is pressed. */
    enum Place {
        CORNER, WEDGE, NARROW_WEDGE, ARENA, FREE_SPACE;

        Wall[] walls(double restitution) {
            return switch (this) {
                case CORNER -> wedge(90, restitution);
                case WEDGE -> wedge(45, restitution);
                case NARROW_WEDGE -> wedge(8, restitution);
                case ARENA -> new Wall[] {new Arena(0, ROOM, ROOM, restitution)};
                case FREE_SPACE -> new Wall[0];
            };
        }

        /** Two walls that meet in the origin, open upwards. */
        private static Wall[] wedge(double degrees, double restitution) {
            double half = StrictMath.toRadians(degrees / 2);
            double cos = StrictMath.cos(half);
            double sin = StrictMath.sin(half);
            return new Wall[] {new HalfPlane(0, 0, cos, sin, restitution), new HalfPlane(0, 0, -cos, sin, restitution)};
        }
    }

    /** Equal bodies that are pressed evenly. */
    @ParameterizedTest
    @EnumSource
    void evenPilesRest(Place place) {
        pile(place, 1, 0);
    }

    /** Masses from 1 to 1,000, radii from 1 to 8. */
    @ParameterizedTest
    @EnumSource
    void lopsidedPilesRest(Place place) {
        pile(place, 8, 0);
    }

    /** Each body is also thrown about at random, as fast as the pile is pressed. */
    @ParameterizedTest
    @EnumSource
    void busyPilesRest(Place place) {
        pile(place, 2, 1);
    }

    @ParameterizedTest
    @EnumSource
    @Tag("campaign")
    void allRestByEveryArithmetic(Place place) {
        for (Arithmetic arithmetic : Arithmetic.values()) {
            pile(arithmetic, place, 1, 0);
            pile(arithmetic, place, 8, 0);
            pile(arithmetic, place, 2, 1);
        }
    }

    /**
     * Piles with restitution fall into a place by their weight: at rest they have few impacts, on all rungs. Masses are
     * 1 to 1,000; in the narrow wedge they are equal, since others collapse there in more impacts than a turn may have.
     * Campaigns drop larger piles at each restitution ({@code FallenPilesCase}).
     */
    @ParameterizedTest
    @EnumSource(names = {"CORNER", "WEDGE", "NARROW_WEDGE"})
    @Tag("slow")
    void fallenPilesRest(Place place) {
        for (double restitution : new double[] {0, 0.3, 0.6, 0.9}) {
            for (int count : restitution == 0.6 ? new int[] {3, 12, 40} : new int[] {3, 12}) {
                fall(Arithmetic.values()[count % 4], count, place == Place.NARROW_WEDGE ? 1 : 2, restitution, 1200,
                    place.walls(1));
            }
        }
    }

    /**
     * In an arena of the room R, where all that a wall exerts goes through the centre, a pile swings: 4R/a turns take a
     * part e of it. So from at most 3 u a turn it lies still to 1e-6 after 4R/a ln(3e6).
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.6, 0.9})
    @Tag("slow")
    void fifteenInAnArenaComeToRest(double restitution) {
        double radius = 80;
        int turns = (int) (200 + 4 * radius / 2 * StrictMath.log(3e6));
        fall(Arithmetic.DOUBLE, 15, 2, restitution, turns, new Arena(0, radius, radius, 1));
    }

    /** Three hundred in rows, whose radii differ by 4%: at rest hardly a turn closes a gap that rounding has opened. */
    @Test
    @Tag("campaign")
    void aHeapAtRestLosesNoContactByRounding() {
        Forces gravity = new Forces(0, 0, 0, -2);
        PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION, Arithmetic.DOUBLE, new HalfPlane(0, 0, 0, 1, 0.5),
            new HalfPlane(0, 0, 1, 0, 0.5), new HalfPlane(497, 0, -1, 0, 0.5)).withForces(gravity);
        SplitMix64 random = new SplitMix64(3);
        Bodies bodies = new Bodies(300);
        for (int row = 0; bodies.size() < 300; row++) {
            for (int column = 0; column < 16 - row % 2 && bodies.size() < 300; column++) {
                int k = bodies.add((column + 0.5 + 0.5 * (row % 2)) * 31 + 0.5, 15.5 + 27 * row,
                    15.4 - 0.6 * random.nextDouble(), 1);
                bodies.setRestitution(k, 0.5);
            }
        }
        Advance advance = new QueueAdvance(parts);
        int moving = 0;
        for (int turn = 1; turn <= 1500; turn++) {
            Scenes.accelerate(gravity, bodies);
            advance.turn(bodies, TurnSink.NONE);
            double fastest = 0;
            for (int k = 0; k < bodies.size(); k++) {
                fastest = Math.max(fastest, Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
                bodies.setVelocity(k, turn < 200 ? 0 : bodies.vx[k], turn < 200 ? 0 : bodies.vy[k]);
            }
            moving += turn > 500 && fastest > 1e-9 ? 1 : 0;
        }
        assertTrue(moving <= 100, moving + " of 1000 turns");
    }

    private static void fall(Arithmetic arithmetic, int count, double ratio, double restitution, int turns,
                             Wall... walls) {
        Forces gravity = new Forces(0, 0, 0, -2);
        PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION, arithmetic, walls).withForces(gravity);
        Bodies bodies = bodies(new SplitMix64(count), count, ratio, restitution, walls);
        Advance advance = new EventAdvance(parts);
        int still = 0;
        for (int turn = 1; turn <= turns && still < 20; turn++) {
            Scenes.accelerate(gravity, bodies);
            TurnLog log = Scenes.turn(advance, bodies);
            String where = arithmetic + ", " + count + " bodies, e " + restitution + ", turn " + turn + ": ";
            assertTrue(!log.limited() && (still == 0 || log.impacts() <= MOST_IMPACTS), where + log.impacts());
            assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-11, where + "overlap");
            double fastest = 0;
            for (int k = 0; k < count; k++) {
                fastest = Math.max(fastest, Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
            }
            still = fastest < 1e-6 ? still + 1 : 0;
        }
        assertEquals(20, still, arithmetic + ", " + count + " bodies, e " + restitution + ": they still move");
    }

    private static void pile(Place place, double ratio, double busy) {
        pile(Arithmetic.DOUBLE, place, ratio, busy);
    }

    private static void pile(Arithmetic arithmetic, Place place, double ratio, double busy) {
        SplitMix64 random = new SplitMix64(place.ordinal());
        for (int count : new int[] {3, 9, 24}) {
            Wall[] walls = place.walls(0);
            PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION, arithmetic, walls);
            Bodies bodies = bodies(random, count, ratio, 0, walls);
            String what = arithmetic + ", " + count + " bodies";
            press(bodies, random, place, busy, walls, new EventAdvance(parts), new QueueAdvance(parts), what);
        }
    }

    private static void press(Bodies bodies, SplitMix64 random, Place place, double busy, Wall[] walls, Advance alone,
                              Advance crowd, String what) {
        double speed = 1 + 30 * random.nextDouble();
        Bodies copy = new Bodies(bodies.capacity());
        for (int turn = 1; turn <= 4; turn++) {
            for (int k = 0; k < bodies.size(); k++) {
                double far = Math.sqrt(bodies.x[k] * bodies.x[k] + bodies.y[k] * bodies.y[k]) + 1e-9;
                boolean free = place == Place.FREE_SPACE;
                bodies.vx[k] += speed * ((free ? -bodies.x[k] / far : 0) + busy * (2 * random.nextDouble() - 1));
                bodies.vy[k] += speed * ((free ? -bodies.y[k] / far : -1) + busy * (2 * random.nextDouble() - 1));
            }
            double energy = Scenes.energy(bodies);
            copy.copyFrom(bodies);
            TurnLog one = Scenes.turn(alone, bodies);
            TurnLog other = Scenes.turn(crowd, copy);
            String where = what + ", turn " + turn + ": ";
            assertFalse(one.limited(), where + "limited");
            assertTrue(one.impacts() <= MOST_IMPACTS, where + one.impacts() + " impacts");
            assertTrue(Scenes.energy(bodies) <= energy * (1 + 1e-15), where + "energy grew");
            assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-11, where + "overlap");
            assertEquals(one.impacts(), other.impacts(), where + "as a crowd");
            for (int k = 0; k < bodies.size(); k++) {
                assertEquals(bodies.x[k], copy.x[k], where + "as a crowd, body " + k);
                assertEquals(bodies.vy[k], copy.vy[k], where + "as a crowd, body " + k);
            }
        }
    }

    /** @param ratio of the largest radius and the smallest; its third power, and more, is that of the masses */
    private static Bodies bodies(SplitMix64 random, int count, double ratio, double restitution, Wall... walls) {
        Bodies bodies = new Bodies(count);
        double reach = 40;
        while (bodies.size() < count) {
            reach += 0.1;
            double radius = 4 * (1 + (ratio - 1) * random.nextDouble());
            double x = reach * (2 * random.nextDouble() - 1);
            double y = reach * (2 * random.nextDouble() - 1);
            int k = bodies.add(x, y, 1.01 * radius, ratio == 1 ? 1 : StrictMath.pow(1000, random.nextDouble()));
            if (Scenes.deepestOverlap(bodies, walls) > 0) {
                bodies.remove(k);
                continue;
            }
            bodies.setRadius(k, radius);
            bodies.setRestitution(k, restitution);
        }
        return bodies;
    }
}

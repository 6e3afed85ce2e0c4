package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.physics.queue.QueueAdvance;

/**
 * Random piles without restitution that are pressed together anew each turn, on every event rung, by all pairs and as a
 * crowd. That they come to rest within 500 impacts a turn without a bound, and never gain energy, is what {@code Rest}
 * promises.
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

    private static void pile(Place place, double ratio, double busy) {
        pile(Arithmetic.DOUBLE, place, ratio, busy);
    }

    private static void pile(Arithmetic arithmetic, Place place, double ratio, double busy) {
        SplitMix64 random = new SplitMix64(place.ordinal());
        for (int count : new int[] {3, 9, 24}) {
            Wall[] walls = place.walls(0);
            PhysicsParts parts = new PhysicsParts(Scenes.WITH_RESTITUTION, arithmetic, new Contacts(1),
                List.of(walls), null, true);
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
            TurnLog one = new TurnLog();
            alone.turn(bodies, one);
            TurnLog other = new TurnLog();
            crowd.turn(copy, other);
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

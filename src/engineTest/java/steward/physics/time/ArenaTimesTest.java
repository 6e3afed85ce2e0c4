package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Arena;

/**
 * Circle inside a circular arena, against 60 digits. The touch is the second crossing of the line of flight with the
 * circle of radius "room" (arena less body) for the centre; with cos of the angle between flight and normal there,
 * known to 32 u room / (|v| cos), u = 2^-53, by the same derivation as for two circles.
 */
@Execution(ExecutionMode.CONCURRENT)
class ArenaTimesTest {

    private static final double NEVER = Double.POSITIVE_INFINITY;

    @Test
    @Tag("sized")
    void timesAreExactToTheBound() {
        for (long seed = 1; seed <= TestSize.of(1000, 4000); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double room = Math.pow(10, 24 * random.nextDouble() - 12);
            double speed = Math.pow(10, 24 * random.nextDouble() - 12);
            double depth = random.nextInt(3) == 0 ? 1 - Math.pow(10, -14 * random.nextDouble()) : random.nextDouble();
            double place = 2 * Math.PI * random.nextDouble();
            double heading = 2 * Math.PI * random.nextDouble();
            double dx = room * depth * Math.cos(place);
            double dy = room * depth * Math.sin(place);
            double vx = speed * Math.cos(heading);
            double vy = speed * Math.sin(heading);
            if (Exact.dot(dx, dy, dx, dy).compareTo(Exact.square(Exact.of(room))) >= 0) {
                continue;
            }
            double found = TimeOfImpact.arena(dx, dy, vx, vy, room);
            BigDecimal exact = Exact.crossings(dx, dy, vx, vy, Exact.of(room))[1];
            double miss = Exact.root(Exact.nearestSquared(dx, dy, vx, vy).max(BigDecimal.ZERO)).doubleValue() / room;
            double cosSquared = (1 - miss) * (1 + miss);
            String number = "seed " + seed;
            Supplier<String> what = () -> number + " found " + found + " exact " + exact.doubleValue();
            assertTrue(found >= 0 && found < NEVER, what);
            if (cosSquared > 256 * Exact.ULP) {
                double bound = 32 * Exact.ULP * room / Math.sqrt(cosSquared) / speed;
                assertTrue(Exact.error(found, exact) <= bound, () -> what.get() + " bound " + bound);
            }
        }
    }

    /** Along the rim the discriminant is all rounding; time must not run backwards all the same. */
    @Test
    @Tag("sized")
    void alongTheRimTimeNeverRunsBackwards() {
        for (long seed = 1; seed <= TestSize.of(25_000, 100_000); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double place = 2 * Math.PI * random.nextDouble();
            double depth = 1 - 4e-16 * random.nextDouble();
            double lean = 1e-15 * (2 * random.nextDouble() - 1);
            double found = TimeOfImpact.arena(1000 * depth * Math.cos(place), 1000 * depth * Math.sin(place),
                -77 * Math.sin(place + lean), 77 * Math.cos(place + lean), 1000);
            String number = "seed " + seed;
            assertTrue(found >= 0, () -> number + " found " + found);
            assertTrue(found <= 1e-3, () -> number + ": the rim is at most sqrt(4e-16) * 1000 / 77 turns away");
        }
    }

    /** Arena of radius 10 around (100, 50), body of radius 2: room 8. */
    @Test
    void arenasByHand() {
        Arena arena = new Arena(100, 50, 10, 1);
        assertEquals(4, TimeOfImpact.wall(arena, 100, 50, 2, 0, 2), "from the centre");
        assertEquals(1, TimeOfImpact.wall(arena, 94, 50, 14, 0, 2), "all across");
        assertEquals(2, TimeOfImpact.wall(arena, 94, 50, -1, 0, 2), "straight out");
        assertEquals(0, TimeOfImpact.wall(arena, 108, 50, 1, 0, 2), "touching, outward");
        assertEquals(0, TimeOfImpact.wall(arena, 109, 50, 1, 5, 2), "overlapping, outward");
        assertEquals(16, TimeOfImpact.wall(arena, 108, 50, -1, 0, 2), "touching, inward: only the other side counts");
        assertEquals(17, TimeOfImpact.wall(arena, 109, 50, -1, 0, 2), "overlapping, inward: the same");
        assertEquals(NEVER, TimeOfImpact.wall(arena, 100, 50, 0, 0, 2), "stands still");
        assertEquals(NEVER, TimeOfImpact.wall(arena, 109, 50, 0, 0, 2), "stands still outside");
    }

    /** From (9, 0) outside room 8 upward: the line x = 9 never comes inside, so it only ever flies outward. */
    @Test
    void outsideAllAlongItReactsWhenItBeginsToFlyOutward() {
        assertEquals(0, TimeOfImpact.arena(9, 1, 0, 1, 8), "flies outward already");
        assertEquals(3, TimeOfImpact.arena(9, -3, 0, 1, 8), "nearest after 3 turns");
    }
}

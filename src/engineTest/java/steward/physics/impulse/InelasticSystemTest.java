package steward.physics.impulse;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * The least impulses of heaps by the sparse way: the conditions of Karush, Kuhn and Tucker hold, which only the minimum
 * fulfils. Its velocities are those of the dense way, and depend neither on the order of the contacts nor on systems
 * before.
 */
class InelasticSystemTest {

    /** Share of the speeds up to which conditions hold; contacts part at more than that, 2^-42. */
    private static final double EXACT = 1e-12;

    /** Kinds of heaps, by their difficulty. */
    enum Heap {
        /** Discs at random places with random velocities. */
        LOOSE,
        /** A hexagonal lattice: each inner disc touches six others, contacts depend on each other. */
        LATTICE,
        /** The lattice, pressed into a corner; each disc at a wall has two contacts with it. */
        CORNER,
        /** Masses from 1 to 1,000,000. */
        MASSES,
        /** Each third contact may not open. */
        HELD;

        boolean isLattice() {
            return this != LOOSE;
        }
    }

    /** Seeds of heaps, of one kind or another, that earlier ways did not end with. */
    private static final long[] LONG = {132, 195, 198, 740, 765};
    private static final int SIDE = 8;
    private static final int COUNT = SIDE * SIDE;

    @ParameterizedTest
    @EnumSource
    @Tag("sized")
    void theConditionsOfTheMinimumHold(Heap heap) {
        LongStream few = LongStream.rangeClosed(1, TestSize.of(40, 1400));
        for (long seed : LongStream.concat(few, LongStream.of(LONG)).toArray()) {
            Bodies bodies = bodies(heap, seed);
            InelasticSystem system = solved(heap, bodies, seed);
            check(heap + ", seed " + seed, bodies, system);
        }
    }

    /** The contacts in the opposite order: other sets on the way, the same velocities. */
    @ParameterizedTest
    @EnumSource
    void theOrderOfTheContactsDoesNotMatter(Heap heap) {
        for (long seed = 1; seed <= 20; seed++) {
            Bodies bodies = bodies(heap, seed);
            InelasticSystem system = solved(heap, bodies, seed);
            InelasticSystem other = empty(bodies);
            for (int k = system.size - 1; k >= 0; k--) {
                other.add(system.a[k], system.b[k], system.normalX[k], system.normalY[k], system.allowed[k]);
                other.held[system.size - 1 - k] = system.held[k];
            }
            other.solve(bodies, EXACT);
            double bound = 1e3 * EXACT * largestChange(bodies, system);
            for (int i = 0; i < COUNT; i++) {
                assertEquals(system.vx[i], other.vx[i], bound, heap + ", seed " + seed + ", body " + i);
                assertEquals(system.vy[i], other.vy[i], bound, heap + ", seed " + seed + ", body " + i);
            }
        }
    }

    /** A few contacts by the dense way, and together with others that share no body with them by the sparse one. */
    @ParameterizedTest
    @EnumSource
    void theDenseWayHasTheSameVelocities(Heap heap) {
        for (long seed = 1; seed <= 200; seed++) {
            Bodies bodies = bodies(heap, seed);
            InelasticSystem dense = empty(bodies);
            InelasticSystem sparse = empty(bodies);
            InelasticSystem all = system(heap, bodies, seed);
            for (int k = 0; k < all.size; k++) {
                boolean few = all.a[k] < 12 && all.b[k] < 12 && dense.size < InelasticSystem.MOST_DENSE;
                if (few) {
                    dense.add(all.a[k], all.b[k], all.normalX[k], all.normalY[k], all.allowed[k]);
                    dense.held[dense.size - 1] = all.held[k];
                }
                if (few || all.a[k] > 20 && (all.b[k] < 0 || all.b[k] > 20)) {
                    sparse.add(all.a[k], all.b[k], all.normalX[k], all.normalY[k], all.allowed[k]);
                    sparse.held[sparse.size - 1] = all.held[k];
                }
            }
            assertTrue(dense.size > 3 && sparse.size > InelasticSystem.MOST_DENSE, dense.size + " " + sparse.size);
            dense.solve(bodies, EXACT);
            sparse.solve(bodies, EXACT);
            double bound = 1e3 * EXACT * Math.max(largestChange(bodies, dense), largestChange(bodies, sparse));
            for (int i = 0; i < 12; i++) {
                String where = heap + ", seed " + seed + ", body " + i;
                assertEquals(dense.vx[i], sparse.vx[i], bound, where);
                assertEquals(dense.vy[i], sparse.vy[i], bound, where);
            }
        }
    }

    /**
     * Couplings that systems of one heap share: one of some contacts, which expects all, then one of all with normals
     * that are turned, with another speed of parting, one of fewer, and all in another order after the bodies moved.
     */
    @ParameterizedTest
    @EnumSource
    void contactsThatSystemsBeforeHadDoNotMatter(Heap heap) {
        for (long seed = 1; seed <= 100; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = bodies(heap, seed);
            InelasticSystem all = system(heap, bodies, seed);
            InelasticSystem shared = new InelasticSystem();
            shared.forget(bodies);
            for (int k = 0; k < all.size; k++) {
                shared.expect(all.a[k], all.b[k]);
            }
            solveSome(all, bodies, 3, seed, shared);
            for (int k = 0; k < all.size; k++) {
                double angle = all.b[k] < 0 ? 0 : random.nextDouble() - 0.5;
                double cos = StrictMath.cos(angle);
                double sin = StrictMath.sin(angle);
                all.turn(k, all.normalX[k] * cos - all.normalY[k] * sin, all.normalX[k] * sin + all.normalY[k] * cos,
                    all.allowed[k]);
            }
            shared.begin(bodies, bodies.vx, bodies.vy, 0);
            solveAll(all, bodies, shared);
            assertSame(heap + ", seed " + seed, all, bodies, 0, shared);
            double parting = heap == Heap.HELD ? 0 : 1e-3;
            shared.restart(parting);
            shared.solve(bodies, EXACT);
            assertSame(heap + ", parting, seed " + seed, all, bodies, parting, shared);
            solveSome(all, bodies, 4, seed + 1, shared);
            InelasticSystem alone = new InelasticSystem();
            alone.forget(bodies);
            solveSome(all, bodies, 4, seed + 1, alone);
            assertSame(heap + ", fewer, seed " + seed, bodies, alone, shared);
            for (int k = all.size - 1; k > 0; k--) {
                all.swap(k, random.nextInt(k + 1));
            }
            shared.forget(bodies);
            shared.begin(bodies, bodies.vx, bodies.vy, 0);
            solveAll(all, bodies, shared);
            assertSame(heap + ", moved, seed " + seed, all, bodies, 0, shared);
        }
    }

    /** A heap of few bodies first, whose arrays then grow; heaps that fall as one, so that sets are found at once. */
    @ParameterizedTest
    @EnumSource
    void aSystemThatHasSolvedOtherHeapsComputesTheSameBits(Heap heap) {
        for (long seed = 1; seed <= 100; seed++) {
            Bodies bodies = bodies(heap, seed);
            for (int k = 0; k < COUNT; k++) {
                bodies.setVelocity(k, 1e-3 * bodies.vx[k], -1 + 1e-3 * bodies.vy[k]);
            }
            InelasticSystem all = system(heap, bodies, seed);
            Bodies few = new Bodies(2 * SIDE);
            for (int k = 0; k < 2 * SIDE; k++) {
                few.add(bodies.x[k], bodies.y[k], 1, bodies.mass[k]);
                few.setVelocity(k, bodies.vx[k], bodies.vy[k]);
            }
            InelasticSystem used = new InelasticSystem();
            used.forget(few);
            used.begin(few, few.vx, few.vy, 0);
            for (int k = 0; k < all.size; k++) {
                if (all.a[k] < few.size() && all.b[k] < few.size()) {
                    add(all, k, used);
                }
            }
            assertTrue(heap == Heap.LOOSE || used.size > InelasticSystem.MOST_DENSE, "not the sparse way");
            used.solve(few, EXACT);
            InelasticSystem unused = new InelasticSystem();
            for (InelasticSystem system : List.of(used, unused)) {
                system.forget(bodies);
                solveSome(all, bodies, 3, seed, system);
                solveSome(all, bodies, 5, seed + 1, system);
            }
            assertArrayEquals(Arrays.copyOf(unused.impulse, unused.size), Arrays.copyOf(used.impulse, used.size),
                heap + ", seed " + seed);
        }
    }

    /** Solves a system of some tenths of the contacts, which expects others, with velocities of its own. */
    private static void solveSome(InelasticSystem all, Bodies bodies, int tenths, long seed, InelasticSystem system) {
        SplitMix64 random = new SplitMix64(seed);
        double[] x = Arrays.stream(bodies.vx).map(vx -> vx + 1e-3 * random.nextDouble()).toArray();
        system.begin(bodies, x, bodies.vy, 0);
        for (int k = 0; k < all.size; k++) {
            if (random.nextInt(10) < tenths) {
                add(all, k, system);
            } else if (random.nextInt(10) == 0) {
                system.expect(all.a[k], all.b[k]);
            }
        }
        system.solve(bodies, EXACT);
    }

    private static void solveAll(InelasticSystem all, Bodies bodies, InelasticSystem system) {
        for (int k = 0; k < all.size; k++) {
            add(all, k, system);
        }
        assertTrue(system.solve(bodies, EXACT), "not solved");
    }

    private static void add(InelasticSystem from, int k, InelasticSystem to) {
        to.add(from.a[k], from.b[k], from.normalX[k], from.normalY[k], from.allowed[k]);
        to.held[to.size - 1] = from.held[k];
    }

    private static void assertSame(String where, InelasticSystem all, Bodies bodies, double parting,
                                   InelasticSystem found) {
        InelasticSystem alone = empty(bodies);
        alone.restart(parting);
        solveAll(all, bodies, alone);
        assertSame(where, bodies, alone, found);
    }

    private static void assertSame(String where, Bodies bodies, InelasticSystem expected, InelasticSystem found) {
        double bound = 1e3 * EXACT * Math.max(largestChange(bodies, expected), largestChange(bodies, found));
        for (int i = 0; i < COUNT; i++) {
            assertEquals(expected.vx[i], found.vx[i], bound, where + ", body " + i);
            assertEquals(expected.vy[i], found.vy[i], bound, where + ", body " + i);
        }
    }

    private static InelasticSystem empty(Bodies bodies) {
        InelasticSystem system = new InelasticSystem();
        system.forget(bodies);
        system.begin(bodies, bodies.vx, bodies.vy, 0);
        return system;
    }

    private static InelasticSystem solved(Heap heap, Bodies bodies, long seed) {
        InelasticSystem system = system(heap, bodies, seed);
        assertTrue(system.size > InelasticSystem.MOST_DENSE, "not the sparse way: " + system.size);
        assertTrue(system.solve(bodies, EXACT), heap + ", seed " + seed);
        return system;
    }

    /** Where large changes of a velocity cancel each other their rounding counts. */
    private static double largestChange(Bodies bodies, InelasticSystem system) {
        double largest = 1;
        for (int k = 0; k < system.size; k++) {
            double inverse = bodies.inverseMass[system.a[k]];
            inverse = Math.max(inverse, system.b[k] < 0 ? 0 : bodies.inverseMass[system.b[k]]);
            largest = Math.max(largest, Math.abs(system.impulse[k]) * inverse);
        }
        return largest;
    }

    /** Velocities of up to 1: approaches of that share remain, impulses push, those of contacts that part are 0. */
    private static void check(String where, Bodies bodies, InelasticSystem system) {
        double[] x = new double[COUNT];
        double[] y = new double[COUNT];
        double exact = EXACT * largestChange(bodies, system);
        for (int k = 0; k < system.size; k++) {
            double left = system.approach(k) - system.allowed[k];
            assertTrue(system.held[k] ? Math.abs(left) <= exact : left <= exact, () -> where + ": approach " + left);
            assertTrue(system.held[k] || system.impulse[k] >= 0, where + ": it pulls");
            assertTrue(system.impulse[k] == 0 || Math.abs(left) <= exact, () -> where + ": opens " + left);
            x[system.a[k]] -= system.impulse[k] * system.normalX[k];
            y[system.a[k]] -= system.impulse[k] * system.normalY[k];
            if (system.b[k] >= 0) {
                x[system.b[k]] += system.impulse[k] * system.normalX[k];
                y[system.b[k]] += system.impulse[k] * system.normalY[k];
            }
        }
        for (int i = 0; i < COUNT; i++) {
            assertEquals(bodies.vx[i] + x[i] * bodies.inverseMass[i], system.vx[i], exact, where);
            assertEquals(bodies.vy[i] + y[i] * bodies.inverseMass[i], system.vy[i], exact, where);
        }
    }

    private static Bodies bodies(Heap heap, long seed) {
        SplitMix64 random = new SplitMix64(seed);
        Bodies bodies = new Bodies(COUNT);
        for (int k = 0; k < COUNT; k++) {
            int row = k / SIDE;
            double x = heap.isLattice() ? 2 * (k % SIDE) + row % 2 : 2 * SIDE * random.nextDouble();
            double y = heap.isLattice() ? row * StrictMath.sqrt(3) : 2 * SIDE * random.nextDouble();
            bodies.add(x, y, 1, heap == Heap.MASSES ? StrictMath.pow(10, 6 * random.nextDouble()) : 1);
            bodies.setVelocity(k, random.nextDouble() - 0.5, random.nextDouble() - 1);
        }
        return bodies;
    }

    /** Contacts of neighbours, with the floor, and in the corner with a wall on the left; some may keep an approach. */
    private static InelasticSystem system(Heap heap, Bodies bodies, long seed) {
        SplitMix64 random = new SplitMix64(~seed);
        InelasticSystem system = empty(bodies);
        for (int j = 0; j < COUNT; j++) {
            for (int i = 0; i < j; i++) {
                double x = bodies.x[j] - bodies.x[i];
                double y = bodies.y[j] - bodies.y[i];
                double distance = Math.sqrt(x * x + y * y);
                if (distance < 2.0001) {
                    system.add(i, j, x / distance, y / distance,
                        random.nextInt(4) == 0 ? 0.1 * random.nextDouble() : 0);
                    system.held[system.size - 1] = heap == Heap.HELD && system.size % 3 == 0;
                }
            }
            if (j < SIDE) {
                system.add(j, ~0, 0, -1, 0);
            }
            if (heap == Heap.CORNER && j % SIDE == 0) {
                system.add(j, ~1, -1, 0, 0);
                system.add(j, ~2, -1, 0, 0);
            }
        }
        for (int k = 0; k < system.size; k++) {
            system.allowed[k] = system.held[k] ? 0 : system.allowed[k];
        }
        return system;
    }
}

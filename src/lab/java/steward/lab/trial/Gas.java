package steward.lab.trial;

import java.util.Locale;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.Wall;

/**
 * Crowd for measurements: equal discs of radius 1 and mass 1 in a square box with perfectly elastic walls. Velocities
 * are uniform in a square, always the same for the same seed. Discs start near the points of a lattice (square, or
 * triangular if that is too dense), each with a small random offset; after a few impacts each, no trace of the lattice
 * is left.
 */
public final class Gas {

    /** Largest coverage: a triangular lattice with a hundredth of room to move. */
    public static final double MOST_COVERAGE = 0.88;
    public static final int MOST_BODIES = 10_000_000;
    /** Most memory for a body, in bytes: 100 in {@link Bodies}, twice, and 220 in an advance. */
    private static final long BYTES = 420;
    private static final double SPEED = 100;

    private final long seed;
    private final int count;
    private final double side;
    private final boolean triangular;

    /**
     * @param count    how many bodies
     * @param coverage the share of the box that is covered
     * @throws IllegalArgumentException if there are too many for the box or the memory; the message says what would be
     *     possible
     */
    public Gas(long seed, int count, double coverage) {
        this.seed = seed;
        this.count = count;
        if (count < 1 || count > MOST_BODIES) {
            throw new IllegalArgumentException("bodies " + count + ", expected 1.." + MOST_BODIES);
        }
        if (!(coverage > 0 && coverage <= MOST_COVERAGE)) {
            throw new IllegalArgumentException(
                "coverage " + coverage + ", expected above 0 and at most " + MOST_COVERAGE);
        }
        if (count * BYTES > Runtime.getRuntime().maxMemory()) {
            throw new IllegalArgumentException(String.format(Locale.ROOT,
                "bodies %d: they take about %d MB, and there are %d MB; expected fewer, or java -Xmx with more", count,
                count * BYTES >> 20, Runtime.getRuntime().maxMemory() >> 20));
        }
        side = Math.sqrt(count * Math.PI / coverage);
        triangular = !(side >= 2 * Math.ceil(Math.sqrt(count)));
        if (triangular && perRow() * (long) rowsOfTriangles() < count) {
            throw new IllegalArgumentException(String.format(Locale.ROOT,
                "bodies %d at coverage %s: a box of %.2f radii a side does not hold so many, expected %d at most, or a "
                    + "lower coverage", count, coverage, side, perRow() * rowsOfTriangles()));
        }
    }

    private int perRow() {
        return triangular ? (int) Math.floor((side - 1) / 2) : (int) Math.ceil(Math.sqrt(count));
    }

    private int rowsOfTriangles() {
        return side < 2 ? 0 : 1 + (int) Math.floor((side - 2) / Math.sqrt(3));
    }

    public int count() {
        return count;
    }

    /** Length of a side of the box, in radii. */
    public double side() {
        return side;
    }

    public Wall[] walls() {
        return Wall.box(side, side, 1);
    }

    /** The bodies at the start. */
    public Bodies bodies() {
        SplitMix64 random = new SplitMix64(seed);
        Bodies bodies = new Bodies(count);
        int columns = perRow();
        int rows = triangular ? rowsOfTriangles() : columns;
        double wide = triangular ? (side - 1) / columns : side / columns;
        double high = triangular ? rows == 1 ? 0 : (side - 2) / (rows - 1) : side / rows;
        double play = triangular ? Math.min(wide / 2 - 1, (Math.hypot(wide / 2, high) - 2) / 4) : wide / 2 - 1;
        for (int k = 0; k < count; k++) {
            int row = k / columns;
            double x = (k % columns + 0.5) * wide + (triangular ? row % 2 * wide / 2 : 0);
            double y = triangular ? 1 + row * high : (row + 0.5) * high;
            double offX = play * (2 * random.nextDouble() - 1);
            double offY = play * (2 * random.nextDouble() - 1);
            bodies.add(Math.min(side - 1, Math.max(1, x + offX)), Math.min(side - 1, Math.max(1, y + offY)), 1, 1);
            bodies.setVelocity(k, SPEED * (2 * random.nextDouble() - 1), SPEED * (2 * random.nextDouble() - 1));
        }
        return bodies;
    }
}

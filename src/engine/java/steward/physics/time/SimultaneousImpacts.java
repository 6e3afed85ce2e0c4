package steward.physics.time;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import steward.numerics.DoubleDouble;
import steward.physics.Bodies;
import steward.physics.Wall;

/**
 * Search for the impacts that happen at the same instant in the arithmetic {@code EXACT}. Of impacts whose times are
 * too close for double-doubles, it finds the earliest and all that have exactly the same time, in the order of their
 * ids. Their states are those before the first of them reacts. Allocates; it is needed only if times are {@link #NEAR}.
 */
public final class SimultaneousImpacts {

    /**
     * Times of a turn whose doubles differ by more are in their order: a double-double is accurate to 2^-60 turns, and
     * its first double is off by half a unit in the last place, 2^-54.
     */
    public static final double NEAR = 0x1p-51;

    private static final Comparator<Impact> BY_TIME = Comparator.comparing(Impact::exact);

    private record Impact(int a, int b, long rank, double time, double timeLow, AlgebraicTime exact) { }

    private final Wall[] walls;
    private final ExactPairs pairs;
    private final ExactWalls exactWalls;
    private final List<Impact> impacts = new ArrayList<>();

    public SimultaneousImpacts(Wall[] walls, ExactPairs pairs, ExactWalls exactWalls) {
        this.walls = walls;
        this.pairs = pairs;
        this.exactWalls = exactWalls;
    }

    /** Orders pairs by their lower index, then by the other; walls come after all bodies, in their own order. */
    public static long rank(int a, int b) {
        int low = b < 0 ? a : Math.min(a, b);
        long other = b < 0 ? (1L << 31) + ~b : Math.max(a, b);
        return (long) low << 32 | other;
    }

    public void clear() {
        impacts.clear();
    }

    /**
     * Adds an impact of two circles.
     *
     * @param a     with b, how the caller calls them
     * @param rank  of their ids; an impact that is added twice has one rank
     * @param until the time from the start of the later flight, as {@link ExactPairs} has computed it
     * @param at    the time of the turn; {@code start} and {@code until} together, but not before the present
     */
    public void addPair(int a, int b, long rank, double x1, double x2, double y1, double y2, double vx1, double vx2,
                        double vy1, double vy2, double r1, double r2, double start, double startLow,
                        DoubleDouble until, DoubleDouble at, boolean isPresent) {
        AlgebraicTime exact = isPresent || until.high() == 0 ? AlgebraicTime.of(at.high(), at.low())
            : AlgebraicTime.ofPair(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2).plus(start, startLow);
        impacts.add(new Impact(a, b, rank, at.high(), at.low(), exact));
    }

    /** Adds an impact of a circle with a wall, as {@link #addPair}. */
    public void addWall(int a, int wall, long rank, double x, double y, double vx, double vy, double radius,
                        double start, double startLow, DoubleDouble until, DoubleDouble at, boolean isPresent) {
        AlgebraicTime exact = isPresent || until.high() == 0 ? AlgebraicTime.of(at.high(), at.low())
            : AlgebraicTime.ofWall(walls[wall], x, y, vx, vy, radius).plus(start, startLow);
        impacts.add(new Impact(a, ~wall, rank, at.high(), at.low(), exact));
    }

    /** Keeps the earliest and those at the same time, in the order of their ranks, each once. */
    public void decide() {
        AlgebraicTime earliest = impacts.stream().min(BY_TIME).orElseThrow().exact();
        impacts.removeIf(impact -> impact.exact().compareTo(earliest) > 0);
        impacts.sort(Comparator.comparingLong(Impact::rank));
        for (int k = impacts.size() - 1; k > 0; k--) {
            if (impacts.get(k).rank() == impacts.get(k - 1).rank()) {
                impacts.remove(k);
            }
        }
    }

    /** True if the two of an impact still approach, where they are now. @param b an index, or {@code ~wall} */
    public boolean areApproaching(Bodies bodies, int a, int b) {
        return b < 0 ? exactWalls.areApproaching(bodies, a, ~b) : pairs.areApproaching(bodies, a, b);
    }

    public int size() {
        return impacts.size();
    }

    /** The first of the k-th. */
    public int a(int k) {
        return impacts.get(k).a();
    }

    /** The second of the k-th: a body, or {@code ~wall}. */
    public int b(int k) {
        return impacts.get(k).b();
    }

    /** Their time: that of the first, since those of the others are off in other digits. */
    public double time() {
        return impacts.get(0).time();
    }

    /** Its low part. */
    public double timeLow() {
        return impacts.get(0).timeLow();
    }
}

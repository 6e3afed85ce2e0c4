package steward.game.meanmax;

import steward.numerics.JavaRandom;
import steward.numerics.StateHash;

/** Tankers that are still to come: one list, of which every player has a copy of its own. */
public final class TankerQueue {

    private static final int TANKERS = 500;
    private static final int SMALLEST = 4;
    private static final int SIZES = 6;

    private final int[] sizes;
    private final double[] angles;
    private final int[] next;
    private final long hash;

    /** Draws, for each of the 500 tankers, its size, 4..9, and then its angle, 0..1. */
    TankerQueue(JavaRandom random, int players) {
        sizes = new int[TANKERS];
        angles = new double[TANKERS];
        StateHash of = new StateHash();
        for (int k = 0; k < TANKERS; k++) {
            sizes[k] = SMALLEST + random.nextInt(SIZES);
            angles[k] = random.nextDouble();
            of.add(sizes[k]).add(angles[k]);
        }
        hash = of.value();
        next = new int[players];
    }

    private TankerQueue(TankerQueue other) {
        sizes = other.sizes;
        angles = other.angles;
        hash = other.hash;
        next = other.next.clone();
    }

    TankerQueue copy() {
        return new TankerQueue(this);
    }

    public int left(int player) {
        return TANKERS - next[player];
    }

    /** The size of the next tanker of a player, 4..9. */
    public int size(int player) {
        return sizes[next[player]];
    }

    /** The angle of the next tanker of a player, as a share of the player's third of the circle, 0..1. */
    public double angle(int player) {
        return angles[next[player]];
    }

    /** Takes the next tanker of a player away. */
    public void take(int player) {
        next[player]++;
    }

    void addTo(StateHash state) {
        state.add(hash);
        for (int taken : next) {
            state.add(taken);
        }
    }
}

package steward.bots;

import java.util.Arrays;

/**
 * All pods at one moment, one array per quantity, so that a look ahead copies them without allocating. Pods stand in
 * the order of the turn frame, which is the order of their ids.
 */
final class Pods {

    /** Value of a passed checkpoint in u; more than any distance on a field. */
    private static final double CHECKPOINT_WORTH = 30000;

    int size;
    int[] player = new int[8];
    double[] x = new double[8];
    double[] y = new double[8];
    double[] vx = new double[8];
    double[] vy = new double[8];
    /** The unit vector of the heading; (0, 0) while unset. A vector needs no trigonometry to be turned. */
    double[] headingX = new double[8];
    double[] headingY = new double[8];
    /** Number of the checkpoint to pass next. */
    int[] next = new int[8];
    /** Checkpoints passed since the start. */
    int[] passed = new int[8];
    /** Turns that the engine stays off; 0 for pods of others, whose frames do not show it. */
    int[] shieldTimer = new int[8];
    boolean[] boostLeft = new boolean[8];

    /** Makes room for one more pod and returns its index; the old values there are not cleared. */
    int add() {
        if (size == x.length) {
            grow(2 * size);
        }
        return size++;
    }

    private void grow(int capacity) {
        player = Arrays.copyOf(player, capacity);
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        vx = Arrays.copyOf(vx, capacity);
        vy = Arrays.copyOf(vy, capacity);
        headingX = Arrays.copyOf(headingX, capacity);
        headingY = Arrays.copyOf(headingY, capacity);
        next = Arrays.copyOf(next, capacity);
        passed = Arrays.copyOf(passed, capacity);
        shieldTimer = Arrays.copyOf(shieldTimer, capacity);
        boostLeft = Arrays.copyOf(boostLeft, capacity);
    }

    void clear() {
        size = 0;
    }

    /** Adds a copy of a pod of other pods. */
    void add(Pods other, int pod) {
        int k = add();
        player[k] = other.player[pod];
        x[k] = other.x[pod];
        y[k] = other.y[pod];
        vx[k] = other.vx[pod];
        vy[k] = other.vy[pod];
        headingX[k] = other.headingX[pod];
        headingY[k] = other.headingY[pod];
        next[k] = other.next[pod];
        passed[k] = other.passed[pod];
        shieldTimer[k] = other.shieldTimer[pod];
        boostLeft[k] = other.boostLeft[pod];
    }

    /** Becomes a copy of other pods. */
    void set(Pods other) {
        clear();
        for (int pod = 0; pod < other.size; pod++) {
            add(other, pod);
        }
    }

    /** Distance from a pod to the centre of its next checkpoint. */
    double toNext(Race race, int pod) {
        double dx = race.checkpointX[next[pod]] - x[pod];
        double dy = race.checkpointY[next[pod]] - y[pod];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /**
     * Cosine of the angle between a pod's heading and the way to a place; 1 if there is no angle, because the heading
     * is unset or the pod is there.
     */
    double cosineTo(int pod, double x, double y) {
        double dx = x - this.x[pod];
        double dy = y - this.y[pod];
        double distance = Math.sqrt(dx * dx + dy * dy);
        boolean unset = headingX[pod] == 0 && headingY[pod] == 0;
        return unset || distance == 0 ? 1 : (headingX[pod] * dx + headingY[pod] * dy) / distance;
    }

    /** A pod's progress, in u: more for every checkpoint passed, less for the distance to the next. */
    double progress(Race race, int pod) {
        return CHECKPOINT_WORTH * passed[pod] - toNext(race, pod);
    }

    /** True if a pod has passed more checkpoints than another, or as many and is nearer to the next. */
    boolean isAhead(Race race, int pod, int other) {
        return passed[pod] != passed[other] ? passed[pod] > passed[other]
            : toNext(race, pod) < toNext(race, other);
    }
}

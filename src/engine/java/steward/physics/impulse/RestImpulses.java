package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * Solver for the impulses of a heap that comes to rest ({@link Rest}). It solves the system of its contacts, ascending
 * by ids, applies the impulses one after the other, and records one impact for each contact that exchanges an impulse.
 *
 * <p>Afterwards the contacts of the system part at 2^-42 of its speeds, so that rounding leaves no approach. If they
 * cannot part, in a gap that is just filled or too narrow, velocities below 2^-40 of the speeds become 0.
 */
final class RestImpulses {

    /** Contacts of a system part at this share of its speeds, above the rounding of velocities and normals. */
    private static final double PARTING = 0x1p-42;
    /** Share of the largest change of a velocity by one impulse that is a speed of the system: its rounding counts. */
    private static final double CHANGES = 0x1p-8;
    /** Where contacts cannot part, velocities below this share of the speeds are 0. */
    private static final double STILL = 0x1p-40;

    private final InelasticSystem system;
    private final Wall[] walls;
    private final RestRims rims;
    private double speed;
    private boolean parts;
    /** Of a body, its last contact with an impulse. */
    private int[] lastOf = new int[0];
    /** Energy that bounces would have given back in the last {@link #exchange}. */
    double lost;

    RestImpulses(InelasticSystem system, Wall[] walls, RestRims rims) {
        this.system = system;
        this.walls = walls;
        this.rims = rims;
    }

    /** Begins an empty system of bodies with these velocities. */
    void begin(Bodies bodies, int[] heap, int heapSize, double[] x, double[] y) {
        speed = 0;
        for (int k = 0; k < heapSize; k++) {
            speed = Math.max(speed, Math.abs(x[heap[k]]) + Math.abs(y[heap[k]]));
        }
        parts = true;
        system.begin(bodies, x, y, PARTING * speed);
    }

    /** An approach up to this speed remains. */
    double tolerance() {
        return (parts ? 0.75 : 1) * PARTING * speed;
    }

    /** True if an approach speed is that of a contact that opens by more than contacts part. */
    boolean opens(double approach) {
        return approach < -4 * PARTING * speed;
    }

    /** Solves the system anew, with what is held now. */
    void restart(Bodies bodies) {
        system.restart(parts ? PARTING * speed : 0);
    }

    /** Solves the system anew after normals were turned. */
    void resume(Bodies bodies) {
        system.resume(bodies);
    }

    /** Solves the system; contacts do not part if they cannot, and faster where large changes cancel each other. */
    void solve(Bodies bodies) {
        solveOnce(bodies);
        double change = system.largestChange(bodies);
        if (parts && change * CHANGES > speed) {
            speed = change * CHANGES;
            system.restart(PARTING * speed);
            solveOnce(bodies);
        }
    }

    private void solveOnce(Bodies bodies) {
        if (!system.solve(bodies, tolerance()) && parts) {
            parts = false;
            system.restart(0);
            system.solve(bodies, tolerance());
        }
    }

    /**
     * Solves the accelerations that the contacts of a solved system leave; the system has them instead of velocities.
     *
     * @param x with y, the accelerations by all forces
     */
    void carry(Bodies bodies, RestLaw law, double time, double[] x, double[] y) {
        double largest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            largest = Math.max(largest, Math.abs(x[i]) + Math.abs(y[i]));
        }
        int carrying = 0;
        for (int k = 0; k < system.size; k++) {
            double may = system.carries(k) ? acceleration(k, law, time) : Double.POSITIVE_INFINITY;
            if (may < Double.POSITIVE_INFINITY) {
                system.turn(k, system.normalX[k], system.normalY[k], may);
                system.swap(carrying++, k);
            }
        }
        system.size = carrying;
        system.beginFrom(bodies, x, y, 0);
        system.solve(bodies, RestLaw.ROUNDING * largest);
    }

    /**
     * The acceleration along its normal that a contact leaves: none if it is closed. With a gap, so much that the
     * bodies approach no faster at the instant than they did: v = w + a (1/2 - s).
     */
    private double acceleration(int k, RestLaw law, double time) {
        if (system.held[k] || !(system.allowed[k] > 0) || rims.isRim(system.b[k])) {
            return 0;
        }
        return time < 0.5 ? Math.max(0, (system.allowed[k] - system.approach(k, law.instantX, law.instantY))
            / (0.5 - time)) : Double.POSITIVE_INFINITY;
    }

    /**
     * True if the solved system has no more energy than the bodies of the heap: that is so for every projection, but
     * not for what rounding makes of nearly parallel contacts without a way out.
     */
    boolean isNearer(Bodies bodies, int[] heap, int heapSize) {
        double before = 0;
        double after = 0;
        for (int k = 0; k < heapSize; k++) {
            int i = heap[k];
            before += bodies.mass[i] * (bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]);
            after += bodies.mass[i] * (system.vx[i] * system.vx[i] + system.vy[i] * system.vy[i]);
        }
        return after <= before * (1 + STILL);
    }

    /** Applies the impulses one after the other, ascending by ids, and records them. @return how many there are */
    int exchange(Bodies bodies, RestLaw law, double time, TurnSink sink) {
        system.sort(bodies);
        findLast(bodies);
        lost = 0;
        double still = parts ? 0 : STILL * speed;
        int exchanged = 0;
        for (int k = 0; k < system.size; k++) {
            if (system.impulse[k] != 0) {
                exchanged++;
                int a = system.a[k];
                int b = system.b[k];
                boolean last = still > 0 && lastOf[a] == k;
                double j = system.impulse[k];
                double nx = system.normalX[k];
                double ny = system.normalY[k];
                double vax = bodies.vx[a];
                double vay = bodies.vy[a];
                double vbx = b < 0 ? 0 : bodies.vx[b];
                double vby = b < 0 ? 0 : bodies.vy[b];
                double inverse = bodies.inverseMass[a] + (b < 0 ? 0 : bodies.inverseMass[b]);
                double energy = j * (j * inverse / 2 - system.approach(k, bodies.vx, bodies.vy));
                double restitution = law.restitution(bodies, a, b);
                lost -= energy * restitution * restitution;
                accelerate(bodies, a, -j * bodies.inverseMass[a], nx, ny, last ? still : 0);
                if (b >= 0) {
                    accelerate(bodies, b, j * bodies.inverseMass[b], nx, ny, still > 0 && lastOf[b] == k ? still : 0);
                }
                double ax = bodies.x[a];
                double ay = bodies.y[a];
                double reach = b < 0 ? walls[~b].gap(ax, ay, bodies.radius[a]) + bodies.radius[a] : 0;
                double bx = b < 0 ? ax + nx * reach : bodies.x[b];
                double by = b < 0 ? ay + ny * reach : bodies.y[b];
                sink.impact(time, bodies.id(a), b < 0 ? b : bodies.id(b), ax, ay, bx, by, nx, ny, j, energy,
                    bodies.mass[a], b < 0 ? Double.POSITIVE_INFINITY : bodies.mass[b], vax, vay, bodies.vx[a],
                    bodies.vy[a], vbx, vby, b < 0 ? 0 : bodies.vx[b], b < 0 ? 0 : bodies.vy[b]);
                sink.knot(bodies.id(a), time, ax, ay);
                if (b >= 0) {
                    sink.knot(bodies.id(b), time, bx, by);
                }
            }
        }
        return exchanged;
    }

    private void findLast(Bodies bodies) {
        if (lastOf.length < bodies.size()) {
            lastOf = new int[bodies.capacity()];
        }
        for (int k = 0; k < system.size; k++) {
            if (system.impulse[k] != 0) {
                lastOf[system.a[k]] = k;
                if (system.b[k] >= 0) {
                    lastOf[system.b[k]] = k;
                }
            }
        }
    }

    private static void accelerate(Bodies bodies, int i, double by, double nx, double ny, double still) {
        bodies.vx[i] = stilled(bodies.vx[i] + by * nx, still);
        bodies.vy[i] = stilled(bodies.vy[i] + by * ny, still);
    }

    private static double stilled(double v, double still) {
        return Math.abs(v) <= still ? 0 : v;
    }
}

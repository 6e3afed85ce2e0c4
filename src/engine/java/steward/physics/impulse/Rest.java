package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;

/*
 * Flights of a turn are straight until the next impact. Of two bodies with the gap g, the normal n and the relative
 * velocity v the distance is at least its part along n, so they do not meet in a time tau if n.v tau <= g; the same
 * holds for a straight wall. The places inside an arena are convex, so a body on a straight path stays inside if its
 * end is inside, and that holds if n'.(x + v tau) <= room for the normal n' there. All of these are linear conditions
 * on the velocities, and those of rest satisfy them. A rim has one condition; its normal is turned until it is that of
 * the end of the path. So the impulse of a rim stands against the motion by half of the angle that the path covers: a
 * heap that swings in an arena of the room R loses a / 4R of its swing a turn. Nothing else can take it: what a round
 * wall exerts goes through its centre, and the angular momentum about that stays.
 *
 * On level ground with the acceleration a, a rebound at the speed r is back after 2 r / a turns: r = e u <= a / 2 is
 * less than a turn. A body that lies on it is accelerated by a at the start of each turn, so u* = a - a / 2, and 2 e u*
 * = e a <= a: it stays. With a lower threshold some bounces of n turns would repeat for ever.
 *
 * In a heap at the fraction s of a turn, w = v + a (s - 1/2) are the velocities, and w + a / 2 = v + a s those of half
 * a turn later, were nothing in the way. A contact along which they approach is one to which the bodies would come back
 * within a turn: w.n + a.n / 2 >= 0. So the contacts that carry an impulse in the projection of v + a s are closed, and
 * the flights of the rest of the turn are v, projected where closed contacts may not open either: they then take the
 * same part of the accelerations and of the velocities. At the start of a turn the two are one. A contact with a gap
 * that the flights are kept from leaves so much of the accelerations that the bodies approach no faster at the instant
 * than they did: with all of it they would part at up to a / 2 there, with none they might approach without cause.
 * Both would be energy from nowhere, and heaps would not come to rest.
 */

/**
 * Rest: the end of bounces that would never end. With restitution below 1, bodies that press against each other or
 * against a wall bounce infinitely often in a finite time.
 *
 * <ol>
 * <li>An impact is rest if it has no restitution; if its rebound e u is at most half of the larger acceleration of its
 * bodies by forces, so that on level ground it would fly for less than a turn; or if its energy along the normal is
 * below 2^-40 of the largest kinetic energy that each of its bodies has had in this turn. One contact is enough. A law
 * may name the rebound instead ({@link ImpactLaw#restSpeed}).
 * <li>A heap is what hangs together by gaps of at most 1/{@value #NEAR} of the sum of the radii. A contact that
 * approaches faster than rest is no part of it: it bounces.
 * <li>At rest the bodies of the heap take the velocities that are nearest to theirs, measured by the kinetic energy,
 * among those with which none of them meets another, a wall or an infinite mass before the turn ends
 * ({@link InelasticSystem}). Contacts to which forces would bring them back within a turn are closed.
 * <li>Each contact that this takes an impulse is recorded as an impact, ascending by ids, at one time, with the
 * velocities of flights. The impulse of a contact that is kept closed is negative.
 * <li>Gaps up to the sum of the radii belong to a heap that has come to rest before in the turn: so few disturb it.
 * </ol>
 *
 * <p>If something approaches even so, the turn has its named ending. The file is long: all shares the heap's arrays.
 */
public final class Rest {

    /**
     * Gaps up to 1 / NEAR of the sum of the radii belong to a heap: 0.05%, which nobody sees, and far more than
     * rounding leaves between bodies that rest. With a larger share bodies would rest at a distance that shows.
     */
    public static final int NEAR = 2048;
    /** The share of a gap that is used up until the end of the turn: the rest is room for rounding. */
    private static final double USED = 0.99;
    /** Gaps below this share of the radii are closed: contacts at rest part by rounding, some of them by over 2^-30. */
    static final double CLOSED = 0x1p-24;
    /** A gap below this share of the radii is not used: rounding may be as large as what is left of it. */
    static final double ROUNDED = 0x1p-30;
    /** The shortest rest of a turn that is divided by. */
    private static final double LEAST_LEFT = 0x1p-20;
    /**
     * From so many bodies on, all contacts of a heap with small gaps are conditions at once, linear in the velocities,
     * not one by one as they are violated: results differ by the second order of the way over the gap.
     */
    private static final int FEWEST_AT_ONCE = 32;
    private final Wall[] walls;
    private final Contacts contacts;
    private final RestLaw law;
    /** {@code null} where no force acts. */
    private final Accelerations accelerations;
    private final InelasticSystem system = new InelasticSystem();
    private final RestImpulses impulses;
    private final RestRims rims;
    private final HeapPaths paths;
    private final HeapNeighbours neighbours = new HeapNeighbours();
    /** True if a body's heap has come to rest in this turn. */
    private boolean[] rested = new boolean[0];
    private int[] heap = new int[0];
    /** Of a body in the heap; -1 outside. */
    private int[] place = new int[0];
    private int heapSize;
    private int touching;
    private boolean squeezed;
    private int size;
    /** The velocities with which they came. */
    private double[] flightX = new double[0];
    private double[] flightY = new double[0];
    /** Velocities ahead of the instant, then accelerations. */
    private double[] aheadX = new double[0];
    private double[] aheadY = new double[0];
    private int[] closedA = new int[0];
    private int[] closedB = new int[0];
    private int closed;
    /** Share of the accelerations between the velocities of the system and those of the instant, in turns. */
    private double toInstant;
    /** True if the impact is no faster than what forces do to bodies at rest in half a turn. */
    private boolean calm;

    private Rest(PhysicsParts parts, Wall[] walls, Accelerations accelerations) {
        this.walls = walls;
        this.accelerations = accelerations;
        rims = new RestRims(system, walls);
        impulses = new RestImpulses(system, walls, rims);
        paths = new HeapPaths(system, impulses);
        contacts = parts.contacts();
        law = new RestLaw(parts, walls, accelerations);
    }

    /**
     * @param accelerations of the turn, or {@code null}
     * @return {@code null} for laws without rest: elastic, with a minimum impulse, or in batches
     */
    public static Rest of(PhysicsParts parts, Wall[] walls, Accelerations accelerations) {
        return parts.law().bodiesRest() && !parts.law().separatingPairsReact()
            ? new Rest(parts, walls, accelerations) : null;
    }

    public void begin(Bodies bodies) {
        size = bodies.size();
        law.begin(bodies);
        if (rested.length < size) {
            int capacity = bodies.capacity();
            rested = new boolean[capacity];
            heap = new int[capacity];
            place = new int[capacity];
            flightX = new double[capacity];
            flightY = new double[capacity];
            aheadX = new double[capacity];
            aheadY = new double[capacity];
            Arrays.fill(place, -1);
        }
        squeezed = false;
        Arrays.fill(rested, 0, size, false);
    }

    /**
     * True if a contact of two that are where they are now is rest: a plain impact, no slide, while nothing passes
     * through anything else. Called for every impact: the kinetic energies are those of the flights that end here.
     *
     * @param b another body, or {@code ~wall}
     */
    public boolean mayRest(Bodies bodies, int a, int b, double time) {
        if (b < 0 && RimSliding.grazes(bodies, a, walls[~b]) || !bodies.passing().isEmpty()
            || Contacts.Meaning.BOUNCE != (b < 0 ? contacts.withWall(bodies.kind[a])
            : contacts.between(bodies.kind[a], bodies.kind[b]))) {
            return false;
        }
        law.see(bodies, a, time - 0.5);
        if (b >= 0) {
            law.see(bodies, b, time - 0.5);
        }
        return law.isRest(bodies, a, b, law.approach(bodies, a, b));
    }

    /** True if an impact has no restitution, and nothing but its two bodies can have a part in it. */
    public boolean isPlain(Bodies bodies, int a, int b) {
        return accelerations == null && law.restitution(bodies, a, b) == 0;
    }

    /**
     * Lets the heap of an impact rest; all bodies are where they are now.
     *
     * @return how many impacts that has taken; 0 if it is an ordinary impact, and nothing was altered
     */
    public int settle(Bodies bodies, int a, int b, double time, TurnSink sink) {
        for (int i = 0; i < size; i++) {
            law.see(bodies, i, time - 0.5);
            flightX[i] = bodies.vx[i];
            flightY[i] = bodies.vy[i];
        }
        neighbours.begin(bodies);
        system.forget(bodies);
        gather(bodies, a, b);
        boolean rests = touching > 1 || !isPlain(bodies, a, b);
        int exchanged = 0;
        if (rests) {
            solve(bodies, b < 0 ? a : Math.min(a, b), b < 0 ? b : Math.max(a, b), time);
            rests = !(system.impulse[0] == 0 && system.approach(0) > 0);
            squeezed = !rests && system.approach(0) > impulses.tolerance();
        }
        if (rests) {
            exchanged = impulses.exchange(bodies, law, time, sink);
            if (accelerations == null) {
                sink.rest(time, impulses.lost);
            } else {
                forceAhead(bodies);
                impulses.carry(bodies, law, time, aheadX, aheadY);
                for (int k = 0; k < heapSize; k++) {
                    accelerations.x[heap[k]] = system.vx[heap[k]];
                    accelerations.y[heap[k]] = system.vy[heap[k]];
                }
            }
        } else {
            restore(bodies);
        }
        for (int k = 0; k < heapSize; k++) {
            place[heap[k]] = -1;
            rested[heap[k]] |= rests;
        }
        return rests ? Math.max(1, exchanged) : 0;
    }

    /** Solves the contacts that the heap would meet in the rest of the turn, until it meets none. */
    private void solve(Bodies bodies, int a, int b, double time) {
        double left = Math.max(1 - time, LEAST_LEFT);
        closed = 0;
        toInstant = 0;
        calm = false;
        if (accelerations != null) {
            calm = law.approach(bodies, a, b) <= 0.5 * accelerations.largest(bodies, a, b) * (1 + RestLaw.ROUNDING);
            close(bodies, a, b, time);
            toInstant = time - 0.5;
        }
        impulses.begin(bodies, heap, heapSize, bodies.vx, bodies.vy);
        addContact(bodies, a, b, left);
        addNear(bodies, left);
        do {
            meetAll(bodies, left);
        } while (holdsMore(bodies, left));
        if (!impulses.isNearer(bodies, heap, heapSize)) {
            restore(bodies);
            impulses.begin(bodies, heap, heapSize, bodies.vx, bodies.vy);
            addContact(bodies, a, b, 0);
            impulses.solve(bodies);
        }
    }

    private void meetAll(Bodies bodies, double left) {
        int before;
        int rounds = RestRims.MOST_TURNS;
        boolean turned;
        do {
            before = system.size;
            impulses.solve(bodies);
            addMet(bodies, left);
            turned = left > 0 && rounds > 0 && rims.turn(bodies, left);
            if (turned) {
                impulses.resume(bodies);
                rounds--;
            }
        } while (system.size > before || turned);
    }

    /** Finds the contacts that are closed, and gives the heap the velocities of whole flights by all forces. */
    private void close(Bodies bodies, int a, int b, double time) {
        for (int i = 0; i < size; i++) {
            double x = accelerations.forces.x(bodies, i);
            double y = accelerations.forces.y(bodies, i);
            aheadX[i] = law.instantX[i] + x * 0.5;
            aheadY[i] = law.instantY[i] + y * 0.5;
            if (place[i] >= 0) {
                bodies.vx[i] = law.instantX[i] - x * (time - 0.5);
                bodies.vy[i] = law.instantY[i] - y * (time - 0.5);
            }
        }
        if (time == 0) {
            return;
        }
        toInstant = -0.5;
        impulses.begin(bodies, heap, heapSize, aheadX, aheadY);
        addContact(bodies, a, b, 0);
        addNear(bodies, 0);
        meetAll(bodies, 0);
        if (closedA.length < system.size) {
            closedA = new int[2 * system.size];
            closedB = new int[2 * system.size];
        }
        for (int k = 0; k < system.size; k++) {
            if (system.carries(k)) {
                closedA[closed] = system.a[k];
                closedB[closed++] = system.b[k];
            }
        }
    }

    /** Holds the closed contacts that would open. @return whether there are more of them */
    private boolean holdsMore(Bodies bodies, double left) {
        int before = closed;
        for (int k = closed - 1; k >= 0; k--) {
            int a = closedA[k];
            int b = closedB[k];
            law.look(bodies, a, b);
            double x = system.vx[a] - (b < 0 ? 0 : system.vx[b]);
            double y = system.vy[a] - (b < 0 ? 0 : system.vy[b]);
            boolean rim = rims.isRim(b);
            if (rim) {
                rims.look(bodies, a, ~b, left);
            }
            if ((rim ? rims.beyond < 0 : impulses.opens(law.normalX * x + law.normalY * y))) {
                int held = system.hold(a, b, law.normalX, law.normalY);
                if (rim) {
                    system.turn(held, rims.normalX, rims.normalY, rims.allowed);
                }
                closed--;
                closedA[k] = closedA[closed];
                closedB[k] = closedB[closed];
            }
        }
        if (closed < before) {
            impulses.restart(bodies);
        }
        return closed < before;
    }

    private void restore(Bodies bodies) {
        System.arraycopy(flightX, 0, bodies.vx, 0, size);
        System.arraycopy(flightY, 0, bodies.vy, 0, size);
    }

    private void forceAhead(Bodies bodies) {
        for (int i = 0; i < size; i++) {
            aheadX[i] = accelerations.forces.x(bodies, i);
            aheadY[i] = accelerations.forces.y(bodies, i);
        }
    }

    /** Adds all contacts of a large heap that have a small gap; at 0, those that are closed: others are expected. */
    private void addNear(Bodies bodies, double left) {
        for (int k = 0; k < heapSize && heapSize >= FEWEST_AT_ONCE; k++) {
            int i = heap[k];
            int near = neighbours.find(bodies, i, 1.0 / NEAR, 0);
            for (int n = 0; n < near; n++) {
                int j = neighbours.found[n];
                if ((place[j] >= 0 && place[j] < k || bodies.inverseMass[j] == 0) && meet(bodies, i, j)) {
                    addIfNear(bodies, Math.min(i, j), Math.max(i, j), left);
                }
            }
            for (int w = 0; w < walls.length; w++) {
                if (contacts.withWall(bodies.kind[i]) == Contacts.Meaning.BOUNCE) {
                    addIfNear(bodies, i, ~w, left);
                }
            }
        }
    }

    private void addIfNear(Bodies bodies, int i, int j, double left) {
        double radii = RestLaw.radii(bodies, i, j);
        boolean isNear = law.isRest(bodies, i, j, law.approach(bodies, i, j)) && law.gap * NEAR <= radii;
        if (isNear && left == 0 && law.gap > CLOSED * radii) {
            system.expect(i, j);
        } else if (isNear && system.find(i, j) < 0) {
            if (left > 0 && rims.isRim(j)) {
                rims.look(bodies, i, ~j, left);
                system.add(i, j, rims.normalX, rims.normalY, rims.allowed);
            } else {
                addContact(bodies, i, j, left);
            }
        }
    }

    /** Adds the contacts that would meet within a time; at 0, those that touch and approach. */
    private void addMet(Bodies bodies, double left) {
        double path = paths.longest(bodies, place, left);
        for (int k = 0; k < heapSize; k++) {
            int i = heap[k];
            int near = neighbours.find(bodies, i, CLOSED, 2 * path);
            for (int n = 0; n < near; n++) {
                int j = neighbours.found[n];
                if ((place[j] >= 0 && place[j] < k || bodies.inverseMass[j] == 0) && meet(bodies, i, j)
                    && paths.meet(bodies, i, j, left)) {
                    addOnce(bodies, Math.min(i, j), Math.max(i, j), left);
                }
            }
            for (int w = 0; w < walls.length; w++) {
                if (contacts.withWall(bodies.kind[i]) != Contacts.Meaning.BOUNCE) {
                    continue;
                }
                if (left > 0 && rims.isRim(~w)) {
                    addRim(bodies, i, w, left);
                } else if (paths.meetWall(bodies, i, walls[w], left)) {
                    addOnce(bodies, i, ~w, left);
                }
            }
        }
    }

    private void addOnce(Bodies bodies, int i, int j, double left) {
        if (system.find(i, j) < 0) {
            law.look(bodies, i, j);
            if (joins(bodies, i, j, law.normalX, law.normalY)) {
                addContact(bodies, i, j, left);
            }
        }
    }

    /**
     * True if a contact that the velocities of the system approach along a normal is rest: it was before, and still is,
     * or its bodies touch and forces alone have brought them together.
     */
    private boolean joins(Bodies bodies, int i, int j, double nx, double ny) {
        return law.isRest(bodies, i, j, law.approach(bodies, i, j))
            && (calm && law.gap * NEAR <= RestLaw.radii(bodies, i, j)
            || law.isRest(bodies, i, j, nx * (system.vx[i] - (j < 0 ? 0 : system.vx[j]))
            + ny * (system.vy[i] - (j < 0 ? 0 : system.vy[j]))
            + (toInstant == 0 ? 0 : toInstant * law.accelerated(bodies, i, j, nx, ny))));
    }

    private void addContact(Bodies bodies, int a, int b, double left) {
        law.look(bodies, a, b);
        add(bodies, a, b, law.normalX, law.normalY, law.gap, left);
    }

    /** Adds the tangent of the rim that a body would leave, where it would be at the end of the turn. */
    private void addRim(Bodies bodies, int i, int w, double left) {
        if (system.find(i, ~w) < 0) {
            rims.look(bodies, i, w, left);
            double nx = rims.normalX;
            double ny = rims.normalY;
            law.look(bodies, i, ~w);
            if (rims.beyond > 0 && joins(bodies, i, ~w, nx, ny)) {
                system.add(i, ~w, nx, ny, rims.allowed);
            }
        }
    }

    private void add(Bodies bodies, int a, int b, double nx, double ny, double apart, double left) {
        boolean open = left > 0 && apart > ROUNDED * RestLaw.radii(bodies, a, b);
        system.add(a, b, nx, ny, open ? USED * apart / left : 0);
    }

    /** True if the last heap still approaches: there is no room, and no way out. */
    public boolean isSqueezed() {
        return squeezed;
    }

    /**
     * The gaps of the heap of an impact, as a share of the sum of the radii: wider if it has come to rest in this turn.
     */
    public double near(int a, int b) {
        return rested[a] || b >= 0 && rested[b] ? 1 : 1.0 / NEAR;
    }

    /** Collects what hangs on an impact by small gaps, body by body, and counts the contacts of the two. */
    private void gather(Bodies bodies, int a, int b) {
        double gapShare = near(a, b);
        heapSize = 0;
        touching = 1;
        enter(bodies, a);
        if (b >= 0) {
            enter(bodies, b);
        }
        for (int k = 0; k < heapSize; k++) {
            int i = heap[k];
            int near = neighbours.find(bodies, i, gapShare, 4 * rounding(bodies, i));
            for (int n = 0; n < near; n++) {
                int j = neighbours.found[n];
                boolean isPair = i == a && j == b || i == b && j == a;
                if (j != i && !isPair && meet(bodies, i, j) && isNear(bodies, i, j, gapShare)) {
                    touching++;
                    enter(bodies, j);
                }
            }
            for (int w = 0; w < walls.length; w++) {
                if (!(i == a && b == ~w) && contacts.withWall(bodies.kind[i]) == Contacts.Meaning.BOUNCE
                    && walls[w].gap(bodies.x[i], bodies.y[i], bodies.radius[i])
                    <= gapShare * bodies.radius[i] + rounding(bodies, i)
                    && law.isRest(bodies, i, ~w, law.approach(bodies, i, ~w))) {
                    touching++;
                }
            }
        }
    }

    /** An infinite mass ends a heap: nothing goes through it. */
    private void enter(Bodies bodies, int i) {
        if (place[i] < 0 && bodies.inverseMass[i] > 0) {
            place[i] = heapSize;
            heap[heapSize++] = i;
        }
    }

    private boolean meet(Bodies bodies, int i, int j) {
        return contacts.between(bodies.kind[i], bodies.kind[j]) == Contacts.Meaning.BOUNCE;
    }

    /** True if a contact belongs to a heap: a small gap, and no approach that bounces. */
    private boolean isNear(Bodies bodies, int i, int j, double gapShare) {
        double dx = bodies.x[i] - bodies.x[j];
        double dy = bodies.y[i] - bodies.y[j];
        return Math.sqrt(dx * dx + dy * dy) - bodies.radius[i] - bodies.radius[j]
            <= gapShare * (bodies.radius[i] + bodies.radius[j]) + rounding(bodies, i) + rounding(bodies, j)
            && law.isRest(bodies, i, j, law.approach(bodies, i, j));
    }

    private static double rounding(Bodies bodies, int i) {
        return 0x1p-46 * (Math.abs(bodies.x[i]) + Math.abs(bodies.y[i]));
    }
}

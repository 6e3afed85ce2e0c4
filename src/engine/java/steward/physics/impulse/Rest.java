package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;

/*
 * Nothing accelerates within a turn, so paths are straight until the next impact. Of two bodies with the gap g, the
 * normal n and the relative velocity v the distance is at least its part along n, so they do not meet in a time tau if
 * n.v tau <= g; the same holds for a straight wall. The places inside an arena are convex, so a body on a straight path
 * stays inside if its end is inside, and that holds if n'.(x + v tau) <= room for the normal n' there. All of these are
 * linear conditions on the velocities, and those of rest satisfy them.
 */

/**
 * Rest: the end of bounces that would never end. Where restitution is below 1, bodies that press against each other or
 * against a wall bounce infinitely often in a finite time.
 *
 * <ol>
 * <li>A heap is what hangs together by gaps of at most 1/{@value #NEAR} of the sum of the radii, with two contacts or
 * more.
 * <li>In a heap an impact without restitution, or of a body that has had {@value #PATIENCE} others in this turn, is
 * rest; all other impacts bounce.
 * <li>At rest the bodies of the heap take the velocities that are nearest to theirs, measured by the kinetic energy,
 * among those with which none of them meets another, a wall or an infinite mass before the turn ends
 * ({@link InelasticSystem}).
 * <li>Each contact that this takes an impulse is recorded as an impact, ascending by ids, at one time.
 * <li>Only other bodies can disturb a heap in the same turn; so that few do, gaps up to the sum of the radii belong to
 * a heap that has come to rest before.
 * </ol>
 *
 * <p>Nothing depends on bodies elsewhere. A law may set the speed up to which a rebound in a heap is rest
 * ({@link ImpactLaw#restSpeed}), in place of the second sentence. If something approaches even so, the turn has its
 * named ending.
 */
public final class Rest {

    /**
     * Gaps up to 1 / NEAR of the sum of the radii belong to a heap: 0.05%, which nobody sees, and far more than
     * rounding leaves between bodies that rest. With a larger share bodies would rest at a distance that shows.
     */
    public static final int NEAR = 2048;
    /**
     * Impacts of a body in a turn before its heap rests. So n bodies bounce at most 2 n times before; the rest takes an
     * impulse for each contact, at most 3 n in the plane. More patience would keep more bounces, and cost as many more.
     */
    public static final int PATIENCE = 4;
    /** The share of a gap that is used up until the end of the turn: the rest is room for rounding. */
    private static final double USED = 0.99;
    /** Gaps below this share of the radii are closed: rounding may be as large as what is left of them. */
    private static final double CLOSED = 0x1p-30;
    /** A path that ends this share of the room outside an arena ends on its rim. */
    private static final double RIM = 0x1p-40;
    /** The shortest rest of a turn that is divided by. */
    private static final double LEAST_LEFT = 0x1p-20;

    private final Wall[] walls;
    private final Contacts contacts;
    private final RestitutionRule restitutionRule;
    /** Of the law; NaN for the default. */
    private final double restSpeed;
    private final InelasticSystem system = new InelasticSystem();
    private final RestImpulses impulses;
    /** True if a body's heap has come to rest in this turn. */
    private boolean[] rested = new boolean[0];
    private int[] impacts = new int[0];
    private int[] heap = new int[0];
    /** Of a body in the heap; -1 outside. */
    private int[] place = new int[0];
    private int heapSize;
    private int touching;
    private boolean squeezed;
    private int size;

    private Rest(PhysicsParts parts, Wall[] walls) {
        this.walls = walls;
        impulses = new RestImpulses(system, walls);
        contacts = parts.contacts();
        restSpeed = parts.law().restSpeed();
        restitutionRule = RestitutionRule.of(parts.law());
    }

    /** @return {@code null} for laws without rest: elastic, with a minimum impulse, or in batches */
    public static Rest of(PhysicsParts parts, Wall[] walls) {
        return parts.law().bodiesRest() && !parts.law().separatingPairsReact() ? new Rest(parts, walls) : null;
    }

    public void begin(Bodies bodies) {
        size = bodies.size();
        if (impacts.length < size) {
            int capacity = bodies.capacity();
            impacts = new int[capacity];
            rested = new boolean[capacity];
            heap = new int[capacity];
            place = new int[capacity];
            Arrays.fill(place, -1);
        }
        squeezed = false;
        for (int i = 0; i < size; i++) {
            impacts[i] = 0;
            rested[i] = false;
        }
    }

    /** After a reaction of the scene: begins anew if bodies were removed or added. */
    public void follow(Bodies bodies) {
        if (bodies.size() != size) {
            begin(bodies);
        }
    }

    /** True if a contact is a plain impact, no slide, and nothing passes through anything else. */
    public boolean isAbout(Bodies bodies, int a, int b) {
        return !(b < 0 && RimSliding.grazes(bodies, a, walls[~b])) && bodies.passing().isEmpty()
            && Contacts.Meaning.BOUNCE == (b < 0 ? contacts.withWall(bodies.kind[a])
            : contacts.between(bodies.kind[a], bodies.kind[b]));
    }

    /**
     * Counts an impact of two that are where they are now.
     *
     * @param b another body, or {@code ~wall}
     * @return whether it is rest if it belongs to a heap
     */
    public boolean mayRest(Bodies bodies, int a, int b) {
        int count = Math.max(impacts[a]++, b >= 0 ? impacts[b]++ : 0);
        double restitution = b < 0 ? restitutionRule.atWall(bodies, a, walls[~b])
            : restitutionRule.betweenBodies(bodies, a, b);
        return restitution < 1 && (Double.isNaN(restSpeed) ? restitution == 0 || count >= PATIENCE
            : restitution * approach(bodies, a, b) <= restSpeed);
    }

    private double approach(Bodies bodies, int a, int b) {
        double x = bodies.vx[a];
        double y = bodies.vy[a];
        if (b < 0) {
            return walls[~b].normalX(bodies.x[a], bodies.y[a]) * x + walls[~b].normalY(bodies.x[a], bodies.y[a]) * y;
        }
        double dx = bodies.x[b] - bodies.x[a];
        double dy = bodies.y[b] - bodies.y[a];
        double distance = Math.sqrt(dx * dx + dy * dy);
        return distance == 0 ? 0 : (dx * (x - bodies.vx[b]) + dy * (y - bodies.vy[b])) / distance;
    }

    /**
     * Lets the heap of an impact rest; all bodies are where they are now.
     *
     * @return how many impacts that has taken; 0 if it is an ordinary impact, and nothing was altered
     */
    public int settle(Bodies bodies, int a, int b, double time, TurnSink sink) {
        gather(bodies, a, b);
        int exchanged = 0;
        if (touching > 1) {
            double left = Math.max(1 - time, LEAST_LEFT);
            solve(bodies, a, b, left);
            exchanged = impulses.exchange(bodies, time, sink);
            squeezed = exchanged == 0;
        }
        for (int k = 0; k < heapSize; k++) {
            place[heap[k]] = -1;
            rested[heap[k]] |= touching > 1;
        }
        return touching > 1 ? Math.max(1, exchanged) : 0;
    }

    /** Solves the contacts that the heap would meet in the rest of the turn, until it meets none. */
    private void solve(Bodies bodies, int a, int b, double left) {
        impulses.begin(bodies, heap, heapSize);
        addContact(bodies, b < 0 ? a : Math.min(a, b), b < 0 ? b : Math.max(a, b), left);
        int before;
        do {
            before = system.size;
            impulses.solve(bodies);
            addMet(bodies, left);
        } while (system.size > before);
    }

    private void addMet(Bodies bodies, double left) {
        for (int k = 0; k < heapSize && system.size < InelasticSystem.MOST; k++) {
            int i = heap[k];
            for (int j = 0; j < size; j++) {
                if ((place[j] >= 0 && place[j] < k || bodies.inverseMass[j] == 0) && meet(bodies, i, j)
                    && reaches(bodies, i, j, left)) {
                    addOnce(bodies, Math.min(i, j), Math.max(i, j), left);
                }
            }
            for (int w = 0; w < walls.length; w++) {
                if (contacts.withWall(bodies.kind[i]) != Contacts.Meaning.BOUNCE) {
                    continue;
                }
                if (walls[w] instanceof Arena arena) {
                    addRim(bodies, i, w, arena, left);
                } else if (reachesWall(bodies, i, walls[w], left)) {
                    addOnce(bodies, i, ~w, left);
                }
            }
        }
    }

    private void addOnce(Bodies bodies, int i, int j, double left) {
        if (!system.has(i, j)) {
            addContact(bodies, i, j, left);
        }
    }

    /** True if two bodies would meet in a time, on straight paths. */
    private boolean reaches(Bodies bodies, int i, int j, double left) {
        double dx = bodies.x[j] - bodies.x[i];
        double dy = bodies.y[j] - bodies.y[i];
        double ux = system.vx[j] - system.vx[i];
        double uy = system.vy[j] - system.vy[i];
        double closing = -(dx * ux + dy * uy);
        double reach = bodies.radius[i] + bodies.radius[j];
        double distance = Math.sqrt(dx * dx + dy * dy);
        double gap = distance - reach;
        if (!(closing > impulses.tolerance() * distance) || closing * left <= gap * distance) {
            return false;
        }
        double nearest = Math.min(left, closing / (ux * ux + uy * uy));
        double x = dx + ux * nearest;
        double y = dy + uy * nearest;
        return gap <= 0 || x * x + y * y < reach * reach;
    }

    private boolean reachesWall(Bodies bodies, int i, Wall wall, double left) {
        double x = bodies.x[i];
        double y = bodies.y[i];
        double closing = wall.normalX(x, y) * system.vx[i] + wall.normalY(x, y) * system.vy[i];
        double gap = wall.gap(x, y, bodies.radius[i]);
        return closing > impulses.tolerance() && closing * left > gap
            && (gap <= 0 || wall.gap(x + system.vx[i] * left, y + system.vy[i] * left, bodies.radius[i]) < 0);
    }

    private void addContact(Bodies bodies, int a, int b, double left) {
        double x = bodies.x[a];
        double y = bodies.y[a];
        if (b < 0) {
            add(bodies, a, b, walls[~b].normalX(x, y), walls[~b].normalY(x, y),
                walls[~b].gap(x, y, bodies.radius[a]), left);
            return;
        }
        double dx = bodies.x[b] - x;
        double dy = bodies.y[b] - y;
        double distance = Math.sqrt(dx * dx + dy * dy);
        add(bodies, a, b, distance == 0 ? 1 : dx / distance, distance == 0 ? 0 : dy / distance,
            distance - bodies.radius[a] - bodies.radius[b], left);
    }

    /** Adds the tangent of the rim that a body would leave, where it would be at the end of the turn. */
    private void addRim(Bodies bodies, int i, int w, Arena arena, double left) {
        double x = bodies.x[i] - arena.x();
        double y = bodies.y[i] - arena.y();
        double endX = x + system.vx[i] * left;
        double endY = y + system.vy[i] * left;
        double distance = Math.sqrt(endX * endX + endY * endY);
        double room = arena.radius() - bodies.radius[i];
        if (room > 0 && distance > room * (1 + RIM)) {
            double nx = endX / distance;
            double ny = endY / distance;
            add(bodies, i, ~w, nx, ny, room - (nx * x + ny * y), left);
        }
    }

    private void add(Bodies bodies, int a, int b, double nx, double ny, double gap, double left) {
        double radii = bodies.radius[a] + (b < 0 ? 0 : bodies.radius[b]);
        if (system.size < InelasticSystem.MOST) {
            system.add(bodies, a, b, nx, ny, gap > CLOSED * radii ? USED * gap / left : 0);
        }
    }

    /** True if the last heap had nothing to exchange although it approaches: there is no room, and no way out. */
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
            for (int j = 0; j < size; j++) {
                if (j != i && !isPair(i, j, a, b) && meet(bodies, i, j) && gap(bodies, i, j)
                    <= gapShare * (bodies.radius[i] + bodies.radius[j]) + rounding(bodies, i) + rounding(bodies, j)) {
                    touching++;
                    enter(bodies, j);
                }
            }
            for (int w = 0; w < walls.length; w++) {
                if (!(i == a && b == ~w) && contacts.withWall(bodies.kind[i]) == Contacts.Meaning.BOUNCE
                    && walls[w].gap(bodies.x[i], bodies.y[i], bodies.radius[i])
                    <= gapShare * bodies.radius[i] + rounding(bodies, i)) {
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

    private static boolean isPair(int i, int j, int a, int b) {
        return i == a && j == b || i == b && j == a;
    }

    private boolean meet(Bodies bodies, int i, int j) {
        return contacts.between(bodies.kind[i], bodies.kind[j]) == Contacts.Meaning.BOUNCE;
    }

    private static double gap(Bodies bodies, int i, int j) {
        double dx = bodies.x[i] - bodies.x[j];
        double dy = bodies.y[i] - bodies.y[j];
        return Math.sqrt(dx * dx + dy * dy) - bodies.radius[i] - bodies.radius[j];
    }

    private static double rounding(Bodies bodies, int i) {
        return 0x1p-46 * (Math.abs(bodies.x[i]) + Math.abs(bodies.y[i]));
    }
}

package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * Rest: the end of bounces that would never end. Where restitution is below 1, bodies that press against something
 * immovable bounce infinitely often in a finite time. So an impact that rebounds at no more than the rest speed of its
 * heap ends the approach and no more, together with all closed contacts that hang on it, as one system
 * ({@link InelasticSystem}), recorded as one impact for each contact that exchanges an impulse, ascending by ids, at
 * one time.
 *
 * <p>A heap is what hangs on an impact by gaps of at most 1/{@value #NEAR} of the sum of the radii: two contacts or
 * more. These gaps are four times as wide each time it has come to rest in this turn, up to 1/{@value #WIDEST}; those
 * that count as closed, at first 2^-16, grow 16-fold. A contact with such a gap may keep the approach that uses up half
 * of it until the end of the turn; so the last gaps of a heap are closed over several turns, and not one by one within
 * a turn. Its rest speed is the highest speed that one of its bodies had at the start of the turn, times the number of
 * its bodies, times 2^(c - {@value #PATIENCE}), and at most that highest speed; c is the number of earlier impacts in
 * this turn of that body of the two that had more. So a first bounce is a bounce, and the larger the heap and the more
 * often it has bounced, the more is rest. In a heap that nothing immovable has stopped in this turn, directly or
 * through others, it is 2^(c - {@value #FREE_PATIENCE}): a collapse in free space ends by rounding. Without restitution
 * every impact in a heap is rest. Nothing depends on bodies elsewhere. A law may set the speed itself
 * ({@link ImpactLaw#restSpeed}).
 *
 * <p>Afterwards the contacts part as {@link RestImpulses} says: no contact of a heap at rest is met again. If something
 * approaches even so, the turn has its named ending.
 */
public final class Rest {

    /** Gaps up to 1 / NEAR of the sum of the radii belong to a heap. */
    public static final int NEAR = 2048;
    /** After this many impacts of a body in a turn its heap rests, however fast it is; large heaps earlier. */
    static final int PATIENCE = 5;
    /** The same for a heap that nothing immovable holds. */
    static final int FREE_PATIENCE = 40;
    /** Gaps of a heap are never wider than 1 / WIDEST of the sum of the radii. */
    public static final int WIDEST = 32;
    /** Gaps up to this share of the radii are closed: what slow bodies close again within a small part of a turn. */
    private static final double CLOSED = 0x1p-16;
    /** Each time a heap comes to rest in a turn, its gaps grow by 2^WIDENING. */
    private static final int WIDENING = 2;
    /** The same for the gaps that count as closed. */
    private static final int WIDENING_OF_CLOSED = 4;
    /** The share of its gap that a closed contact may use up in the rest of the turn. */
    private static final double USED = 0.5;
    /** The shortest rest of a turn that is divided by. */
    private static final double LEAST_LEFT = 0x1p-20;
    /** More than enough for the widest gaps. */
    private static final int LARGE = 16;

    private final Wall[] walls;
    private final Contacts contacts;
    private final RestitutionRule restitutionRule;
    /** Of the law; NaN for the default. */
    private final double restSpeed;
    private final InelasticSystem system = new InelasticSystem();
    private final RestImpulses impulses;
    /** How often the heap of a body has come to rest in this turn. */
    private int[] settled = new int[0];
    private int[] impacts = new int[0];
    private double[] speedAtStart = new double[0];
    private double highest;
    private int[] heap = new int[0];
    private boolean[] inHeap = new boolean[0];
    /** Whether something immovable has stopped a body in this turn, directly or through others. */
    private boolean[] wasHeld = new boolean[0];
    private int heapSize;
    private int touching;
    private boolean anchored;
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
        ImpactLaw law = parts.law();
        boolean ends = law.restitution() == ImpactLaw.Restitution.ELASTIC || law.minimumImpulse() > 0
            || law.separatingPairsReact() || walls.length == 0 && !parts.infiniteMasses();
        return ends ? null : new Rest(parts, walls);
    }

    /** Begins a turn with these bodies. */
    public void begin(Bodies bodies) {
        size = bodies.size();
        if (impacts.length < size) {
            int capacity = bodies.capacity();
            impacts = new int[capacity];
            settled = new int[capacity];
            speedAtStart = new double[capacity];
            heap = new int[capacity];
            inHeap = new boolean[capacity];
            wasHeld = new boolean[capacity];
        }
        highest = 0;
        squeezed = false;
        for (int i = 0; i < size; i++) {
            impacts[i] = 0;
            settled[i] = 0;
            wasHeld[i] = false;
            speedAtStart[i] = bodies.inverseMass[i] > 0
                ? Math.sqrt(bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]) : 0;
            highest = Math.max(highest, speedAtStart[i]);
        }
    }

    /** After a reaction of the scene: begins anew if bodies were removed or added. */
    public void follow(Bodies bodies) {
        if (bodies.size() != size) {
            begin(bodies);
        }
    }

    /** Whether a contact is a plain impact, no slide, and nothing passes through anything else. */
    public boolean isAbout(Bodies bodies, int a, int b) {
        return !(b < 0 && RimSliding.grazes(bodies, a, walls[~b])) && bodies.passing().isEmpty()
            && Contacts.Meaning.BOUNCE == (b < 0 ? contacts.withWall(bodies.kind[a])
            : contacts.between(bodies.kind[a], bodies.kind[b]));
    }

    /**
     * Counts an impact of two that are where they are now, and says whether it may be rest: a quick look.
     *
     * @param b another body, or {@code ~wall}
     */
    public boolean mayRest(Bodies bodies, int a, int b) {
        boolean held = b < 0 || isHeld(bodies, a) || isHeld(bodies, b);
        wasHeld[a] |= held;
        if (b >= 0) {
            wasHeld[b] |= held;
        }
        int count = Math.max(impacts[a]++, b >= 0 ? impacts[b]++ : 0);
        return count > 0 && reboundSpeed(bodies, a, b) <= (Double.isNaN(restSpeed) ? highest : restSpeed);
    }

    private boolean isHeld(Bodies bodies, int i) {
        return wasHeld[i] || bodies.inverseMass[i] == 0;
    }

    /** The rest speed of a heap as a share of the highest speed in it. */
    private static double share(int bodies, int count, int patience) {
        return Math.min(1, Math.scalb((double) bodies, count - patience));
    }

    private double reboundSpeed(Bodies bodies, int a, int b) {
        double restitution = b < 0 ? restitutionRule.atWall(bodies, a, walls[~b])
            : restitutionRule.betweenBodies(bodies, a, b);
        if (restitution == 0) {
            return 0;
        }
        if (restitution == 1) {
            return Double.POSITIVE_INFINITY;
        }
        system.size = 0;
        addContact(bodies, a, b);
        return restitution * system.approach(bodies, 0);
    }

    /**
     * Lets the heap of an impact rest; all bodies are where they are now.
     *
     * @return false if it is an ordinary impact, and nothing was altered
     */
    public boolean settle(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double rebound = reboundSpeed(bodies, a, b);
        double near = near(a, b);
        gather(bodies, a, b, near, false);
        double speed = 0;
        int before = 0;
        for (int k = 0; k < heapSize; k++) {
            speed = Math.max(speed, speedAtStart[heap[k]]);
            before = Math.max(before, settled[heap[k]]);
        }
        int count = Math.max(impacts[a], b >= 0 ? impacts[b] : 0) - 1;
        double limit = Double.isNaN(restSpeed)
            ? speed * share(heapSize, count, anchored ? PATIENCE : FREE_PATIENCE) : anchored ? restSpeed : 0;
        if (touching == 1 || rebound > limit) {
            return false;
        }
        gather(bodies, a, b, Math.min(near, Math.scalb(CLOSED, WIDENING_OF_CLOSED * Math.min(LARGE, before))), true);
        for (int k = 0; k < heapSize; k++) {
            settled[heap[k]]++;
        }
        for (int k = 0; k < system.size; k++) {
            allow(bodies, k, 1 - time);
        }
        squeezed = !impulses.exchange(bodies, time, sink);
        return true;
    }

    /**
     * The gaps, as a share of the sum of the radii, of the heap of an impact: wider, the more often it has come to rest
     * in this turn.
     */
    public double near(int a, int b) {
        return Math.min(1.0 / WIDEST, Math.scalb(1.0 / NEAR, WIDENING * settledBefore(a, b)));
    }

    private int settledBefore(int a, int b) {
        return Math.min(LARGE, Math.max(settled[a], b >= 0 ? settled[b] : 0));
    }

    /** Lets a contact with a gap keep the approach that uses up a part of the gap in the rest of the turn. */
    private void allow(Bodies bodies, int k, double left) {
        int a = system.a[k];
        int b = system.b[k];
        double gap = b < 0 ? walls[~b].gap(bodies.x[a], bodies.y[a], bodies.radius[a]) : gap(bodies, a, b);
        double size = bodies.radius[a] + (b < 0 ? 0 : bodies.radius[b]);
        system.allowed[k] = gap > CLOSED * size ? USED * gap / Math.max(left, LEAST_LEFT) : 0;
    }

    /** Whether the last heap had nothing to exchange although it approaches: there is no room, and no way out. */
    public boolean isSqueezed() {
        return squeezed;
    }

    private void addContact(Bodies bodies, int a, int b) {
        double x = bodies.x[a];
        double y = bodies.y[a];
        if (b < 0) {
            system.add(a, b, walls[~b].normalX(x, y), walls[~b].normalY(x, y));
            return;
        }
        double dx = bodies.x[b] - x;
        double dy = bodies.y[b] - y;
        double distance = Math.sqrt(dx * dx + dy * dy);
        system.add(a, b, distance == 0 ? 1 : dx / distance, distance == 0 ? 0 : dy / distance);
    }

    /** Collects what hangs on an impact by small gaps, body by body, into the heap, and its contacts if asked. */
    private void gather(Bodies bodies, int a, int b, double gapShare, boolean collects) {
        heapSize = 0;
        touching = 1;
        anchored = wasHeld[a];
        system.size = 0;
        if (collects) {
            addContact(bodies, Math.min(a, b < 0 ? a : b), b < 0 ? b : Math.max(a, b));
        }
        enter(bodies, a);
        if (b >= 0) {
            enter(bodies, b);
        }
        for (int k = 0; k < heapSize; k++) {
            int i = heap[k];
            for (int j = 0; j < size; j++) {
                boolean counted = inHeap[j] && isBefore(j, k);
                if (j != i && !counted && !isPair(i, j, a, b) && meet(bodies, i, j)
                    && gap(bodies, i, j) <= tolerance(bodies, i, j, gapShare)) {
                    found(bodies, Math.min(i, j), Math.max(i, j), collects);
                    anchored |= isHeld(bodies, j);
                    enter(bodies, j);
                }
            }
            for (int w = 0; w < walls.length; w++) {
                if (!(i == a && b == ~w) && contacts.withWall(bodies.kind[i]) == Contacts.Meaning.BOUNCE
                    && walls[w].gap(bodies.x[i], bodies.y[i], bodies.radius[i])
                    <= gapShare * bodies.radius[i] + rounding(bodies, i)) {
                    found(bodies, i, ~w, collects);
                    anchored = true;
                }
            }
        }
        for (int k = 0; k < heapSize; k++) {
            inHeap[heap[k]] = false;
        }
    }

    private void found(Bodies bodies, int i, int j, boolean collects) {
        touching++;
        if (collects && system.size < InelasticSystem.MOST) {
            addContact(bodies, i, j);
        }
    }

    /** An infinite mass ends a heap: nothing goes through it. */
    private void enter(Bodies bodies, int i) {
        if (!inHeap[i] && bodies.inverseMass[i] > 0) {
            inHeap[i] = true;
            heap[heapSize++] = i;
        }
    }

    /** Whether the contacts of a body of the heap have been collected before those of the k-th one. */
    private boolean isBefore(int j, int k) {
        for (int l = 0; l < k; l++) {
            if (heap[l] == j) {
                return true;
            }
        }
        return false;
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

    private static double tolerance(Bodies bodies, int i, int j, double share) {
        return share * (bodies.radius[i] + bodies.radius[j]) + rounding(bodies, i) + rounding(bodies, j);
    }

    private static double rounding(Bodies bodies, int i) {
        return 0x1p-46 * (Math.abs(bodies.x[i]) + Math.abs(bodies.y[i]));
    }
}

package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import steward.physics.Bodies;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;

/**
 * Reference computation of a turn from the definitions in {@link Decimals#COUNT} decimal digits. It finds the earliest
 * touch of all pairs and walls, moves all bodies there, lets the impact react, and searches again. It is slow and meant
 * to be obviously right: nothing is kept from one impact to the next, and only pairs that provably touch later than the
 * next impact are not examined in all digits ({@link OracleBroadPhase}). It reads {@link ImpactLaw} and {@link Wall} as
 * plain data and calls nothing of the physics.
 *
 * <p>If the physics has to decide whether two rounded distances are equal, the oracle treats numbers that agree to
 * {@code COUNT - 16} digits as equal: a body moved to a touch does touch, and a body that slides does not approach.
 *
 * <p>Caveat: a turn stops if it reaches the limit on impacts, if a body slides along a rim where bodies rest ({@link
 * OracleRest#slides}), or if a heap has no way to rest. {@link OracleContacts} tells which contacts are supported.
 */
public final class Oracle {

    /** A touch that is this much later than the window has no part in what reacts next: many times the rounding. */
    private static final BigDecimal CLEARLY_LATER = Decimals.SAME.movePointRight(16);

    private final ImpactLaw law;
    private final List<Wall> walls;
    private final OracleReaction reaction;
    private final Forces forces;
    /** {@code null} where everything bounces. */
    private final OracleContacts contacts;
    private boolean limited;
    private boolean examineAll;
    /** True if the last impact slides or is rest, and is not computed here. */
    private boolean resting;

    /** Everything bounces. */
    public Oracle(ImpactLaw law, List<Wall> walls) {
        this(law, walls, null, Forces.NONE);
    }

    /** With the law, walls and contacts of a scene, for turns that begin with these bodies. */
    public static Oracle of(PhysicsParts parts, Bodies start) {
        return new Oracle(parts.law(), parts.walls(),
            parts.contacts().allBounce() ? null : new OracleContacts(parts, start), parts.forces());
    }

    /** @param contacts what contacts mean; for one turn, from the bodies that they were made for */
    Oracle(ImpactLaw law, List<Wall> walls, OracleContacts contacts, Forces forces) {
        this.law = law;
        this.forces = forces;
        this.contacts = contacts;
        this.walls = List.copyOf(walls);
        reaction = new OracleReaction(law, this.walls, forces, contacts);
    }

    /** A future touch; b is an index or {@code ~wall}. */
    private record Touch(BigDecimal until, int a, int b) {

        /** Order of pairs: the lower body first, then the other; walls after all bodies. */
        boolean isBefore(Touch other) {
            int low = b < 0 ? a : Math.min(a, b);
            int otherLow = other.b < 0 ? other.a : Math.min(other.a, other.b);
            if (low != otherLow || b < 0 != other.b < 0) {
                return low != otherLow ? low < otherLow : b >= 0;
            }
            return b < 0 ? ~b < ~other.b : Math.max(a, b) < Math.max(other.a, other.b);
        }
    }

    /** A pair, or a body and {@code ~wall}, that does not touch before the bound. */
    private static final class Candidate {

        final double bound;
        final int a;
        final int b;
        final double own;
        boolean examined;
        /** {@code null} until found. */
        Touch touch;

        Candidate(double bound, int a, int b, double own) {
            this.bound = bound;
            this.a = a;
            this.b = b;
            this.own = own;
        }
    }

    /** Examines every pair and wall in all digits, whatever the bounds say. */
    Oracle examiningAll() {
        examineAll = true;
        return this;
    }

    /** Stops where a heap of more than some bodies comes to rest: that takes minutes for a hundred. */
    public Oracle withHeapsUpTo(int bodies) {
        reaction.limitHeaps(bodies);
        return this;
    }

    /** True if the last turn stopped in the middle: at the limit on impacts, or as {@link #rested} says. */
    public boolean limited() {
        return limited;
    }

    /** True if the last turn stopped where a body slides along a rim, or a heap has no way to rest or is too large. */
    public boolean rested() {
        return resting && limited;
    }

    /** Plays for a duration from now, a turn being 1; changes the bodies. */
    List<OracleImpact> play(List<OracleBody> bodies, BigDecimal duration) {
        List<OracleImpact> impacts = new ArrayList<>();
        BigDecimal now = BigDecimal.ZERO;
        int bound = law.maximumImpacts() > 0 ? law.maximumImpacts() : 10_000 + 1_000 * bodies.size();
        int left = bound;
        limited = false;
        bodies.forEach(this::begin);
        resting = false;
        for (;;) {
            List<Touch> next = together(touches(bodies, duration.subtract(now)));
            if (next.isEmpty()) {
                fly(bodies, duration.subtract(now));
                return impacts;
            }
            if (left-- <= 0 || resting) {
                limited = true;
                return impacts;
            }
            BigDecimal earliest = next.get(0).until;
            fly(bodies, earliest);
            if (contacts != null) {
                contacts.releaseSeparatedPairs(bodies, walls);
            }
            int size = bodies.size();
            int before = impacts.size();
            for (int k = 0; k < next.size() && bodies.size() == size; k++) {
                impacts.addAll(react(bodies, next.get(k), now));
            }
            left -= Math.max(next.size(), impacts.size() - before) - 1;
            now = now.add(earliest);
        }
    }

    private void begin(OracleBody body) {
        boolean moved = body.mass != null;
        BigDecimal inverse = body.inverseMass();
        body.most = BigDecimal.ZERO;
        body.rested = false;
        body.ax = moved ? Decimals.of(forces.forceX()).multiply(inverse).add(Decimals.of(forces.gravityX()))
            : BigDecimal.ZERO;
        body.ay = moved ? Decimals.of(forces.forceY()).multiply(inverse).add(Decimals.of(forces.gravityY()))
            : BigDecimal.ZERO;
    }

    /** Impacts, told with the indices of the start; none if the game's reaction does something else. */
    private List<OracleImpact> react(List<OracleBody> bodies, Touch touch, BigDecimal now) {
        BigDecimal time = now.add(touch.until);
        if (contacts != null && !contacts.bounces(bodies, touch.a, touch.b, time)) {
            return List.of();
        }
        List<OracleImpact> impacts = reaction.react(bodies, touch.a, touch.b, time);
        resting |= reaction.stopped();
        if (contacts == null) {
            return impacts;
        }
        contacts.after(bodies, touch.a, touch.b, time);
        return impacts.stream().map(impact -> impact.between(contacts.startIndex(touch.a),
            touch.b < 0 ? touch.b : contacts.startIndex(touch.b))).toList();
    }

    public List<OracleImpact> turn(List<OracleBody> bodies) {
        return play(bodies, BigDecimal.ONE);
    }

    private static void fly(List<OracleBody> bodies, BigDecimal time) {
        bodies.forEach(body -> body.fly(time));
    }

    /** Touches within a time, in scan order: all that {@link #together} can choose, and perhaps others. */
    private List<Touch> touches(List<OracleBody> bodies, BigDecimal left) {
        List<Candidate> candidates = candidates(bodies, left.doubleValue());
        BigDecimal window = Decimals.of(law.batchWindow()).add(CLEARLY_LATER);
        double last = Double.POSITIVE_INFINITY;
        for (Candidate next; (next = earliest(candidates, last)) != null; ) {
            BigDecimal until = next.b < 0 ? OracleTimeOfImpact.wall(bodies.get(next.a), walls.get(~next.b))
                : pair(bodies.get(next.a), bodies.get(next.b), next.own);
            next.examined = true;
            if (until != null && until.compareTo(left) <= 0) {
                next.touch = new Touch(until, next.a, next.b);
                last = examineAll ? last : Math.min(last, Math.nextUp(until.add(window).doubleValue()));
            }
        }
        return candidates.stream().map(candidate -> candidate.touch).filter(Objects::nonNull).toList();
    }

    /** Candidate not yet examined with the lowest bound up to a time; {@code null} if there is none. */
    private static Candidate earliest(List<Candidate> candidates, double last) {
        Candidate best = null;
        for (Candidate candidate : candidates) {
            if (!candidate.examined && candidate.bound <= (best == null ? last : best.bound)) {
                best = candidate;
            }
        }
        return best;
    }

    /** In scan order: pairs, then walls. */
    private List<Candidate> candidates(List<OracleBody> bodies, double time) {
        List<Candidate> candidates = new ArrayList<>();
        int size = bodies.size();
        boolean descending = law.scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        OracleBroadPhase reach = new OracleBroadPhase(bodies);
        for (int k = 0; k < size; k++) {
            int i = descending ? size - 1 - k : k;
            for (int m = 0; m < (descending ? i : size - 1 - i); m++) {
                int j = descending ? i - 1 - m : i + 1 + m;
                if (contacts == null || contacts.meet(i, j)) {
                    double own = contacts == null ? Double.NaN : contacts.reach(i, j);
                    add(candidates, reach.earliest(i, j, own, law.separatingPairsReact()), time, i, j, own);
                }
            }
        }
        for (int i = 0; i < size; i++) {
            for (int w = 0; w < walls.size() && bodies.get(i).mass != null; w++) {
                if (contacts == null || contacts.meetsWall(i, w)) {
                    add(candidates, reach.earliest(i, walls.get(w)), time, i, ~w, Double.NaN);
                }
            }
        }
        return candidates;
    }

    private void add(List<Candidate> candidates, double bound, double time, int a, int b, double own) {
        if (examineAll || bound <= time) {
            candidates.add(new Candidate(bound, a, b, own));
        }
    }

    /** @param own distance at which they touch; NaN for the sum of their radii */
    private BigDecimal pair(OracleBody p, OracleBody q, double own) {
        if (p.mass == null && q.mass == null) {
            return null;
        }
        BigDecimal dx = p.x.subtract(q.x);
        BigDecimal dy = p.y.subtract(q.y);
        BigDecimal touch = Double.isNaN(own) ? p.radius.add(q.radius) : Decimals.of(own);
        if (law.separatingPairsReact() && OracleTimeOfImpact.within(dx, dy, touch)) {
            return BigDecimal.ZERO;
        }
        return OracleTimeOfImpact.circle(dx, dy, p.vx.subtract(q.vx), p.vy.subtract(q.vy), touch);
    }

    /**
     * The impacts that react next: the earliest alone, ties to the lowest pair; or all within the batch window, in
     * order.
     */
    private List<Touch> together(List<Touch> touches) {
        List<Touch> sorted = new ArrayList<>();
        for (Touch touch : touches) {
            int place = sorted.size();
            while (place > 0 && isLater(sorted.get(place - 1), touch)) {
                place--;
            }
            sorted.add(place, touch);
        }
        if (sorted.isEmpty() || law.batchWindow() > 0) {
            BigDecimal window = Decimals.of(law.batchWindow()).add(Decimals.SAME);
            return sorted.stream()
                .filter(touch -> touch.until.subtract(sorted.get(0).until).compareTo(window) <= 0).toList();
        }
        Touch lowest = sorted.get(0);
        for (Touch touch : sorted) {
            lowest = !isLater(touch, sorted.get(0)) && touch.isBefore(lowest) ? touch : lowest;
        }
        return List.of(lowest);
    }

    /** True if one touch is later than another by more than rounding, a turn being 1. */
    private static boolean isLater(Touch one, Touch other) {
        return one.until.subtract(other.until).compareTo(Decimals.SAME) > 0;
    }
}

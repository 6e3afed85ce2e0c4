package steward.physics.event.flight;

import steward.numerics.DoubleDouble;
import steward.physics.HalfPlane;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.time.CircleTime;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.SimultaneousImpacts;
import steward.physics.time.TimeOfImpact;

/**
 * Search for the earliest impact of a body: each offered impact is compared with the best so far. Impacts are offered
 * by a way to find neighbours. A time of impact is computed from the positions at the later start of the two flights,
 * so that it is the same whenever and from whichever of the two it is searched for. Ties go to the lowest pair, bodies
 * before walls.
 *
 * <p>In the arithmetic {@code EXACT} decisions are exact and times are double-doubles. If two of these are so near that
 * they may be the same time, {@link SimultaneousImpacts} decides.
 */
public abstract class ImpactSearch {

    protected static final double NEVER = Double.POSITIVE_INFINITY;
    /** Sums of a few terms, and places after a flight, are off by less than this share of their terms. */
    protected static final double ROUNDING = 0x1p-46;
    /** A factor for the rounding error of a quotient. */
    private static final double JUST_BELOW_ONE = 1 - 0x1p-40;

    protected final Wall[] walls;
    /** The straight walls; {@code null} for others. */
    private final HalfPlane[] planes;
    /** {@code null} if all can react. */
    protected final PairSelection selection;
    /** {@code null} where times are doubles. */
    protected final ExactPairs exactPairs;
    private final ExactWalls exactWalls;
    private final CircleTime circles;
    /** The time of the impact in work, from the start of its flights and as a time of the turn. */
    private final DoubleDouble until = new DoubleDouble();
    private final DoubleDouble at = new DoubleDouble();
    /** {@code null} where times are doubles. */
    protected final SimultaneousImpacts together;
    /** True while the impacts near a time are collected in place of the earliest. */
    protected boolean collects;
    /** The earliest impact so far of the body in work: its time, its low part, and the partner or {@code ~wall}. */
    protected double best;
    protected double bestLow;
    protected int bestPartner;
    /** True if another impact of the body is near its best in time. */
    protected boolean bestDoubtful;

    protected ImpactSearch(PhysicsParts parts) {
        boolean exact = parts.arithmetic().isExact();
        walls = parts.walls().toArray(new Wall[0]);
        planes = parts.walls().stream().map(wall -> wall instanceof HalfPlane plane ? plane : null)
            .toArray(HalfPlane[]::new);
        selection = PairSelection.of(parts);
        exactPairs = exact ? new ExactPairs(parts.law()) : null;
        exactWalls = exact ? new ExactWalls(walls) : null;
        circles = CircleTime.of(parts.arithmetic());
        together = exact ? new SimultaneousImpacts(walls, exactPairs, exactWalls) : null;
    }

    /** The rank of an impact among those at one time. */
    protected abstract long rank(int body, int partner);

    /** Begins a search from nothing. */
    protected final void clear() {
        best = NEVER;
        bestLow = 0;
        bestDoubtful = false;
    }

    /**
     * Keeps the impact of two circles, given where both are at the start of the later flight, if it is the earliest.
     *
     * @param latest it is not kept if it is later
     */
    protected final void offerPair(int body, int other, double xi, double xj, double yi, double yj, double vxi,
                                   double vxj, double vyi, double vyj, double ri, double rj, double start,
                                   double latest, double now) {
        double time = circles.untilInTurn(xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, start);
        if (time < NEVER) {
            time = Math.max(now, start + time);
            if (time <= best && time <= latest && (time < best || isLower(body, other))) {
                best = time;
                bestPartner = other;
            }
        }
    }

    /** As {@link #offerPair}, where times are double-doubles. */
    protected final void offerExactPair(int body, int other, double xi, double xj, double yi, double yj, double vxi,
                                        double vxj, double vyi, double vyj, double ri, double rj, double start,
                                        double startLow, double latest, double now) {
        if (exactPairs.exactTime(xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, until)) {
            boolean isPresent = addTimes(start, startLow, now);
            if (!collects) {
                keepIfEarlier(body, other, latest);
            } else if (isNear()) {
                together.addPair(body, other, rank(body, other), xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, start,
                    startLow, until, at, isPresent);
            }
        }
    }

    /** True if a wall is straight and surely reached later than the best: most are, and it takes no division. */
    protected final boolean isLate(int w, double x, double y, double vx, double vy, double radius, double start) {
        HalfPlane plane = planes[w];
        if (plane == null) {
            return false;
        }
        double speed = Math.abs(vx) + Math.abs(vy);
        double size = Math.abs(x) + Math.abs(y) + radius + speed + Math.abs(plane.x()) + Math.abs(plane.y());
        double closing = ROUNDING * speed - (vx * plane.insideX() + vy * plane.insideY());
        double gap = plane.gap(x, y, radius) - ROUNDING * size;
        return gap * JUST_BELOW_ONE > closing * (Math.min(best, 1) - start);
    }

    /** Keeps the impact of a circle and a wall, given where it is at the start of its flight, if it is the earliest. */
    protected final void offerWall(int w, double x, double y, double vx, double vy, double radius, double start,
                                   double now) {
        double time = TimeOfImpact.wall(walls[w], x, y, vx, vy, radius);
        if (time <= 1 - start && Math.max(now, start + time) < best) {
            best = Math.max(now, start + time);
            bestPartner = ~w;
        }
    }

    /** As {@link #offerWall}, where times are double-doubles. */
    protected final void offerExactWall(int body, int w, double x, double y, double vx, double vy, double radius,
                                        double start, double startLow, double now) {
        if (start + exactWalls.until(w, x, y, vx, vy, radius) <= Math.min(best, 1)
            && exactWalls.exactTime(w, x, y, vx, vy, radius, until)) {
            boolean isPresent = addTimes(start, startLow, now);
            if (!collects) {
                keepIfEarlier(body, ~w, NEVER);
            } else if (isNear()) {
                together.addWall(body, w, rank(body, ~w), x, y, vx, vy, radius, start, startLow, until, at, isPresent);
            }
        }
    }

    /** Computes the time of the turn; one before the present is so only by rounding. @return whether it was */
    private boolean addTimes(double start, double startLow, double now) {
        at.setSum(start, startLow).add(until);
        if (at.high() < now) {
            at.set(now);
            return true;
        }
        return false;
    }

    private boolean isNear() {
        return at.high() <= best && isWithinTurn();
    }

    private boolean isWithinTurn() {
        return at.high() < 1 || at.high() == 1 && at.low() <= 0;
    }

    private void keepIfEarlier(int body, int partner, double latest) {
        double high = at.high();
        double low = at.low();
        double later = high - best;
        if (!isWithinTurn() || later > SimultaneousImpacts.NEAR || high - latest > SimultaneousImpacts.NEAR) {
            return;
        }
        bestDoubtful = later >= -SimultaneousImpacts.NEAR;
        if (high < best
            || high == best && (low < bestLow || low == bestLow && partner >= 0 && isLower(body, partner))) {
            best = high;
            bestLow = low;
            bestPartner = partner;
        }
    }

    /** For equal times: whether a pair comes before the best so far. */
    private boolean isLower(int body, int other) {
        return bestPartner < 0 || rank(body, other) < rank(body, bestPartner);
    }
}

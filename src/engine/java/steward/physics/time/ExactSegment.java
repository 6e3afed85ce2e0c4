package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.numerics.Expansion;
import steward.physics.Segment;

/*
 * With B the vector of the segment, L its length, P from its end a to the centre and V the velocity: C = B x P is L
 * times the distance to the line, B.P is L times the position of the perpendicular's foot along it. The side is touched
 * when |C| = r L, at
 *
 *     t = (|C| - r L) / w = (C^2 - r^2 L^2) / ((|C| + r L) w)    with w = -(B x V) sign C, L times the closing speed.
 *
 * All signs (of C, w, B.P, B.P - L^2, C^2 - r^2 L^2) are those of expansions; the ends are circles of radius 0.
 */

/**
 * Time of impact with a {@link Segment} in exact arithmetic, decided in the same order as {@link TimeOfImpact#segment}.
 */
final class ExactSegment extends ExactWall {

    private final Segment segment;
    private final DoubleDouble bx = new DoubleDouble();
    private final DoubleDouble by = new DoubleDouble();
    private final DoubleDouble lengthSquared = new DoubleDouble();
    private final DoubleDouble length = new DoubleDouble();
    private final DoubleDouble px = new DoubleDouble();
    private final DoubleDouble py = new DoubleDouble();
    private final DoubleDouble vx = new DoubleDouble();
    private final DoubleDouble vy = new DoubleDouble();
    private final DoubleDouble closing = new DoubleDouble();
    private final DoubleDouble work = new DoubleDouble();
    private final DoubleDouble other = new DoubleDouble();
    private final Expansion squared = new Expansion();
    private final Expansion cross = new Expansion();
    private final Expansion along = new Expansion();
    private final Expansion sum = new Expansion();
    private final ExactCircles end = new ExactCircles();

    ExactSegment(Segment segment) {
        this.segment = segment;
        bx.setDifference(segment.bx(), segment.ax());
        by.setDifference(segment.by(), segment.ay());
        squared.addProduct(bx, bx).addProduct(by, by).roundTo(lengthSquared);
        length.set(lengthSquared).squareRoot();
    }

    /** The time of a straight flight to the nearest point of the segment. */
    @Override
    double lowerBound(double x, double y, double dx, double dy, double radius) {
        double size = Math.abs(x) + Math.abs(y) + Math.abs(segment.ax()) + Math.abs(segment.ay())
            + Math.abs(segment.bx()) + Math.abs(segment.by()) + radius;
        double gap = segment.gap(x, y, radius) - 64 * U * size;
        double speed = Math.sqrt(dx * dx + dy * dy);
        return gap > 0 ? roundedDown(gap / speed * (1 - 8 * U)) : exactBound(x, y, dx, dy, radius);
    }

    @Override
    boolean time(double x, double y, double dx, double dy, double radius, DoubleDouble until) {
        if (!approaches(x, y, dx, dy, radius)) {
            return false;
        }
        if (closing.high() > 0 && atSide(radius, until)) {
            return true;
        }
        return atEnds(x, y, dx, dy, radius, until);
    }

    @Override
    boolean approaches(double x, double y, double dx, double dy, double radius) {
        px.setDifference(x, segment.ax());
        py.setDifference(y, segment.ay());
        vx.set(dx);
        vy.set(dy);
        cross.clear().addProduct(bx, py).subtractProduct(by, px);
        sum.clear().addProduct(bx, vy).subtractProduct(by, vx).roundTo(closing);
        if (cross.sign() >= 0) {
            closing.negate();
        }
        along.clear().addProduct(bx, px).addProduct(by, py);
        return approachesNearest(x, y);
    }

    /** True if the distance to the nearest point decreases. */
    private boolean approachesNearest(double x, double y) {
        if (along.sign() < 0) {
            return sum.clear().addProduct(px, vx).addProduct(py, vy).sign() < 0;
        }
        sum.clear().addProduct(bx, px).addProduct(by, py).subtractProduct(bx, bx).subtractProduct(by, by);
        if (sum.sign() <= 0) {
            return closing.high() > 0;
        }
        work.setDifference(x, segment.bx());
        other.setDifference(y, segment.by());
        return sum.clear().addProduct(work, vx).addProduct(other, vy).sign() < 0;
    }

    /** The time at which the line is touched, if that is between the ends. */
    private boolean atSide(double radius, DoubleDouble until) {
        work.setProduct(radius, radius);
        along.clear().add(-work.low()).add(-work.high());
        sum.clear().addProduct(cross, cross).addProduct(along, squared);
        if (sum.sign() <= 0) {
            until.set(0);
        } else {
            cross.roundTo(work);
            if (work.high() < 0) {
                work.negate();
            }
            work.add(other.set(length).multiply(radius)).multiply(closing);
            sum.roundTo(until).divide(work);
        }
        work.set(bx).multiply(vx).add(other.set(by).multiply(vy)).multiply(until);
        along.clear().addProduct(bx, px).addProduct(by, py).roundTo(other);
        work.add(other);
        return work.high() >= 0 && work.compareTo(lengthSquared) <= 0;
    }

    private boolean atEnds(double x, double y, double dx, double dy, double radius, DoubleDouble until) {
        boolean a = end.load(x, segment.ax(), y, segment.ay(), dx, 0, dy, 0, radius, 0).firstTouch(work);
        boolean b = end.load(x, segment.bx(), y, segment.by(), dx, 0, dy, 0, radius, 0).firstTouch(other);
        until.set(!b || a && work.compareTo(other) <= 0 ? work : other);
        return a || b;
    }

    /**
     * Towards the foot of the perpendicular if that lies between the ends, otherwise towards the nearer end; for a
     * centre on the line itself, to its right.
     */
    @Override
    void normal(DoubleDouble x, DoubleDouble y, DoubleDouble normalX, DoubleDouble normalY) {
        px.set(x).add(-segment.ax());
        py.set(y).add(-segment.ay());
        work.set(bx).multiply(px).add(other.set(by).multiply(py));
        if (work.high() <= 0 || work.compareTo(lengthSquared) >= 0) {
            boolean first = work.high() <= 0;
            normalX.set(first ? px : other.set(x).add(-segment.bx())).negate();
            normalY.set(first ? py : other.set(y).add(-segment.by())).negate();
        } else {
            work.set(bx).multiply(py).subtract(other.set(by).multiply(px));
            normalX.set(by);
            normalY.set(bx).negate();
            if (work.high() < 0) {
                normalX.negate();
                normalY.negate();
            }
        }
        normalize(normalX, normalY, other, inverse);
    }
}

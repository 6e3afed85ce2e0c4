package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.numerics.Expansion;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/**
 * A wall for the arithmetic {@code EXACT}: exact signs decide whether a body approaches, touches and hits; times are in
 * double-double. The stored numbers of the wall are taken as exact: distances from a half-plane are measured with its
 * stored vector, whose length is 1 except for rounding (for the direction of an impulse it is normalised again). At the
 * place where the flat side of a segment meets its round end, both give the same time and normal to the last bits;
 * which of the two is hit there is decided in double-double.
 *
 * <p>Lengths and speeds have to be from 1e-60 to 1e60 (or 0) for half-planes and segments; arenas take any.
 */
abstract sealed class ExactWall permits ExactWall.ExactHalfPlane, ExactWall.ExactArena, ExactSegment {

    static final double NEVER = Double.POSITIVE_INFINITY;
    static final double U = 0x1p-53;

    private final DoubleDouble time = new DoubleDouble();
    final DoubleDouble inverse = new DoubleDouble();

    static ExactWall of(Wall wall) {
        if (wall instanceof HalfPlane plane) {
            return new ExactHalfPlane(plane);
        }
        return wall instanceof Segment segment ? new ExactSegment(segment) : new ExactArena((Arena) wall);
    }

    /** A lower bound of the time of impact, at least 0; infinite only if there is none. */
    abstract double lowerBound(double x, double y, double vx, double vy, double radius);

    /** The time of impact. @return false if there is none */
    abstract boolean time(double x, double y, double vx, double vy, double radius, DoubleDouble until);

    /** True if the distance of the centre to the wall decreases. */
    abstract boolean approaches(double x, double y, double vx, double vy, double radius);

    /** The unit vector from a point to the nearest point of the wall. */
    abstract void normal(DoubleDouble x, DoubleDouble y, DoubleDouble normalX, DoubleDouble normalY);

    /** The lower bound where the filter is undecided: from the time itself. */
    double exactBound(double x, double y, double vx, double vy, double radius) {
        return time(x, y, vx, vy, radius, time) ? roundedDown(time.high()) : NEVER;
    }

    /** A time reduced by the possible rounding error of the sum of two times within a turn. */
    static double roundedDown(double until) {
        return Math.max(0, until * (1 - 4 * U) - ExactPairs.ROUNDING);
    }

    /**
     * Normalises a vector; one of length 0 becomes (1, 0).
     *
     * @param length  receives the length before
     * @param inverse a work register
     */
    static void normalize(DoubleDouble x, DoubleDouble y, DoubleDouble length, DoubleDouble inverse) {
        if (x.high() == 0 && y.high() == 0) {
            length.set(0);
            x.set(1);
            return;
        }
        double size = Math.max(Math.abs(x.high()), Math.abs(y.high()));
        int scale = size > 0x1p-300 && size < 0x1p300 ? 0 : Math.getExponent(size);
        if (scale != 0) {
            x.scale(-scale);
            y.scale(-scale);
        }
        double xx = x.high() * x.high();
        double yy = y.high() * y.high();
        double squared = xx + yy;
        length.setFastSum(squared, CircleSums.squares(x.high(), x.low(), y.high(), y.low(), xx, yy, squared))
            .squareRoot();
        inverse.set(1).divide(length);
        x.multiply(inverse);
        y.multiply(inverse);
        if (scale != 0) {
            length.scale(scale);
        }
    }

    /*
     * Both are sums of two products, g less a radius. In double-double each is off by less than 8 u^2, u = 2^-53, of
     * the magnitudes of its terms; where less than 36 bits cancel, that is below 2^-67 of the result, and its sign is
     * certain. Otherwise an expansion decides.
     */

    /** g / w with g = (p - q).n - radius, w = -v.n: the signs of both are exact. */
    static final class ExactHalfPlane extends ExactWall {

        private static final double CANCELLED = 0x1p-36;

        private final HalfPlane plane;
        private final Expansion sum = new Expansion();
        private final DoubleDouble part = new DoubleDouble();
        private final DoubleDouble closing = new DoubleDouble();
        private final DoubleDouble normalX = new DoubleDouble();
        private final DoubleDouble normalY = new DoubleDouble();

        ExactHalfPlane(HalfPlane plane) {
            this.plane = plane;
            normalX.set(-plane.insideX());
            normalY.set(-plane.insideY());
            normalize(normalX, normalY, part, inverse);
        }

        @Override
        double lowerBound(double x, double y, double vx, double vy, double radius) {
            double alongX = (x - plane.x()) * plane.insideX();
            double alongY = (y - plane.y()) * plane.insideY();
            double gap = alongX + alongY - radius;
            double gapError = 8 * U * (Math.abs(alongX) + Math.abs(alongY) + radius);
            double closingX = vx * plane.insideX();
            double closingY = vy * plane.insideY();
            double closing = -(closingX + closingY);
            double closingError = 3 * U * (Math.abs(closingX) + Math.abs(closingY));
            if (closing < -closingError) {
                return NEVER;
            }
            return gap > gapError && closing > closingError ? roundedDown((gap - gapError) / (closing + closingError))
                : exactBound(x, y, vx, vy, radius);
        }

        @Override
        boolean time(double x, double y, double vx, double vy, double radius, DoubleDouble until) {
            computeClosing(vx, vy);
            if (closing.high() <= 0) {
                return false;
            }
            computeGap(x, y, radius, until);
            if (until.high() <= 0) {
                until.set(0);
                return true;
            }
            until.divide(closing);
            return until.high() < NEVER;
        }

        @Override
        boolean approaches(double x, double y, double vx, double vy, double radius) {
            computeClosing(vx, vy);
            return closing.high() > 0;
        }

        private void computeClosing(double vx, double vy) {
            double alongX = -vx * plane.insideX();
            double alongY = -vy * plane.insideY();
            double rounded = alongX + alongY;
            if (Math.abs(rounded) > CANCELLED * (Math.abs(alongX) + Math.abs(alongY))) {
                closing.setFastSum(rounded, ErrorFree.sumError(alongX, alongY, rounded)
                    + (ErrorFree.productError(-vx, plane.insideX(), alongX)
                    + ErrorFree.productError(-vy, plane.insideY(), alongY)));
            } else {
                sum.clear().addProduct(-vx, plane.insideX()).addProduct(-vy, plane.insideY()).roundTo(closing);
            }
        }

        private void computeGap(double x, double y, double radius, DoubleDouble gap) {
            double dx = x - plane.x();
            double dy = y - plane.y();
            double dxLow = ErrorFree.sumError(x, -plane.x(), dx);
            double dyLow = ErrorFree.sumError(y, -plane.y(), dy);
            double alongX = dx * plane.insideX();
            double alongY = dy * plane.insideY();
            double along = alongX + alongY;
            double rounded = along - radius;
            if (Math.abs(rounded) > CANCELLED * (Math.abs(alongX) + Math.abs(alongY) + radius)) {
                gap.setFastSum(rounded, (ErrorFree.sumError(along, -radius, rounded)
                    + ErrorFree.sumError(alongX, alongY, along)) + ((ErrorFree.productError(dx, plane.insideX(), alongX)
                    + ErrorFree.productError(dy, plane.insideY(), alongY))
                    + (dxLow * plane.insideX() + dyLow * plane.insideY())));
            } else {
                sum.clear().add(-radius).addProduct(dx, plane.insideX()).addProduct(dxLow, plane.insideX())
                    .addProduct(dy, plane.insideY()).addProduct(dyLow, plane.insideY()).roundTo(gap);
            }
        }

        @Override
        void normal(DoubleDouble x, DoubleDouble y, DoubleDouble toX, DoubleDouble toY) {
            toX.set(normalX);
            toY.set(normalY);
        }
    }

    /** The later root of the quadratic of {@link ExactCircles} with the radii's difference as touching distance. */
    static final class ExactArena extends ExactWall {

        private final Arena arena;
        private final ExactCircles circles = new ExactCircles();
        private final DoubleDouble length = new DoubleDouble();

        ExactArena(Arena arena) {
            this.arena = arena;
        }

        /** The time of a straight flight to the nearest point of the wall. */
        @Override
        double lowerBound(double x, double y, double vx, double vy, double radius) {
            double gap = arena.gap(x, y, radius) - 16 * U * (arena.radius() + radius + Math.abs(x) + Math.abs(y)
                + Math.abs(arena.x()) + Math.abs(arena.y()));
            double speed = Math.sqrt(vx * vx + vy * vy);
            return gap > 0 && speed > 0x1p-450 ? roundedDown(gap / speed * (1 - 8 * U))
                : exactBound(x, y, vx, vy, radius);
        }

        @Override
        boolean time(double x, double y, double vx, double vy, double radius, DoubleDouble until) {
            return load(x, y, vx, vy, radius).lastTouch(until);
        }

        @Override
        boolean approaches(double x, double y, double vx, double vy, double radius) {
            return load(x, y, vx, vy, radius).areSeparating();
        }

        private ExactCircles load(double x, double y, double vx, double vy, double radius) {
            boolean room = radius <= arena.radius();
            return circles.load(x, arena.x(), y, arena.y(), vx, 0, vy, 0, room ? arena.radius() : 0,
                room ? -radius : 0);
        }

        @Override
        void normal(DoubleDouble x, DoubleDouble y, DoubleDouble normalX, DoubleDouble normalY) {
            normalX.set(x).add(-arena.x());
            normalY.set(y).add(-arena.y());
            normalize(normalX, normalY, length, inverse);
        }
    }
}

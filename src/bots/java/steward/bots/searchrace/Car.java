package steward.bots.searchrace;

/**
 * The car: its state, and a turn of it. It is computed like that of the referee, less its care about last bits: a
 * forecast may be a unit off.
 */
final class Car {

    private static final double HALF_TURN = 180;

    double x;
    double y;
    double vx;
    double vy;
    /** In degrees. */
    double heading;
    int passed;

    void set(Car other) {
        x = other.x;
        y = other.y;
        vx = other.vx;
        vy = other.vy;
        heading = other.heading;
        passed = other.passed;
    }

    /** Returns how many degrees to turn for looking at a place, -180..180. */
    double angleTo(double placeX, double placeY) {
        double wanted = StrictMath.toDegrees(StrictMath.atan2(placeY - y, placeX - x));
        double off = (wanted - heading) % (2 * HALF_TURN);
        return off > HALF_TURN ? off - 2 * HALF_TURN : off < -HALF_TURN ? off + 2 * HALF_TURN : off;
    }

    double distanceTo(double placeX, double placeY) {
        return Math.sqrt((placeX - x) * (placeX - x) + (placeY - y) * (placeY - y));
    }

    /**
     * Plays a turn.
     *
     * @return the time of the last checkpoint passed in it, in turns; 1 if there was none
     */
    double play(Course course, int degrees, int thrust) {
        heading += degrees;
        if (thrust > 0) {
            double radians = StrictMath.toRadians(heading);
            vx += thrust * StrictMath.cos(radians);
            vy += thrust * StrictMath.sin(radians);
        }
        return coast(course);
    }

    /** Plays a turn without a command. */
    double coast(Course course) {
        double now = 0;
        while (passed < course.toFinish()) {
            double time = timeTo(course, now);
            if (!(now + time <= 1)) {
                break;
            }
            now += time;
            passed++;
        }
        x = (long) (x + vx);
        y = (long) (y + vy);
        vx = (long) (vx * (1 - course.drag));
        vy = (long) (vy * (1 - course.drag));
        return now > 0 ? now : 1;
    }

    /** Turns from a moment of this turn until the car is in the next checkpoint. */
    private double timeTo(Course course, double now) {
        int next = course.next(passed);
        double dx = x + vx * now - course.x[next];
        double dy = y + vy * now - course.y[next];
        double c = dx * dx + dy * dy - course.radius * course.radius;
        double a = vx * vx + vy * vy;
        double b = dx * vx + dy * vy;
        double d = b * b - a * c;
        return c <= 0 ? 0 : a == 0 || d < 0 || b >= 0 ? Double.POSITIVE_INFINITY : (-b - Math.sqrt(d)) / a;
    }
}

package steward.bots.meanmax;

/** A bot's commands to its three looters, in the order of answers. */
final class Orders {

    private static final int MOST_POWER = 300;
    /** How far away the target for a direction is set, in u. */
    private static final double FAR = 10_000;

    private final StringBuilder line = new StringBuilder();

    void begin() {
        line.setLength(0);
        line.append("{\"looters\":[");
    }

    private void next() {
        if (line.charAt(line.length() - 1) == '}') {
            line.append(',');
        }
    }

    /** Full thrust toward a place. */
    void go(double x, double y) {
        next();
        line.append("{\"x\":").append(Math.round(x)).append(",\"y\":").append(Math.round(y)).append(",\"power\":")
            .append(MOST_POWER).append('}');
    }

    /** The thrust that changes a looter's velocity by this much, or as much of it as there is power for. */
    void accelerate(Thing looter, double dvx, double dvy) {
        double change = Math.sqrt(dvx * dvx + dvy * dvy);
        long power = Math.min(MOST_POWER, Math.round(change * looter.mass));
        next();
        if (power == 0) {
            line.append("{\"wait\":true}");
            return;
        }
        line.append("{\"x\":").append(Math.round(looter.x + dvx / change * FAR)).append(",\"y\":")
            .append(Math.round(looter.y + dvy / change * FAR)).append(",\"power\":").append(power).append('}');
    }

    /** The looter's skill at a place. */
    void cast(double x, double y) {
        next();
        line.append("{\"x\":").append(Math.round(x)).append(",\"y\":").append(Math.round(y))
            .append(",\"skill\":true}");
    }

    /** The answer, without line end. */
    String answer() {
        return line + "]}";
    }
}

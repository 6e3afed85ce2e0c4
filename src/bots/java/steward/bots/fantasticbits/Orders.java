package steward.bots.fantasticbits;

/** A bot's commands to its two wizards, in the order of their ids. */
final class Orders {

    private final StringBuilder line = new StringBuilder();

    void begin() {
        line.setLength(0);
        line.append("{\"wizards\":[");
    }

    private StringBuilder next() {
        return line.charAt(line.length() - 1) == '}' ? line.append(',') : line;
    }

    private StringBuilder place(double x, double y) {
        return next().append("{\"x\":").append(Math.round(x)).append(",\"y\":").append(Math.round(y));
    }

    /** Full thrust toward a place. */
    void go(double x, double y) {
        place(x, y).append(",\"power\":150}");
    }

    /** The snaffle in hand is thrown toward a place with all power. */
    void toss(double x, double y) {
        place(x, y).append(",\"throw\":500}");
    }

    /** A spell. */
    void cast(String spell, Entity target) {
        next().append("{\"spell\":\"").append(spell).append("\",\"target\":").append(target.id).append('}');
    }

    /** The answer, without line end. */
    String answer() {
        return line + "]}";
    }
}

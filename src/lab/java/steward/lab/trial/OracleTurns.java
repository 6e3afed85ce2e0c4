package steward.lab.trial;

import java.util.List;
import java.util.Locale;
import steward.lab.oracle.Oracle;
import steward.lab.oracle.OracleBody;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;

/** Turns of a rung beside those of the oracle from the same states: how far off places and velocities are. */
public final class OracleTurns {

    private int compared;
    private int stopped;
    private double worst;

    /**
     * Compares a turn.
     *
     * @param before the bodies as the turn was advanced from
     * @param after  the bodies as the rung has left them
     */
    public void add(Bodies before, Bodies after, PhysicsParts parts) {
        List<OracleBody> truth = OracleBody.of(before);
        Oracle oracle = Oracle.of(parts, before);
        oracle.turn(truth);
        if (oracle.limited()) {
            stopped++;
            return;
        }
        compared++;
        double speed = Double.MIN_NORMAL;
        double off = 0;
        for (int k = 0; k < before.size(); k++) {
            OracleBody body = truth.get(k);
            speed = Math.max(speed, Math.abs(before.vx[k]) + Math.abs(before.vy[k]));
            off = Math.max(off, Math.max(distance(after.x[k] - body.x.doubleValue(), after.y[k] - body.y.doubleValue()),
                distance(after.vx[k] - body.vx.doubleValue(), after.vy[k] - body.vy.doubleValue())));
        }
        worst = Math.max(worst, off / speed);
    }

    private static double distance(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** True if there are turns, and none is off by more than this share of the fastest speed. */
    public boolean areWithin(double share) {
        return compared > 0 && worst <= share;
    }

    public String text() {
        return String.format(Locale.ROOT, "%d turns off the oracle's by %.1e%s", compared, worst,
            stopped > 0 ? ", " + stopped + " not computed by it" : "");
    }
}

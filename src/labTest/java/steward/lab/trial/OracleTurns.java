package steward.lab.trial;

import java.util.List;
import java.util.Locale;
import steward.lab.oracle.Oracle;
import steward.lab.oracle.OracleBody;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;

/**
 * Comparison of a rung's turns with those of the oracle from the same states: errors of positions and velocities. If
 * two contacts meet at the same time but for rounding, either may be the first, and the turns part; few may be such.
 */
public final class OracleTurns {

    /** Turns of which one may be another than the oracle's. */
    private static final int FEW = 20;

    private final double most;
    private int compared;
    private int stopped;
    private int others;
    private double worst;

    /** @param most how far off a turn may be, as a share of the fastest speed at its start */
    public OracleTurns(double most) {
        this.most = most;
    }

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
        boolean same = off <= most * speed;
        others += same ? 0 : 1;
        worst = same ? Math.max(worst, off / speed) : worst;
    }

    private static double distance(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** True if there are turns, and all but one in {@value #FEW} are the oracle's. */
    public boolean areTrue() {
        return compared > 0 && others * FEW <= compared;
    }

    public String text() {
        return (compared == 0 ? "no turn is compared with the oracle's" : String.format(Locale.ROOT,
            "%d of %d turns are the oracle's, off by %.1e", compared - others, compared, worst))
            + (stopped > 0 ? ", " + stopped + " not computed by it" : "");
    }
}

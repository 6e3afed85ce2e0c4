package steward.lab.trial;

import static steward.lab.oracle.DecimalErrors.relative;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import steward.lab.oracle.Oracle;
import steward.lab.oracle.OracleBody;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Comparison of one turn of many small worlds, played on a rung and by the oracle. The engine must find the same
 * impacts and, to a tolerance relative to the largest number of its kind in the world, the same final state. If that is
 * allowed, it may throw an exception that names what it cannot do. NaN, infinity and a different result are failures.
 */
public final class OracleCheck {

    /** How many failures are reported in full. */
    private static final int NAMED = 3;

    private final Rung rung;
    private final double tolerance;
    private int worlds;
    private int right;
    private int refused;
    private double worst;
    private String failures = "";

    public OracleCheck(Rung rung, double tolerance) {
        this.rung = rung;
        this.tolerance = tolerance;
    }

    /** The result must be right. @param what names the world if it fails */
    public void add(String what, ImpactLaw law, Bodies bodies, Wall... walls) {
        add(false, what, law, bodies, walls);
    }

    /** The result must be right, or refused by naming the body, what was found and what was expected. */
    public void addOrRefused(String what, ImpactLaw law, Bodies bodies, Wall... walls) {
        add(true, what, law, bodies, walls);
    }

    private void add(boolean mayRefuse, String what, ImpactLaw law, Bodies bodies, Wall... walls) {
        worlds++;
        List<OracleBody> truth = OracleBody.of(bodies);
        Probe probe = new Probe();
        try {
            rung.advanceOfAnyMass(law, walls).turn(bodies, probe);
        } catch (IllegalArgumentException refusal) {
            String message = String.valueOf(refusal.getMessage());
            if (mayRefuse && message.startsWith("body ") && message.contains(", expected ")) {
                refused++;
            } else {
                fail(what + ": refused: " + message);
            }
            return;
        }
        int impacts = new Oracle(law, List.of(walls)).turn(truth).size();
        if (!Probe.finite(bodies)) {
            fail(what + ": not finite");
            return;
        }
        double error = error(bodies, truth);
        if (probe.impacts != impacts || probe.limited > 0 || !(error <= tolerance)) {
            fail(String.format(Locale.ROOT, "%s: %d impacts for %d, off by %.1e", what, probe.impacts, impacts, error));
            return;
        }
        worst = Math.max(worst, error);
        right++;
    }

    private void fail(String what) {
        int wrong = worlds - right - refused;
        failures += wrong == 1 ? what : wrong <= NAMED ? " | " + what : wrong == NAMED + 1 ? " | ..." : "";
    }

    private static double error(Bodies bodies, List<OracleBody> truth) {
        BigDecimal place = BigDecimal.ZERO;
        BigDecimal speed = BigDecimal.ZERO;
        for (OracleBody body : truth) {
            place = place.max(body.x.abs()).max(body.y.abs()).max(body.radius);
            speed = speed.max(body.vx.abs()).max(body.vy.abs());
        }
        double worst = 0;
        for (int k = 0; k < truth.size(); k++) {
            OracleBody body = truth.get(k);
            worst = Math.max(worst, Math.max(
                Math.max(relative(bodies.x[k], body.x, place), relative(bodies.y[k], body.y, place)),
                Math.max(relative(bodies.vx[k], body.vx, speed), relative(bodies.vy[k], body.vy, speed))));
        }
        return worst;
    }

    public boolean met() {
        return right + refused == worlds;
    }

    public String text() {
        return String.format(Locale.ROOT, "%d worlds, %d right to %.1e, %d refused, %d wrong", worlds, right, worst,
            refused, worlds - right - refused) + (met() ? "" : ": " + failures);
    }
}

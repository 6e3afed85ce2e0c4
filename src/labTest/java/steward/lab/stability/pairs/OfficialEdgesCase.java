package steward.lab.stability.pairs;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;

/**
 * Stability case of the official law's limits: a row that just touches, the force at the minimum, a pod squeezed at a
 * wall.
 */
public final class OfficialEdgesCase extends StabilityCase {

    public OfficialEdgesCase() {
        super("official edges",
            "a row at rest at exactly 800; the force at 120 and 1 ulp to either side (J = f + max(120, f), exactly);"
            + " a shielded pod that squeezes another against a wall. All are right, finite and over, on every event"
            + " rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        StringBuilder text = new StringBuilder();
        boolean met = row(rung, text);
        for (int hair = -1; hair <= 1; hair++) {
            met &= force(rung, 120 + hair * Math.ulp(120.0), text);
        }
        met &= squeeze(rung, text);
        return Finding.of(rung.isEvent(), met, text.substring(2));
    }

    /**
     * Pairs 01, 12, 23 touch: each pair is driven apart with 120, so the outer ones leave, symmetrically up to the last
     * bits of the push-out.
     */
    private static boolean row(Rung rung, StringBuilder text) {
        Bodies bodies = new Bodies(4);
        for (int k = 0; k < 4; k++) {
            bodies.add(800 * k, 0, 400, 1);
        }
        Probe probe = new Probe();
        rung.advance(ImpactLaw.OFFICIAL_POD_RACE).turn(bodies, probe);
        text.append("; row of 4: ").append(probe.impacts).append(" impacts");
        return probe.limited == 0 && Probe.finite(bodies) && probe.impacts >= 3 && bodies.vx[0] <= -120
            && bodies.vx[3] >= 120 && bodies.vy[0] == 0;
    }

    /** A head-on impact of two at speed f: the force is (f + f) / (1 + 1) = f. */
    private static boolean force(Rung rung, double f, StringBuilder text) {
        Bodies bodies = new Bodies(2);
        bodies.add(0, 0, 400, 1);
        bodies.add(900, 0, 400, 1);
        bodies.setVelocity(0, f, 0);
        bodies.setVelocity(1, -f, 0);
        Probe probe = new Probe();
        rung.advance(ImpactLaw.OFFICIAL_POD_RACE).turn(bodies, probe);
        double impulse = f + Math.max(120, f);
        double after = rung.isExact() ? -Math.max(120, f) : f - impulse;       // f - J, with J whole or as stored
        text.append("; f = ").append(f).append(": J = ").append(probe.impulse);
        return probe.impacts == 1 && probe.impulse == impulse && bodies.vx[0] == after && bodies.vx[1] == -after;
    }

    private static boolean squeeze(Rung rung, StringBuilder text) {
        double behind = 0;
        long impacts = 0;
        boolean over = true;
        for (double speed = 0; speed <= 3200; speed += 25) {
            Bodies bodies = new Bodies(2);
            bodies.add(400, 0, 400, 1);
            bodies.add(1200 + speed / 7, 0, 400, 10);
            bodies.setVelocity(1, -speed, 0);
            Probe probe = new Probe();
            Advance advance = rung.advance(ImpactLaw.OFFICIAL_POD_RACE, new HalfPlane(0, 0, 1, 0, 1));
            for (int turn = 0; turn < 3; turn++) {
                advance.turn(bodies, probe);
                bodies.setVelocity(1, bodies.vx[1] - 200, 0);
                over &= probe.limited == 0 && Probe.finite(bodies);
                behind = Math.max(behind, 400 - bodies.x[0]);
            }
            impacts = Math.max(impacts, probe.impacts);
        }
        text.append(String.format(Locale.ROOT, "; squeezed: at most %d impacts, %.3g u behind the wall", impacts,
            behind));
        return over;
    }
}

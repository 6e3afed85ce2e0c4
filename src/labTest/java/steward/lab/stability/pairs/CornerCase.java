package steward.lab.stability.pairs;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.OracleCheck;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Segment;
import steward.physics.Wall;

/**
 * Stability case of corners: a hit at exactly 45 degrees, which touches two walls at once, and hits on a segment's end.
 */
public final class CornerCase extends StabilityCase {

    private static final double TOLERANCE = 1e-12;

    public CornerCase() {
        super("corners and ends",
            "45 degrees into a corner, both walls at once: back with the very same speeds, in the very same place; "
            + "a segment's end as the oracle has it (1e-12); on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int exact = 0;
        int corners = 0;
        for (int corner = 0; corner < 4; corner++) {
            for (double speed : new double[] {180, 171.3, 1e-3 + 90, 1e5, 1.0 / 3 + 100}) {
                corners++;
                exact += backFromCorner(rung, corner, speed) ? 1 : 0;
            }
        }
        OracleCheck check = new OracleCheck(rung, TOLERANCE);
        ends(check);
        tilted(check);
        return Finding.of(rung.isEvent(), exact == corners && check.met(),
            String.format(Locale.ROOT, "%d of %d corners exact; ends: %s", exact, corners, check.text()));
    }

    /** From the middle of a box around the origin, with 90 u to each side: there and back some times. */
    private static boolean backFromCorner(Rung rung, int corner, double speed) {
        Bodies bodies = new Bodies(1);
        bodies.add(0, 0, 10, 1);
        double vx = corner % 2 == 0 ? speed : -speed;
        double vy = corner / 2 == 0 ? speed : -speed;
        bodies.setVelocity(0, vx, vy);
        Probe probe = new Probe();
        rung.advance(ImpactLaw.PHYSICS, new HalfPlane(-100, 0, 1, 0, 1), new HalfPlane(0, -100, 0, 1, 1),
            new HalfPlane(100, 0, -1, 0, 1), new HalfPlane(0, 100, 0, -1, 1)).turn(bodies, probe);
        double sign = probe.impacts / 2 % 2 == 1 ? -1 : 1;
        boolean mirrored = bodies.x[0] * Math.signum(vx) == bodies.y[0] * Math.signum(vy);
        return probe.impacts % 2 == 0 && bodies.vx[0] == sign * vx && bodies.vy[0] == sign * vy
            && mirrored && (speed != 180 || bodies.x[0] == 0);
    }

    private static void ends(OracleCheck check) {
        Segment segment = new Segment(0, 0, 100, 0, 1);
        check.add("head-on", ImpactLaw.PHYSICS, one(-50, 0, 70, 0), segment);
        check.add("head-on, other end", ImpactLaw.PHYSICS, one(150, 0, -70, 0), segment);
        check.add("straight above the end", ImpactLaw.PHYSICS, one(0, 30, 0, -50), segment);
        check.add("beyond the end", ImpactLaw.PHYSICS, one(-6, 30, 0, -50), segment);
        check.add("a hair within the round end", ImpactLaw.PHYSICS, one(-10 * (1 - 1e-9), 30, 0, -50), segment);
        check.add("a hair outside the round end", ImpactLaw.PHYSICS, one(-10 * (1 + 1e-9), 30, 0, -50), segment);
        check.add("tangent to the end", ImpactLaw.PHYSICS, one(-10, 30, 0, -50), segment);
        check.add("in contact with the end", ImpactLaw.PHYSICS, one(-6, 8, 3, -4), segment);
    }

    /** A corner of two tilted walls, hit along its bisector and beside it. */
    private static void tilted(OracleCheck check) {
        Wall one = new HalfPlane(0, 0, 0.6, 0.8, 1);
        Wall other = new HalfPlane(0, 0, -0.8, 0.6, 1);
        check.add("tilted corner", ImpactLaw.PHYSICS, one(-10, 70, 18, -126), one, other);
        check.add("tilted corner, beside", ImpactLaw.PHYSICS, one(-10, 70, 20, -120), one, other);
    }

    private static Bodies one(double x, double y, double vx, double vy) {
        Bodies bodies = new Bodies(1);
        bodies.add(x, y, 10, 1);
        bodies.setVelocity(0, vx, vy);
        return bodies;
    }
}

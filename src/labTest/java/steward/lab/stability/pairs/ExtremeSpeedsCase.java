package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.OracleCheck;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Segment;

/** Stability case of speeds and lengths whose squares underflow or overflow, between bodies and at walls. */
public final class ExtremeSpeedsCase extends StabilityCase {

    private static final double TOLERANCE = 1e-12;

    public ExtremeSpeedsCase() {
        super("extreme speeds",
            "speeds 1e-310 to 1e200, lengths 1e-310 to 1e300, at walls too: a named refusal or a right answer "
            + "(oracle, 1e-12), never NaN, infinity or silence, on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        OracleCheck check = new OracleCheck(rung, TOLERANCE);
        for (double offset : new double[] {0, 0.6}) {
            String how = offset == 0 ? "" : " oblique";
            check.add("speed 1e-310 in contact" + how, ImpactLaw.PHYSICS, pair(1, offset, -1e-9, 1e-310));
            check.add("speed 1e-310 apart" + how, ImpactLaw.PHYSICS, pair(1, offset, 1e-3, 1e-310));
            check.add("lengths and speeds 1e-155" + how, ImpactLaw.PHYSICS, pair(1e-155, offset, 2e-155, 4e-155));
            check.add("lengths and speeds 1e-300" + how, ImpactLaw.PHYSICS, pair(1e-300, offset, 2e-300, 4e-300));
            check.add("speed 1e160" + how, ImpactLaw.PHYSICS, pair(1, offset, 10, 1e160));
            check.add("speed 1e160, distance 1e159" + how, ImpactLaw.PHYSICS, pair(1e158, offset, 1e159, 1e160));
            check.add("positions 1e155" + how, ImpactLaw.PHYSICS, pair(1e154, offset, 1e155, 2e155));
            check.add("positions 1e155, in contact" + how, ImpactLaw.PHYSICS, pair(1e155, offset, -1e146, 1e150));
            check.add("all 1e300" + how, ImpactLaw.PHYSICS, pair(1e299, offset, 1e300, 2e300));
        }
        walls(check);
        return Finding.of(rung.isEvent(), check.met(), check.text());
    }

    /** One body and a wall of each kind, all of one size. */
    private static void walls(OracleCheck check) {
        for (double size : new double[] {1e-310, 1e-300, 1e-155, 1e-70, 1e70, 1e155, 1e299}) {
            check.add("plane of " + size, ImpactLaw.PHYSICS, single(size, 0), new HalfPlane(9 * size, 0, -1, 0, 1));
            check.add("oblique plane of " + size, ImpactLaw.PHYSICS, single(size, 3 * size),
                new HalfPlane(9 * size, -size, -0.6, 0.8, 1));
            check.add("arena of " + size, ImpactLaw.PHYSICS, single(size, 3 * size), new Arena(0, 0, 8 * size, 1));
        }
        for (double speed : new double[] {1e-310, 1e-200, 1e-100, 1e100, 1e200}) {
            check.add("speed " + speed + " at a plane", ImpactLaw.PHYSICS, slow(speed), new HalfPlane(9, 0, -1, 0, 1));
            check.add("speed " + speed + " at a segment", ImpactLaw.PHYSICS, slow(speed), new Segment(9, -3, 9, 3, 1));
            if (speed < 1) {
                check.add("speed " + speed + " at an arena", ImpactLaw.PHYSICS, slow(speed), new Arena(0, 0, 9, 1));
            }
        }
        check.addOrRefused("masses and speeds too small together", ImpactLaw.PHYSICS, heavy(1e-300, 1e-100));
        check.addOrRefused("a segment far away", ImpactLaw.PHYSICS, single(1e100, 0), new Segment(9, -3, 9, 3, 1));
        check.addOrRefused("masses and speeds too large together", ImpactLaw.PHYSICS, heavy(1e300, 1e100));
    }

    /** One body in the middle, flying along x. */
    private static Bodies single(double size, double rise) {
        Bodies bodies = new Bodies(1);
        bodies.add(0, 0, size, 2);
        bodies.setVelocity(0, 10 * size, rise);
        return bodies;
    }

    /** One body in contact with a wall at x = 9, approaching it. */
    private static Bodies slow(double speed) {
        Bodies bodies = new Bodies(1);
        bodies.add(8, 0, 1, 2);
        bodies.setVelocity(0, speed, speed / 3);
        return bodies;
    }

    /** Two bodies in contact, approaching. */
    private static Bodies heavy(double mass, double speed) {
        Bodies bodies = new Bodies(2);
        bodies.add(0, 0, 1, mass);
        bodies.add(1.5, 0.5, 1, 3 * mass);
        bodies.setVelocity(0, speed, 0);
        return bodies;
    }

    /** A body of radius r at rest, and one that comes along x from a gap away, offset by a share of the touch. */
    private static Bodies pair(double radius, double share, double gap, double speed) {
        Bodies bodies = new Bodies(2);
        double along = Math.sqrt(1 - share * share) * 2 * radius;
        bodies.add(-along - gap, 0, radius, 1);
        bodies.add(0, share * 2 * radius, radius, 3);
        bodies.setVelocity(0, speed, 0);
        return bodies;
    }
}

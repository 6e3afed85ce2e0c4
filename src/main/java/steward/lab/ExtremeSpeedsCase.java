package steward.lab;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/** Speeds that vanish or explode when squared, and positions that do. */
final class ExtremeSpeedsCase implements StabilityCase {

    private static final double TOLERANCE = 1e-12;

    @Override
    public String name() {
        return "extreme speeds";
    }

    @Override
    public String demand() {
        return "speeds 1e-310 and 1e160, positions 1e155: a named refusal or a right answer (oracle, 1e-12), never "
            + "NaN, infinity or silence, on every event rung";
    }

    @Override
    public Seen run(Rung rung, Size size) {
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
        return Seen.of(rung.isEvent(), check.met(), check.text());
    }

    /** A body of radius r at rest, and one that comes along x, offset by a share of the touch, a gap away. */
    private static Bodies pair(double radius, double share, double gap, double speed) {
        Bodies bodies = new Bodies(2);
        double along = Math.sqrt(1 - share * share) * 2 * radius;
        bodies.add(-along - gap, 0, radius, 1);
        bodies.add(0, share * 2 * radius, radius, 3);
        bodies.setVelocity(0, speed, 0);
        return bodies;
    }
}

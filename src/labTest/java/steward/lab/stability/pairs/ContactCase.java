package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.OracleCheck;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/** Stability case of divisions by 0: coincident centres, deep overlap, no relative speed in contact. */
public final class ContactCase extends StabilityCase {

    private static final double TOLERANCE = 1e-12;

    public ContactCase() {
        super("degenerate contacts",
            "coincident centres, deep overlap, overlap and receding, equal velocities in contact: what the law says "
            + "(oracle, 1e-12), never NaN, on every event rung under both laws");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        OracleCheck check = new OracleCheck(rung, TOLERANCE);
        for (ImpactLaw law : new ImpactLaw[] {ImpactLaw.PHYSICS, ImpactLaw.OFFICIAL_POD_RACE}) {
            String name = law == ImpactLaw.PHYSICS ? "physics, " : "official, ";
            for (int mirror = -1; mirror <= 1; mirror += 2) {
                check.add(name + "coincident, at rest", law, pair(0, 0, 0, 0, 0, 0));
                check.add(name + "coincident, one moves", law, pair(0, 0, 300 * mirror, 70, 0, 0));
                check.add(name + "coincident, both move alike", law, pair(0, 0, 300 * mirror, 70, 300 * mirror, 70));
                check.add(name + "deep, approaching", law, pair(100 * mirror, 30, 500 * mirror, 40, -500 * mirror, 0));
                check.add(name + "deep, receding", law, pair(100 * mirror, 30, -500 * mirror, 40, 500 * mirror, 0));
                check.add(name + "deep, at rest", law, pair(50 * mirror, 0, 0, 0, 0, 0));
                check.add(name + "in contact, alike", law, pair(800 * mirror, 0, 200, 33, 200, 33));
                check.add(name + "in contact, sliding", law, pair(800 * mirror, 0, 0, 150, 0, -150));
                check.add(name + "in contact, approaching", law, pair(800 * mirror, 0, 9 * mirror, 0, -7 * mirror, 0));
                check.add(name + "in contact, receding", law, pair(800 * mirror, 0, -9 * mirror, 0, 7 * mirror, 0));
            }
        }
        return Finding.of(rung.isEvent(), check.met(), check.text());
    }

    private static Bodies pair(double dx, double dy, double vax, double vay, double vbx, double vby) {
        Bodies bodies = new Bodies(2);
        bodies.add(1000, 2000, 400, 1);
        bodies.add(1000 + dx, 2000 + dy, 400, 2);
        bodies.setVelocity(0, vax, vay);
        bodies.setVelocity(1, vbx, vby);
        return bodies;
    }
}

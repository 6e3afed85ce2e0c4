package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.OracleCheck;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/** Stability case of masses from 1e-300 to 1e300 and infinite ones, at ratios up to 1e600. */
public final class MassesCase extends StabilityCase {

    private static final double TOLERANCE = 1e-12;
    private static final int[] EXPONENTS = {-300, -200, -100, -30, -15, -1, 0, 1, 15, 30, 100, 200, 300};

    public MassesCase() {
        super("masses",
            "masses 1e-300..1e300, ratios of 1e30, infinite masses alone and meeting: a named refusal or a right "
            + "answer (oracle, 1e-12), never NaN, infinity or silence, on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        OracleCheck check = new OracleCheck(rung, TOLERANCE);
        for (int ea : EXPONENTS) {
            for (int eb : EXPONENTS) {
                double a = StrictMath.pow(10, ea);
                double b = StrictMath.pow(10, eb);
                check.add("1e" + ea + " and 1e" + eb, ImpactLaw.PHYSICS, pair(a, b, 0));
                check.add("1e" + ea + " and 1e" + eb + " oblique", ImpactLaw.PHYSICS, pair(a, b, 600));
            }
            double a = StrictMath.pow(10, ea);
            check.add("1e" + ea + " and infinite", ImpactLaw.PHYSICS, pair(a, Double.POSITIVE_INFINITY, 600));
            check.add("infinite and 1e" + ea, ImpactLaw.PHYSICS, pair(Double.POSITIVE_INFINITY, a, 600));
        }
        check.add("two infinite", ImpactLaw.PHYSICS, pair(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0));
        check.add("two infinite, official", ImpactLaw.OFFICIAL_POD_RACE,
            pair(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0));
        return Finding.of(rung.isEvent(), check.met(), check.text());
    }

    private static Bodies pair(double massA, double massB, double offset) {
        Bodies bodies = new Bodies(2);
        bodies.add(0, 0, 400, massA);
        bodies.add(1100, offset, 400, massB);
        bodies.setVelocity(0, 700, 10);
        bodies.setVelocity(1, -300, 0);
        return bodies;
    }
}

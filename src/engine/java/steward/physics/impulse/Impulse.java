package steward.physics.impulse;

import steward.numerics.DoubleDouble;
import steward.physics.ImpactLaw;

/*
 * Two bodies a, b with unit normal n from a to b, w = 1 / mass and approach speed u = (va - vb).n. An impulse j
 * along n,
 *
 *     va' = va - j wa n,    vb' = vb + j wb n,    changes the approach speed to u' = u - j (wa + wb).
 *
 * The first step j1 = u / (wa + wb) makes u' = 0; a second step j2 separates them at the speed (wa + wb) j2, which for
 * j2 = e j1 is e u: Newton's law of restitution. The kinetic energy changes by
 *
 *     dE = -j u + j^2 (wa + wb) / 2    with j = j1 + j2, u = j1 (wa + wb)
 *        = (wa + wb) / 2 * (j^2 - 2 j j1) = (wa + wb) (j2^2 - j1^2) / 2,
 *
 * nothing for j2 = j1 (elastic), a gain when a minimum impulse makes j2 larger than j1.
 */

/**
 * Rule for the second step of an impulse, which separates two bodies after the first step has stopped their approach.
 * Source: C. Hecker, "Physics, Part 3: Collision Response", 1997; the minimum is CodinGame's rule. A scene gets the
 * simplest rule that its law needs.
 */
sealed interface Impulse {

    /**
     * @param first       the first step, j1
     * @param restitution e of this impact; ignored where everything is elastic
     * @return the second step, j2
     */
    double secondStep(double first, double restitution);

    /** Computes the second step in double-double, in place: the first step becomes the second. */
    void toSecondStep(DoubleDouble step, double restitution);

    /** The rule for the second step under a law. */
    static Impulse of(ImpactLaw law, boolean withMinimum) {
        boolean elastic = law.restitution() == ImpactLaw.Restitution.ELASTIC;
        if (!withMinimum || law.minimumImpulse() == 0) {
            return elastic ? new Elastic() : new Restituted();
        }
        if (!Double.isNaN(law.deadZone())) {
            return new ByMagnitude(law.minimumImpulse(), law.deadZone());
        }
        return elastic ? new ElasticAtLeast(law.minimumImpulse()) : new AtLeast(law.minimumImpulse());
    }

    private static void raise(DoubleDouble step, double minimum) {
        if (step.high() < minimum) {
            step.set(minimum);
        }
    }

    /** j2 = j1. */
    record Elastic() implements Impulse {
        @Override
        public double secondStep(double first, double restitution) {
            return first;
        }

        @Override
        public void toSecondStep(DoubleDouble step, double restitution) {
            // unchanged
        }
    }

    /** j2 = e j1. */
    record Restituted() implements Impulse {
        @Override
        public double secondStep(double first, double restitution) {
            return restitution * first;
        }

        @Override
        public void toSecondStep(DoubleDouble step, double restitution) {
            step.multiply(restitution);
        }
    }

    /** j2 = max(j1, minimum). */
    record ElasticAtLeast(double minimum) implements Impulse {
        @Override
        public double secondStep(double first, double restitution) {
            return Math.max(minimum, first);
        }

        @Override
        public void toSecondStep(DoubleDouble step, double restitution) {
            raise(step, minimum);
        }
    }

    /** j2 = max(e j1, minimum). */
    record AtLeast(double minimum) implements Impulse {
        @Override
        public double secondStep(double first, double restitution) {
            return Math.max(minimum, restitution * first);
        }

        @Override
        public void toSecondStep(DoubleDouble step, double restitution) {
            raise(step.multiply(restitution), minimum);
        }
    }

    /** j2 = e j1, its magnitude raised to the minimum unless it lies in the dead zone; the sign stays. */
    record ByMagnitude(double minimum, double deadZone) implements Impulse {
        @Override
        public double secondStep(double first, double restitution) {
            return raised(restitution * first);
        }

        @Override
        public void toSecondStep(DoubleDouble step, double restitution) {
            double second = step.multiply(restitution).high();
            double raised = raised(second);
            if (raised != second) {
                step.set(raised);
            }
        }

        private double raised(double second) {
            double magnitude = Math.abs(second);
            return magnitude > deadZone && magnitude < minimum ? Math.copySign(minimum, second) : second;
        }
    }
}

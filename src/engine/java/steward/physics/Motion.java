package steward.physics;

import java.util.Arrays;
import java.util.List;
import java.util.function.ObjIntConsumer;

/**
 * Rules for speeds and positions at the end of a turn, such as drag and rounding: steps in their order, each applied to
 * every body. Absent steps cost nothing. Two motions with the same steps are equal. A game with other rules extends
 * this class, overriding {@link #endTurn}; its steps then describe what it does to bodies without a game around them,
 * in measurements.
 */
public class Motion {

    /** From this distance on a number is not taken for the whole number next to it: 1e-5. */
    private static final double SNAP = 1e-5;

    /** Quantity that a step changes. */
    public enum Of {
        /** The share of speed that is lost. */
        DRAG,
        /** Components of velocities. */
        VELOCITY,
        /** Coordinates of positions. */
        POSITION
    }

    /** One step. */
    public enum Step {

        /** Bodies lose their {@link Bodies#drag} share of speed. */
        DRAG(Of.DRAG, "drag", null) {
            @Override
            void apply(Bodies bodies) {
                for (int i = 0; i < bodies.size(); i++) {
                    double keep = 1 - bodies.drag[i];
                    bodies.vx[i] *= keep;
                    bodies.vy[i] *= keep;
                }
            }
        },

        /** Velocity components are cut toward zero to whole numbers (-0.0 becomes 0.0). */
        TRUNCATE_VELOCITY(Of.VELOCITY, "truncate", Motion::truncate),

        /** Velocity components become the nearest whole numbers, halves away from zero. */
        ROUND_VELOCITY(Of.VELOCITY, "round-half-away", Motion::roundAway),

        /** Velocity components within 1e-5 of a whole number become that one, others are cut toward zero. */
        SNAP_VELOCITY(Of.VELOCITY, "truncate-snap", Motion::snap),

        /** Coordinates become floor(x + 0.5): halves are rounded up. */
        ROUND_POSITION(Of.POSITION, "round", Motion::round),

        /** Coordinates become the nearest whole numbers, halves away from zero. */
        ROUND_POSITION_AWAY(Of.POSITION, "round-half-away", Motion::roundAway),

        /** Coordinates within 1e-5 of a whole number become that one, others are cut toward zero. */
        SNAP_POSITION(Of.POSITION, "truncate-snap", Motion::snap);

        private final Of about;
        private final String text;
        private final ObjIntConsumer<double[]> rounding;

        Step(Of about, String text, ObjIntConsumer<double[]> rounding) {
            this.about = about;
            this.text = text;
            this.rounding = rounding;
        }

        public Of about() {
            return about;
        }

        /** Its name in a scene. */
        public String text() {
            return text;
        }

        void apply(Bodies bodies) {
            rounding.accept(about == Of.VELOCITY ? bodies.vx : bodies.x, bodies.size());
            rounding.accept(about == Of.VELOCITY ? bodies.vy : bodies.y, bodies.size());
        }
    }

    private final List<Step> steps;
    private final Step[] inOrder;

    /** @param inOrder the steps, each at most once */
    public Motion(List<Step> inOrder) {
        steps = List.copyOf(inOrder);
        this.inOrder = steps.toArray(new Step[0]);
    }

    /**
     * The steps of the pod race, or some of them.
     *
     * @param drag              whether bodies lose their {@link Bodies#drag} share of speed
     * @param truncateVelocity  whether velocity components are then cut toward zero to whole numbers (-0.0 becomes 0.0)
     * @param roundPosition     whether positions become floor(x + 0.5): halves are rounded up
     */
    public Motion(boolean drag, boolean truncateVelocity, boolean roundPosition) {
        this(Arrays.stream(new Step[] {drag ? Step.DRAG : null, truncateVelocity ? Step.TRUNCATE_VELOCITY : null,
            roundPosition ? Step.ROUND_POSITION : null}).filter(step -> step != null).toList());
    }

    /** The steps in the order in which they apply. */
    public final List<Step> steps() {
        return steps;
    }

    /** The step about this, or {@code null} if there is none. */
    public final Step step(Of about) {
        for (Step step : inOrder) {
            if (step.about == about) {
                return step;
            }
        }
        return null;
    }

    /** True if bodies lose their {@link Bodies#drag} share of speed. */
    public final boolean drag() {
        return step(Of.DRAG) != null;
    }

    /** True if velocities and positions both become whole numbers. */
    public final boolean endsInWholeNumbers() {
        return step(Of.VELOCITY) != null && step(Of.POSITION) != null;
    }

    /** The steps about these, in the same order. */
    public final Motion only(Of... wanted) {
        return new Motion(steps.stream().filter(step -> Arrays.asList(wanted).contains(step.about)).toList());
    }

    /** Applies the steps to every body. */
    public void endTurn(Bodies bodies) {
        for (Step step : inOrder) {
            step.apply(bodies);
        }
    }

    /** Applies the steps about this alone, for a game with an order of its own. */
    protected final void apply(Of about, Bodies bodies) {
        for (Step step : inOrder) {
            if (step.about == about) {
                step.apply(bodies);
            }
        }
    }

    /**
     * The nearest whole number, halves away from zero, never -0.0: floor(|x| + 0.5) with an exact addition and the sign
     * of x, as Mean Max and other official games round.
     */
    public static double roundHalfAway(double value) {
        double size = Math.abs(value);
        double floor = Math.floor(size);
        double rounded = size - floor >= 0.5 ? floor + 1 : floor;
        return value < 0 ? 0.0 - rounded : rounded;
    }

    /** The whole number within 1e-5 of a number, if there is one; otherwise the number cut toward zero; never -0.0. */
    public static double truncateWithSnap(double value) {
        double rounded = roundHalfAway(value);
        return Math.abs(rounded - value) < SNAP ? rounded
            : (value < 0 ? Math.ceil(value) : Math.floor(value)) + 0.0;
    }

    private static void truncate(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            double value = values[i];
            values[i] = (value < 0 ? Math.ceil(value) : Math.floor(value)) + 0.0;
        }
    }

    private static void round(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            values[i] = Math.floor(values[i] + 0.5) + 0.0;
        }
    }

    private static void roundAway(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            values[i] = roundHalfAway(values[i]);
        }
    }

    private static void snap(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            values[i] = truncateWithSnap(values[i]);
        }
    }

    @Override
    public final boolean equals(Object other) {
        return other instanceof Motion motion && getClass() == motion.getClass() && steps.equals(motion.steps);
    }

    @Override
    public final int hashCode() {
        return steps.hashCode();
    }

    @Override
    public String toString() {
        return "Motion" + steps;
    }
}

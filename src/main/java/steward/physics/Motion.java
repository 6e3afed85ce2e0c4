package steward.physics;

import java.util.ArrayList;
import java.util.List;

/**
 * The rules for speeds and positions at the end of a turn. Consists of the rules that a scene names; absent rules cost
 * nothing. Two with the same rules are equal.
 */
public final class Motion {

    /** One rule, in the order in which they apply. */
    private enum Rule {

        DRAG {
            @Override
            void apply(Bodies bodies) {
                for (int i = 0; i < bodies.size(); i++) {
                    double keep = 1 - bodies.drag[i];
                    bodies.vx[i] *= keep;
                    bodies.vy[i] *= keep;
                }
            }
        },

        TRUNCATE_VELOCITY {
            @Override
            void apply(Bodies bodies) {
                truncate(bodies.vx, bodies.size());
                truncate(bodies.vy, bodies.size());
            }
        },

        ROUND_POSITION {
            @Override
            void apply(Bodies bodies) {
                round(bodies.x, bodies.size());
                round(bodies.y, bodies.size());
            }
        };

        abstract void apply(Bodies bodies);
    }

    private final List<Rule> rules;
    private final Rule[] inOrder;

    /**
     * @param drag              whether bodies lose their {@link Bodies#drag} share of speed
     * @param truncateVelocity  whether velocity components are then cut toward zero to whole numbers (-0.0 becomes 0.0)
     * @param roundPosition     whether positions become floor(x + 0.5): halves are rounded up
     */
    public Motion(boolean drag, boolean truncateVelocity, boolean roundPosition) {
        List<Rule> named = new ArrayList<>();
        if (drag) {
            named.add(Rule.DRAG);
        }
        if (truncateVelocity) {
            named.add(Rule.TRUNCATE_VELOCITY);
        }
        if (roundPosition) {
            named.add(Rule.ROUND_POSITION);
        }
        rules = List.copyOf(named);
        inOrder = rules.toArray(new Rule[0]);
    }

    /** Whether bodies lose their {@link Bodies#drag} share of speed. */
    public boolean drag() {
        return rules.contains(Rule.DRAG);
    }

    /** Whether velocity components are cut toward zero. */
    public boolean truncateVelocity() {
        return rules.contains(Rule.TRUNCATE_VELOCITY);
    }

    /** Whether positions are rounded. */
    public boolean roundPosition() {
        return rules.contains(Rule.ROUND_POSITION);
    }

    /** Applies the rules to every body. */
    public void endTurn(Bodies bodies) {
        for (Rule rule : inOrder) {
            rule.apply(bodies);
        }
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

    @Override
    public boolean equals(Object other) {
        return other instanceof Motion motion && rules.equals(motion.rules);
    }

    @Override
    public int hashCode() {
        return rules.hashCode();
    }

    @Override
    public String toString() {
        return "Motion" + rules;
    }
}

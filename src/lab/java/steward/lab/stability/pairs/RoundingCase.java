package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.Progress;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.Motion;

/** Stability case of the official rounding at the end of a turn, at the numbers where it could go either way. */
public final class RoundingCase extends StabilityCase {

    /** Position and floor(x + 0.5) of it, the sum being a double: so 0.49999999999999994 becomes 1. */
    private static final double[][] POSITIONS = {
        {0.49999999999999994, 1}, {0.5, 1}, {1.5, 2}, {2.5, 3}, {-0.5, 0}, {-1.5, -1}, {-2.5, -2}, {-0.0, 0}, {0, 0},
        {-0.49999999999999994, 0}, {-0.25, 0}, {0.4999, 0}, {0x1p52, 0x1p52}, {0x1p51 + 0.5, 0x1p51 + 1},
        {-0x1p51 - 0.5, -0x1p51}, {0x1p53, 0x1p53}, {15999.5, 16000}, {-Double.MIN_VALUE, 0}};
    /** Speed and its value cut toward zero. */
    private static final double[][] SPEEDS = {
        {-0.0, 0}, {0, 0}, {0.9999999999999999, 0}, {-0.9999999999999999, 0}, {1, 1}, {-1, -1}, {1.9999999999999998, 1},
        {-1.9999999999999998, -1}, {-Double.MIN_VALUE, 0}, {Double.MIN_VALUE, 0}, {0x1p52 + 1, 0x1p52 + 1},
        {-123.7, -123}};

    public RoundingCase() {
        super("rounding",
            "floor(x + 0.5) at 0.49999999999999994, halves and negative zero, cutting at -0.0: no negative zero "
            + "left, exactly, on every rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size, Progress progress) {
        Motion end = new Motion(false, true, true);
        StringBuilder wrong = new StringBuilder();
        for (double[] position : POSITIONS) {
            Bodies bodies = new Bodies(1);
            bodies.add(position[0], position[0], 1, 1);
            end.endTurn(bodies);
            compare(position, bodies.x[0], wrong);
            compare(position, bodies.y[0], wrong);
        }
        for (double[] speed : SPEEDS) {
            Bodies bodies = new Bodies(1);
            bodies.add(0, 0, 1, 1);
            bodies.setVelocity(0, speed[0], speed[0]);
            end.endTurn(bodies);
            compare(speed, bodies.vx[0], wrong);
            compare(speed, bodies.vy[0], wrong);
        }
        int numbers = POSITIONS.length + SPEEDS.length;
        return Finding.demanded(wrong.isEmpty(), numbers + " numbers"
            + (wrong.isEmpty() ? " as by hand" : "; wrong:" + wrong));
    }

    private static void compare(double[] fromAndTo, double found, StringBuilder wrong) {
        if (Double.doubleToLongBits(found) != Double.doubleToLongBits(fromAndTo[1])) {
            wrong.append(' ').append(fromAndTo[0]).append(" became ").append(found);
        }
    }
}

package steward.lab.stability.bodies;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.OracleTurns;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Wall;

/*
 * A ball dropped from the height h under the acceleration a falls for the time t = sqrt(2 h / a), and each bounce takes
 * 2 e t, 2 e^2 t and so on: in all t (1 + 2 e / (1 - e)).
 */

/** Stability case of one dropped ball, on everything on which it can lie. */
public final class SingleRestCase extends StabilityCase {

    private static final long SEED = 56;
    private static final double MOST_OFF = 1e-9;
    /** One ball in so many has no restitution. */
    private static final int WITHOUT = 7;
    private static final double[][] WEDGES = {{30, 30}, {10, 10}, {45, 5}};

    public SingleRestCase() {
        super("single bodies rest", "a ball dropped on a floor, beside a wall, on a bumper or to the lowest point of"
            + " an arena. It falls from 10 to 800 u, with e = 0 and 0.05 to 0.95, gravity 0.3 to 10. It lies still "
            + "no later than its geometric series and 2 turns, and no earlier than that less 1.5/(1 - e) + 1. A "
            + "disc in wedges of 30/30, 10/10 and 45/5 degrees, with e = 0 to 0.9, lies still within 2,000 turns. "
            + "Of every 10th turn of these discs, 19 of 20 are the oracle's to 1e-9 of the speed. On event rungs of"
            + " ours");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        SplitMix64 random = new SplitMix64(SEED);
        int balls = size.pick(20, 200, 2_000);
        double late = Double.NEGATIVE_INFINITY;
        double early = Double.POSITIVE_INFINITY;
        int moving = 0;
        for (int n = 0; n < balls; n++) {
            double e = n % WITHOUT == 0 ? 0 : 0.05 + 0.9 * random.nextDouble();
            double height = 10 + 790 * random.nextDouble();
            double gravity = 0.3 + 9.7 * random.nextDouble();
            double series = Math.sqrt(2 * height / gravity) * (1 + 2 * e / (1 - e));
            int still = ball(rung, n, e, height, gravity, (int) series + 100);
            moving += still < 0 ? 1 : 0;
            late = Math.max(late, still - series);
            early = Math.min(early, still - series + 1.5 / (1 - e) + 1);
        }
        int hopping = 0;
        OracleTurns truth = new OracleTurns(MOST_OFF);
        for (double[] wedge : WEDGES) {
            for (double e : new double[] {0, 0.3, 0.6, 0.9}) {
                hopping += disc(rung, wedge, e, truth) < 0 ? 1 : 0;
            }
        }
        boolean met = moving == 0 && hopping == 0 && late <= 2 && early >= 0 && truth.areTrue();
        return Finding.of(rung.isOurs(), met, String.format(Locale.ROOT, "%d balls, %d never still; at most %.2f turns "
            + "after the series, %.2f turns after the earliest; %d of 12 discs in wedges never still, %s", balls,
            moving, late, early, hopping, truth.text()));
    }

    private static int ball(Rung rung, int n, double e, double height, double gravity, int turns) {
        Bodies bodies = new Bodies(2);
        Falls.add(bodies, 0, -10 - height, 1, e);
        Wall[] walls = switch (n % 4) {
            case 0 -> new Wall[] {Falls.FLOOR};
            case 1 -> new Wall[] {Falls.FLOOR, new HalfPlane(-10, 0, 1, 0, 1)};
            case 2 -> new Wall[] {new Arena(0, -900, 900, 1)};
            default -> new Wall[0];
        };
        if (walls.length == 0) {
            bodies.add(0, 100, 100, Double.POSITIVE_INFINITY);
        }
        return new Falls(bodies, rung, n % 8 >= 4, Falls.SOFT, gravity, walls).playUntilStill(turns);
    }

    private static int disc(Rung rung, double[] degrees, double e, OracleTurns truth) {
        Bodies bodies = new Bodies(1);
        Falls.add(bodies, -20, -200, 1, e);
        bodies.setVelocity(0, 3, 0);
        return new Falls(bodies, rung, false, Falls.SOFT, 2, Falls.slope(degrees[0], 1),
            Falls.slope(degrees[1], -1)).comparing(truth, 10)
            .playUntilStill(2_000);
    }
}

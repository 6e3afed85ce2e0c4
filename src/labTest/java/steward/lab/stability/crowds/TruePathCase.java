package steward.lab.stability.crowds;

import java.util.List;
import java.util.Locale;
import steward.lab.oracle.Oracle;
import steward.lab.oracle.OracleBody;
import steward.lab.oracle.OracleImpact;
import steward.lab.trial.Finding;
import steward.lab.trial.Gas;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;

/**
 * Stability case of chaos: counts the impacts of a gas of elastic discs until it leaves its true path. Each impact
 * multiplies an error by some factor, so that any rounding, even of the state at the end of a turn, grows to the size
 * of a disc after some dozens of impacts of each. The true path is the oracle's, whose 64 digits last several times as
 * long.
 */
public final class TruePathCase extends StabilityCase {

    public static final String NAME = "true path";

    private static final int[] COUNTS = {3, 10, 30, 100};
    private static final double COVERAGE = 0.2;
    /** Impacts at times that differ by more than this part of a turn are not the same. */
    private static final double SAME_TIME = 1e-4;
    /** Fewer true impacts of each disc than this would mean that more than rounding is lost. */
    private static final double LEAST_EACH = 15;

    public TruePathCase() {
        super(NAME,
            "3, 10, 30 and 100 discs in a box. Impacts are counted until one is not the true one (another pair, or "
            + "off by 1e-4 turns), as the mean of several gases. At least 15 for each disc on every event rung; "
            + "more no arithmetic can promise");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        StringBuilder text = new StringBuilder();
        boolean met = true;
        for (int count : COUNTS) {
            int gases = count > 30 ? size.pick(0, 1, 4) : count > 10 ? size.pick(0, 2, 10) : size.pick(2, 10, 100);
            double impacts = 0;
            for (int seed = 1; seed <= gases; seed++) {
                impacts += truePath(rung, new Gas(seed, count, COVERAGE)) / (double) gases;
            }
            if (gases > 0) {
                double each = 2 * impacts / count;
                met &= each >= LEAST_EACH;
                text.append(text.length() == 0 ? "" : "; ").append(String.format(Locale.ROOT,
                    "%d discs: %.0f impacts, %.0f for each", count, impacts, each));
            }
        }
        return Finding.of(rung.isEvent(), met, text.toString());
    }

    private static int truePath(Rung rung, Gas gas) {
        Bodies bodies = gas.bodies();
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setVelocity(k, bodies.vx[k] / 50, bodies.vy[k] / 50);   // a few impacts a turn
        }
        Advance advance = rung.advance(ImpactLaw.PHYSICS, gas.walls());
        List<OracleBody> truth = OracleBody.of(bodies);
        Oracle oracle = new Oracle(ImpactLaw.PHYSICS, List.of(gas.walls()));
        int impacts = 0;
        for (int turn = 0; turn < 1000; turn++) {
            TurnLog log = new TurnLog();
            advance.turn(bodies, log);
            List<OracleImpact> expected = oracle.turn(truth);
            for (int k = 0; k < expected.size(); k++) {
                if (k >= log.impacts() || !isSame(log.impact(k), expected.get(k))) {
                    return impacts;
                }
                impacts++;
            }
            if (log.impacts() > expected.size()) {
                return impacts;
            }
        }
        return impacts;
    }

    private static boolean isSame(Impact impact, OracleImpact expected) {
        return impact.a() == expected.a() && impact.b() == expected.b()
            && Math.abs(impact.time() - expected.time().doubleValue()) <= SAME_TIME;
    }
}

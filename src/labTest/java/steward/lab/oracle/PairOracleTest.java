package steward.lab.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.lab.trial.PairSampler;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.event.Scenes;

/** The fast truth about pairs against the oracle, and by hand. */
@Execution(ExecutionMode.CONCURRENT)
class PairOracleTest {

    private static Bodies pair(double x, double y, double vx, double vy, double radius) {
        Bodies bodies = Scenes.bodies(new double[][] {{x, y, vx, vy, 1, radius}, {0, 0, 0, 0, 1, radius}});
        return bodies;
    }

    @Test
    void byHand() {
        PairOracle half = new PairOracle(pair(-4, 0, 4, 0, 1));                 // gap 2, closing 4
        assertTrue(half.hit());
        assertEquals(0, half.ulps(0.5));
        assertEquals(1, half.ulps(Math.nextUp(0.5)));
        assertEquals(2, half.ulps(0.5 + 2 * Math.ulp(0.5)));
        assertFalse(new PairOracle(pair(-4, 0, 1.9999999999999998, 0, 1)).hit(), "just after the turn");
        assertTrue(new PairOracle(pair(-4, 0, 2, 0, 1)).hit(), "at its very end");
        assertFalse(new PairOracle(pair(-4, 2, 4, 0, 1)).hit(), "tangent");
        assertTrue(new PairOracle(pair(-4, Math.nextDown(2.0), 4, 0, 1)).hit());
        assertFalse(new PairOracle(pair(-1, 0, -4, 0, 1)).hit(), "receding");
        assertTrue(new PairOracle(pair(-1, 0, 4, 0, 1)).hit(), "overlapping and approaching");
    }

    /** Both must say the same about pairs, a third of them grazing, over exponents of +-900. */
    @Test
    @Tag("sized")
    void agreesWithTheOracle() {
        Oracle oracle = new Oracle(ImpactLaw.PHYSICS.withMaximumImpacts(1), List.of());
        int hits = 0;
        int pairs = TestSize.of(400, 2000);
        for (long seed = 1; seed <= pairs; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double off = StrictMath.pow(10, -random.nextInt(1, 16));
            double share = seed % 3 == 0 ? 1 - off : seed % 3 == 1 ? 1 + off : random.nextDouble();
            Bodies bodies = PairSampler.passing(random, Math.scalb(1 + random.nextDouble(), random.nextInt(-900, 900)),
                share,
                0, 0.1 + random.nextDouble(), 0, 0);
            PairOracle truth = new PairOracle(bodies);
            List<OracleImpact> impacts = oracle.turn(OracleBody.of(bodies));
            assertEquals(!impacts.isEmpty(), truth.hit(), "seed " + seed);
            if (truth.hit()) {
                hits++;
                BigDecimal time = impacts.get(0).time();
                double near = time.doubleValue();
                assertEquals(DecimalErrors.ulps(near, time), truth.ulps(near), 1e-12, "seed " + seed);
                double off2 = near + 3 * Math.ulp(near);
                assertEquals(DecimalErrors.ulps(off2, time), truth.ulps(off2), 2, "seed " + seed);
            }
        }
        assertTrue(hits > 0.4 * pairs, "hits " + hits);
    }
}

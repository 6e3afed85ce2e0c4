package steward.league.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Brownian motion between two barriers, against another program and closed forms. */
@Execution(ExecutionMode.CONCURRENT)
class BrownianExitTest {

    private static final double BARRIER = Math.log(19);
    private static final BrownianExit EXIT = new BrownianExit(-BARRIER, BARRIER);

    /** From fishtest's brownian.py, outcome_cdf_alt1, another series: at the lower barrier, -1, 0.7, the upper one. */
    @Test
    void fishtestsSeriesHasTheSameProbabilities() {
        double[][] known = {
            {-0.5, 2, 0.13478306767327075, 0.5002961760766511, 0.8852543551454851, 0.9929061543317684},
            {-0.5, 12, 0.8902387165546483, 0.9202631643613096, 0.9450936271113848, 0.9531453307076501},
            {0, 5, 0.1878299447048158, 0.3407216588204127, 0.6143291575496544, 0.8121700552951843},
            {0.5, 2, 0.007093845668231548, 0.07880627326183628, 0.41588932516781996, 0.8652169323267292},
            {0.5, 12, 0.046854669292349924, 0.0524820123771729, 0.0740757378559551, 0.10976128344535174},
            {1.3, 2, 0.00023533935190021333, 0.005479715093228258, 0.08951730551858544, 0.5028883792641392},
            {1.3, 5, 0.0004589230449707068, 0.0007577363694283323, 0.004793217543775016, 0.030608453049700158}};
        for (double[] row : known) {
            assertEquals(row[2], EXIT.below(row[0], row[1]), 2e-9);
            assertEquals(row[3], EXIT.worse(row[0], row[1], -1), 2e-9);
            assertEquals(row[4], EXIT.worse(row[0], row[1], 0.7), 2e-9);
            assertEquals(row[5], 1 - EXIT.above(row[0], row[1]), 2e-9);
        }
    }

    /** After a long time all have reached a barrier: with the drift -1/2 the upper one with 5% (A. Wald, 1945). */
    @Test
    void inTheEndTheErrorsAreThoseOfWaldsTest() {
        for (double[] errors : new double[][] {{0.05, 0.05}, {0.01, 0.2}, {0.3, 0.001}}) {
            Gsprt test = new Gsprt(0, 10, errors[0], errors[1], Gsprt.Model.NORMALIZED);
            BrownianExit exit = new BrownianExit(test.lower(), test.upper());
            assertEquals(errors[0], exit.above(-0.5, 5000), 1e-12);
            assertEquals(1 - errors[0], exit.below(-0.5, 5000), 1e-12);
            assertEquals(errors[1], exit.below(0.5, 5000), 1e-12);
        }
    }

    /** Far from both barriers it is a normal distribution; drifts that are far out give 0 and 1, and no overflow. */
    @Test
    void shortTimesAndGreatDrifts() {
        assertEquals(0.5, EXIT.worse(0.25, 0.01, 0.0025), 1e-12);
        assertEquals(0, EXIT.below(0.25, 0.01), 1e-12);
        for (double time : new double[] {1e-4, 0.01, 1, 100}) {
            double drift = 40 / Math.sqrt(time) + 40 / time;
            assertEquals(1, EXIT.above(drift, time), 1e-10);
            assertEquals(0, EXIT.above(-drift, time), 1e-10);
            assertEquals(0, EXIT.worse(drift, time, 0.5), 1e-10);
            assertEquals(1, EXIT.worse(-drift, time, 0.5), 1e-10);
        }
    }
}

package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.podrace.RulesEdition;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.event.EventAdvance;
import steward.physics.event.FarPairs;

/**
 * {@link CertifiedImpacts} against the event loop of every scene, which gets velocities that are off by up to 2^-27
 * each: whatever is called sure is what the loop gives. Cases lie where the bounds decide:
 * grazes, impacts at the end of the turn, two within a window and a little more, touches at the start.
 */
class CertifiedImpactsTest {

    private static final int PODS = 4;
    private static final double TOUCH = 800;
    private static final double ERROR = 0x1p-27;

    private final SplitMix64 random = new SplitMix64(17);
    private final TurnLog log = new TurnLog();
    private final PodPaths paths = new PodPaths(4, log, PodTurn.CHECKPOINT_RADIUS, RulesEdition.LIVE);
    private final CertifiedImpacts certified = new CertifiedImpacts(PODS, paths);
    private final EventAdvance game =
        new EventAdvance(new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL));
    private final double[] x = new double[PODS];
    private final double[] y = new double[PODS];
    private final double[] vx = new double[PODS];
    private final double[] vy = new double[PODS];
    private final double[] mass = new double[PODS];

    @Test
    void whatIsSureIsWhatTheGameGives(TestReporter report) {
        int sure = 0;
        int impacts = 0;
        int trials = 60_000;
        for (int trial = 0; trial < trials; trial++) {
            draw(trial);
            Bodies bodies = new Bodies(PODS);
            boolean small = true;
            for (int pod = 0; pod < PODS; pod++) {
                bodies.add(x[pod], y[pod], PodTurn.RADIUS, mass[pod]);
                bodies.vx[pod] = vx[pod] + off();
                bodies.vy[pod] = vy[pod] + off();
                small &= certified.set(pod, x[pod], y[pod], vx[pod], vy[pod], mass[pod] == 1 ? 1 : 0.1);
            }
            paths.clear();
            assertTrue(small, "small numbers");
            if (!certified.fly(near())) {
                continue;
            }
            sure++;
            log.clear();
            game.turn(bodies, log);
            impacts += log.impacts();
            int number = trial;
            for (int pod = 0; pod < PODS; pod++) {
                if ((certified.touched() >> pod & 1) != 0) {
                    assertEquals(Math.floor(bodies.x[pod] + 0.5) + 0.0, certified.x(pod), () -> "trial " + number);
                    assertEquals(Math.floor(bodies.y[pod] + 0.5) + 0.0, certified.y(pod), () -> "trial " + number);
                    assertEquals((int) (bodies.vx[pod] * PodTurn.KEEP), certified.vx(pod), () -> "trial " + number);
                    assertEquals((int) (bodies.vy[pod] * PodTurn.KEEP), certified.vy(pod), () -> "trial " + number);
                }
            }
            int touched = 0;
            for (int k = 0; k < log.knots(); k++) {
                touched |= 1 << log.knotBody(k);
            }
            assertEquals(touched, certified.touched(), () -> "who was touched in trial " + number);
        }
        report.publishEntry(sure + " of " + trials + " turns are sure, with " + impacts + " impacts");
        assertTrue(sure > trials / 5 && sure < trials && impacts > trials / 5, sure + " sure, " + impacts);
    }

    private double off() {
        return (random.nextInt(2) * 2 - 1) * ERROR;
    }

    /** All pairs that the filter does not set aside. */
    private long near() {
        long near = 0;
        long bit = 1;
        for (int i = PODS - 1; i > 0; i--) {
            for (int j = i - 1; j >= 0; j--, bit <<= 1) {
                if (FarPairs.mayMeet(x[i] - x[j], y[i] - y[j], vx[i] - vx[j], vy[i] - vy[j], 1,
                    TOUCH * TOUCH)) {
                    near |= bit;
                }
            }
        }
        return near;
    }

    /** Pods 0 and 1 meet as the trial demands; 2 and 3 meet at about the same time, or near them. */
    private void draw(int trial) {
        double little = random.nextDouble() * Math.scalb(1, -random.nextInt(0, 30)) * (random.nextInt(2) * 2 - 1);
        double time = switch (trial % 4) {
            case 0 -> random.nextDouble();
            case 1 -> 1 - Math.abs(little) * 0.01;
            case 2 -> Math.abs(little) * 0.01;
            default -> -Math.abs(little);                // before the start: an overlap, if they are slow
        };
        double beside = trial % 3 == 0 ? TOUCH * (1 - Math.abs(little) * 1e-3) : TOUCH * random.nextDouble();
        meet(0, time, beside, 4000);
        if (trial % 5 < 2) {
            meet(2, time + little * 0.1, TOUCH * random.nextDouble(), 9000);
        } else {
            meet(2, random.nextDouble(), TOUCH * random.nextDouble(), 5200 + 400 * random.nextDouble());
        }
        for (int pod = 0; pod < PODS; pod++) {
            mass[pod] = random.nextInt(4) == 0 ? 10 : 1;
        }
    }

    private void meet(int pod, double time, double beside, double place) {
        double angle = random.nextDouble() * 7;
        double speed = 20 + 1500 * random.nextDouble();
        double wx = speed * StrictMath.cos(angle);
        double wy = speed * StrictMath.sin(angle);
        double ahead = Math.sqrt(TOUCH * TOUCH - beside * beside) + speed * time;
        x[pod] = Math.rint(place * random.nextDouble()) + (place > 8000 ? 9000 : 0);
        y[pod] = place;
        x[pod + 1] = x[pod] + ahead * wx / speed - beside * wy / speed;
        y[pod + 1] = y[pod] + ahead * wy / speed + beside * wx / speed;
        double share = random.nextDouble();
        vx[pod] = wx * share;
        vy[pod] = wy * share;
        vx[pod + 1] = wx * (share - 1);
        vy[pod + 1] = wy * (share - 1);
    }
}

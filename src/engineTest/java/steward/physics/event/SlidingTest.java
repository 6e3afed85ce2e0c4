package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.TurnSink;

/** A body on the rim of an arena goes round: 300 u on a circle of 490 u are 0.612 radians. */
@Execution(ExecutionMode.CONCURRENT)
class SlidingTest {

    private static List<Advance> both(ImpactLaw law, Arithmetic arithmetic, double restitution) {
        PhysicsParts parts = new PhysicsParts(law, arithmetic, new Contacts(1),
            List.of(new Arena(0, 0, 500, restitution)), null, false);
        return law.batchWindow() > 0 ? List.of(new EventAdvance(parts))
            : Scenes.both(parts);
    }

    private static Bodies onTheRim(double inward) {
        Bodies bodies = new Bodies(2);
        Scenes.add(bodies, 490, 0, -300 * inward, 300, 1);
        return bodies;
    }

    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void itKeepsItsSpeedAndGoesRound(Arithmetic arithmetic) {
        for (double inward : new double[] {0, 1e-6, -1e-6}) {
            for (double restitution : new double[] {1, 0.5, 0}) {
                for (Advance advance : both(Scenes.WITH_RESTITUTION, arithmetic, restitution)) {
                    Bodies bodies = onTheRim(inward);
                    double energy = Scenes.energy(bodies);
                    String what = "inward " + inward + ", e " + restitution;
                    for (int turn = 1; turn <= 20; turn++) {
                        TurnLog log = Scenes.turn(advance, bodies);
                        double angle = Math.atan2(bodies.y[0], bodies.x[0]);
                        assertEquals(0, Math.IEEEremainder(angle - turn * 300 / 490.0, 2 * Math.PI), 1e-6, what);
                        assertEquals(energy, Scenes.energy(bodies), 1e-12 * energy, what);
                        assertTrue(!log.limited() && log.knots() <= 256, what + ": " + log.knots() + " knots");
                    }
                }
            }
        }
    }

    /** Under the official law with its batches too; there the impulse of an impact is booked as its momentum. */
    @ParameterizedTest
    @EnumSource(value = Arithmetic.class, names = {"OFFICIAL", "DOUBLE"})
    void alsoInBatches(Arithmetic arithmetic) {
        for (Advance advance : both(ImpactLaw.OFFICIAL_POD_RACE, arithmetic, 1)) {
            Bodies bodies = onTheRim(0);
            TurnLog log = Scenes.turn(advance, bodies);
            assertEquals(300 / 490.0, Math.atan2(bodies.y[0], bodies.x[0]), 1e-6);
            double momentumX = 0;
            double momentumY = 300;
            for (int k = 0; k < log.impacts(); k++) {
                momentumX -= log.impact(k).momentumBx();
                momentumY -= log.impact(k).momentumBy();
            }
            assertEquals(momentumX, bodies.vx[0], 1e-9);
            assertEquals(momentumY, bodies.vy[0], 1e-9);
        }
    }

    /** Another body on the rim, at rest: it is met on the way, and takes all the speed. */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void itMeetsOthersOnTheWay(Arithmetic arithmetic) {
        for (Advance advance : both(Scenes.WITH_RESTITUTION, arithmetic, 1)) {
            Bodies bodies = onTheRim(0);
            Scenes.add(bodies, 490 * Math.cos(0.3), 490 * Math.sin(0.3), 0, 0, 1);
            TurnLog log = Scenes.turn(advance, bodies);
            boolean met = false;
            for (int k = 0; k < log.impacts(); k++) {
                met |= log.impact(k).a() == 0 && log.impact(k).b() == 1;
            }
            assertTrue(met && !log.limited());
            double energy = Scenes.energy(bodies);
            assertEquals(300.0 * 300 / 2, energy, 1e-9 * energy);
            assertTrue(Math.atan2(bodies.y[1], bodies.x[1]) > 0.5, "it goes round now");
        }
    }

    /**
     * A contact without restitution at an angle alpha leaves the speed times cos(alpha) along the rim. A slide keeps
     * the whole: after a turn of w radians it is ahead by w alpha^2 / 2, for the steepest one 1.5 w / 500. An elastic
     * one that bounces goes round by alpha / sin(alpha) faster: by w alpha^2 / 6 at 5,000 bounces a turn. At the end of
     * a turn a body may be in a chord, up to (w / 500)^3 / 3 ahead.
     */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void itIsAheadByWhatItsFirstContactHadAcross(Arithmetic arithmetic) {
        for (double w : new double[] {0.6, 2, 5, 20}) {
            for (double restitution : new double[] {0, 1}) {
                double alpha = restitution == 0 ? 1.49 * w / 500 : 0.99 * w / 10_000;
                double right = restitution == 0 ? w * Math.cos(alpha) : w * alpha / Math.sin(alpha);
                double bound = (restitution == 0 ? 4.5e-6 : 2e-9) * w * w * w;
                for (Advance advance : both(Scenes.WITH_RESTITUTION, arithmetic, restitution)) {
                    Bodies bodies = Scenes.bodies(
                        new double[] {490, 0, 490 * w * Math.sin(alpha), 490 * w * Math.cos(alpha)});
                    advance.turn(bodies, TurnSink.NONE);
                    double ahead = Math.IEEEremainder(Math.atan2(bodies.y[0], bodies.x[0]) - right, 2 * Math.PI);
                    assertTrue(Math.abs(ahead) <= bound + Math.pow(w / 500, 3) / 3, w + ", e " + restitution + ": "
                        + ahead);
                    assertTrue(restitution == 1 || ahead > 0.9 * bound, w + ": " + ahead);
                }
            }
        }
    }
}

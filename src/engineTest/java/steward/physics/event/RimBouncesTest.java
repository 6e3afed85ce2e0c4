package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.TurnLog;

/**
 * Elastic bounces along the rim of an arena of radius 500. A disc of radius 10 starts in the middle of a chord, at
 * 490 cos(theta) to the right, and moves upwards. Each chord has the length 2 490 sin(theta) and is the one before it,
 * turned by 2 theta: so place and number of bounces follow from the path's length alone.
 */
@Execution(ExecutionMode.CONCURRENT)
class RimBouncesTest {

    private static final double ROOM = 490;

    private static List<Advance> both(Arithmetic arithmetic, double restitution) {
        return Scenes.both(Scenes.parts(Scenes.WITH_RESTITUTION, arithmetic, new Arena(0, 0, 500, restitution)));
    }

    /** Distance of a body from its place on the chords after a path of this length. */
    private static double off(Bodies bodies, double theta, double path) {
        double half = ROOM * Math.sin(theta);
        double chords = Math.floor((path + half) / (2 * half));
        double along = path - chords * 2 * half;
        double turn = 2 * theta * chords;
        double x = ROOM * Math.cos(theta);
        return Math.hypot(bodies.x[0] - x * Math.cos(turn) + along * Math.sin(turn),
            bodies.y[0] - x * Math.sin(turn) - along * Math.cos(turn));
    }

    private static double angularMomentum(Bodies bodies) {
        return bodies.x[0] * bodies.vy[0] - bodies.y[0] * bodies.vx[0];
    }

    /**
     * An angle that rounding changes by 1e-16 / theta at each of n bounces is off by 1e-16 n^1.5 u / theta at the end.
     * From 5,000 bounces a turn on they are a slide.
     */
    @ParameterizedTest
    @CsvSource({"12250, 0.06, 208", "2450, 0.014, 179", "49000, 0.07, 715", "1960, 0.0452, 44", "4900, 0.00101, 4950",
        "10, 0.0000103, 990"})
    void anElasticBounceKeepsItsAngle(double speed, double theta, int expected) {
        for (Arithmetic arithmetic : Arithmetic.values()) {
            for (Advance advance : both(arithmetic, 1)) {
                Bodies bodies = Scenes.bodies(new double[] {ROOM * Math.cos(theta), 0, 0, speed});
                double angular = angularMomentum(bodies);
                TurnLog log = Scenes.turn(advance, bodies);
                String what = arithmetic + ", " + speed + " u a turn, " + theta + " rad";
                assertEquals(expected, log.impacts(), 1, what);
                assertEquals(angular, angularMomentum(bodies), 1e-12 * angular, what);
                assertEquals(0, off(bodies, theta, speed), 1e-16 * Math.pow(expected, 1.5) * ROOM / theta + 1e-9, what);
            }
        }
    }

    /** 1960 u a turn at an angle of 0.0452 rad: 44.28 bounces a turn, so 4428 in 100. */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void angularMomentumIsKept(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic, 1)) {
            Bodies bodies = Scenes.bodies(new double[] {489.5, 0, 0, 1960});
            double angular = angularMomentum(bodies);
            TurnLog log = new TurnLog();
            for (int turn = 0; turn < 100; turn++) {
                advance.turn(bodies, log);
            }
            assertEquals(4428, log.impacts());
            assertEquals(angular, angularMomentum(bodies), 1e-12 * angular);
        }
    }
}

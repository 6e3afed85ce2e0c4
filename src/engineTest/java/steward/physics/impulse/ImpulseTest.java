package steward.physics.impulse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.physics.event.Scenes;
import steward.physics.time.Exact;

/**
 * One impact, under every law. With u = 2^-53 and S = sum of m (|v| + |v'|), each stored momentum is rounded by at most
 * u S, so the two sides of a book agree to 8 u S; in energies likewise with Q = sum of m (|v| + |v'|)^2.
 */
class ImpulseTest {

    private static final double INFINITY = Double.POSITIVE_INFINITY;
    private static final ImpactLaw DEAD_ZONE =
        Scenes.WITH_RESTITUTION.withMinimumImpulse(30, true).withDeadZone(1e-3);
    private static final List<ImpactLaw> LAWS = List.of(ImpactLaw.PHYSICS, Scenes.WITH_RESTITUTION,
        ImpactLaw.PHYSICS.withMinimumImpulse(120, true), Scenes.WITH_RESTITUTION.withMinimumImpulse(120, true),
        DEAD_ZONE);

    /** The second step, word for word from DESIGN: max(e j1, jMin), or by magnitude above the dead zone. */
    private static double secondStep(ImpactLaw law, double first, double e) {
        double back = (law.restitution() == ImpactLaw.Restitution.ELASTIC ? 1 : e) * first;
        if (Double.isNaN(law.deadZone())) {
            return back > law.minimumImpulse() ? back : law.minimumImpulse();
        }
        return Math.abs(back) <= law.deadZone() || Math.abs(back) >= law.minimumImpulse() ? back
            : law.minimumImpulse() * Math.signum(back);
    }

    /** Two bodies that touch and approach; masses 1..10, sometimes infinite for one. */
    private static Bodies approaching(SplitMix64 random) {
        double angle = 2 * Math.PI * random.nextDouble();
        Bodies bodies = new Bodies(2);
        double speed = Math.pow(10, 6 * random.nextDouble() - 3);
        int heavy = random.nextInt(4);
        bodies.add(0, 0, 400, heavy == 0 ? INFINITY : 1 + 9 * random.nextDouble());
        bodies.add(800 * Math.cos(angle), 800 * Math.sin(angle), 400, heavy == 1 ? INFINITY : 1 + random.nextInt(10));
        double[] v = new double[4];
        do {
            for (int k = 0; k < 4; k++) {
                v[k] = speed * (2 * random.nextDouble() - 1);
            }
        } while ((v[0] - v[2]) * bodies.x[1] + (v[1] - v[3]) * bodies.y[1] <= 1e-3 * speed * 800);
        bodies.setVelocity(0, v[0], v[1]);
        bodies.setVelocity(1, v[2], v[3]);
        bodies.setRestitution(0, random.nextInt(5) == 0 ? 0 : random.nextDouble());
        bodies.setRestitution(1, random.nextDouble());
        return bodies;
    }

    @Test
    void theBooksOfRandomImpactsAgreeUnderEveryLaw() {
        for (long seed = 1; seed <= 5000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            ImpactLaw law = LAWS.get((int) (seed % LAWS.size()));
            Bodies bodies = approaching(random);
            double e = Math.min(bodies.restitution[0], bodies.restitution[1]);
            TurnLog log = new TurnLog();
            new Collision(law, new Wall[0]).react(bodies, 0, 1, 0.25, log);
            assertEquals(1, log.impacts());
            checkImpulse(law, log.impact(0), e, "seed " + seed + " " + log.impact(0));
            checkBooks(log.impact(0), "seed " + seed + " " + log.impact(0));
        }
    }

    private static void checkImpulse(ImpactLaw law, Impact impact, double e, String what) {
        double w = 1 / impact.massA() + 1 / impact.massB();
        double nx = impact.normalX();
        double ny = impact.normalY();
        double approach = (impact.vaxBefore() - impact.vbxBefore()) * nx
            + (impact.vayBefore() - impact.vbyBefore()) * ny;
        double parting = (impact.vbxAfter() - impact.vaxAfter()) * nx + (impact.vbyAfter() - impact.vayAfter()) * ny;
        double second = secondStep(law, approach / w, e);
        double speeds = speed(impact, true) + speed(impact, false);
        assertEquals(approach / w + second, impact.impulse(), 16 * Exact.ULP * speeds / w, what);
        assertEquals(second * w, parting, 16 * Exact.ULP * speeds, what + ": (wa + wb) j2 apart");
        assertEquals(w * (second * second - approach * approach / w / w) / 2, impact.energy(),
            32 * Exact.ULP * speeds * speeds / w, what);
        assertTrue((impact.bx() - impact.ax()) * (impact.vbxAfter() - impact.vaxAfter())
            + (impact.by() - impact.ay()) * (impact.vbyAfter() - impact.vayAfter()) >= 0, what + ": still approaching");
        assertEquals(1, Math.hypot(nx, ny), 4 * Exact.ULP, what);
    }

    private static double speed(Impact impact, boolean a) {
        return a ? Math.hypot(impact.vaxBefore(), impact.vayBefore()) + Math.hypot(impact.vaxAfter(), impact.vayAfter())
            : Math.hypot(impact.vbxBefore(), impact.vbyBefore()) + Math.hypot(impact.vbxAfter(), impact.vbyAfter());
    }

    /**
     * The sides of the momentum sum to 0. The energy is what the finite masses gained, and what the impulse worked on
     * an infinite mass that moves: j n.v of it.
     */
    private static void checkBooks(Impact i, String what) {
        double finiteA = i.massA() < INFINITY ? i.massA() : 0;
        double finiteB = i.massB() < INFINITY ? i.massB() : 0;
        double sum = (finiteA + finiteB) * (speed(i, true) + speed(i, false)) + Math.abs(i.impulse());
        assertEquals(0, i.momentumAx() + i.momentumBx(), 8 * Exact.ULP * sum, what);
        assertEquals(0, i.momentumAy() + i.momentumBy(), 8 * Exact.ULP * sum, what);
        double gained = finiteA * (square(i.vaxAfter(), i.vayAfter()) - square(i.vaxBefore(), i.vayBefore())) / 2
            + finiteB * (square(i.vbxAfter(), i.vbyAfter()) - square(i.vbxBefore(), i.vbyBefore())) / 2;
        if (finiteA == 0) {
            assertEquals(i.vaxBefore(), i.vaxAfter(), what);
            assertEquals(i.vayBefore(), i.vayAfter(), what);
            gained += i.momentumAx() * i.vaxBefore() + i.momentumAy() * i.vayBefore();
        }
        if (finiteB == 0) {
            assertEquals(i.vbxBefore(), i.vbxAfter(), what);
            assertEquals(i.vbyBefore(), i.vbyAfter(), what);
            gained += i.momentumBx() * i.vbxBefore() + i.momentumBy() * i.vbyBefore();
        }
        assertEquals(gained, i.energy(), 16 * Exact.ULP * sum * (speed(i, true) + speed(i, false)), what);
    }

    private static double square(double x, double y) {
        return x * x + y * y;
    }

    /** Elastic: 2 u ma mb / (ma + mb); 600 u per turn, 1 against 10: 1090.909... */
    @Test
    void thePerfectlyElasticImpulse() {
        Impact impact = headOn(ImpactLaw.PHYSICS, 600, 1, 10, 1);
        assertEquals(2 * 600 * 10 / 11.0, impact.impulse(), 1e-12);
        assertEquals(0, impact.energy());
        assertEquals(-600 * 9 / 11.0, impact.vaxAfter(), 1e-12, "u (ma - mb) / (ma + mb)");
        assertEquals(600 * 2 / 11.0, impact.vbxAfter(), 1e-12, "u 2 ma / (ma + mb)");
    }

    /** j1 = 100 / 2 = 50 stops it; 120 comes on top of it to both sides: -70 and +170 - and energy 120^2 - 50^2. */
    @Test
    void theMinimumImpulseReachesBothSides() {
        Impact impact = headOn(ImpactLaw.PHYSICS.withMinimumImpulse(120, false), 100, 1, 1, 1);
        assertEquals(170, impact.impulse());
        assertEquals(-70, impact.vaxAfter());
        assertEquals(170, impact.vbxAfter());
        assertEquals(120 * 120 - 50 * 50, impact.energy());
        assertEquals(-170, impact.momentumAx());
        assertEquals(170, impact.momentumBx());
    }

    /** j1 = 300 / 2 = 150 and e j1 = 135 is more than 120: the minimum adds nothing. */
    @Test
    void aStrongImpactNeedsNoMinimum() {
        Impact impact = headOn(Scenes.WITH_RESTITUTION.withMinimumImpulse(120, false), 300, 1, 1, 0.9);
        assertEquals(150 + 135, impact.impulse(), 1e-12);
        assertEquals(135 * 135 - 150 * 150, impact.energy(), 1e-9);
    }

    /** Mean Max: below the dead zone nothing is raised, between it and the minimum everything is, above nothing. */
    @Test
    void theDeadZoneLeavesTheWeakestImpactsAlone() {
        ImpactLaw law = Scenes.WITH_RESTITUTION.withMinimumImpulse(30, false).withDeadZone(2);
        assertEquals(2 + 1, headOn(law, 4, 1, 1, 0.5).impulse(), "e j1 = 1 is in the zone");
        assertEquals(4 + 2, headOn(law, 8, 1, 1, 0.5).impulse(), "e j1 = 2 is at its edge");
        assertEquals(6 + 30, headOn(law, 12, 1, 1, 0.5).impulse(), "e j1 = 3 is raised");
        assertEquals(70 + 35, headOn(law, 140, 1, 1, 0.5).impulse(), "e j1 = 35 is enough");
        Impulse weak = Impulse.of(law, true);
        assertEquals(-30, weak.secondStep(-6, 0.5), "the sign stays");
        assertEquals(-1, weak.secondStep(-2, 0.5));
    }

    /** Against an infinite mass the whole approach comes back: j = 2 m u = 2 * 3 * 50. */
    @Test
    void anInfiniteMassIsNotMoved() {
        Impact onRock = headOn(ImpactLaw.PHYSICS, 50, 3, INFINITY, 1);
        assertEquals(300, onRock.impulse());
        assertEquals(-50, onRock.vaxAfter());
        assertEquals(0, onRock.vbxAfter());
        assertEquals(-300, onRock.momentumAx());
        assertEquals(300, onRock.momentumBx());
        Impact byRock = headOn(ImpactLaw.PHYSICS, 50, INFINITY, 3, 1);
        assertEquals(50, byRock.vaxAfter());
        assertEquals(100, byRock.vbxAfter());
        assertEquals(-300, byRock.momentumAx());
        assertEquals(0, byRock.energy());
    }

    private static Impact headOn(ImpactLaw law, double speed, double massA, double massB, double e) {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, speed, 0, massA}, {20, 0, 0, 0, massB}});
        bodies.setRestitution(0, e);
        TurnLog log = new TurnLog();
        new Collision(law, new Wall[0]).react(bodies, 0, 1, 0, log);
        return log.impact(0);
    }

    /** Mass 2 at (30, -40) into a floor with e = 0.5: j1 = 80, j2 = 40, energy (40^2 - 80^2) / 2 / 2. */
    @Test
    void aWallTakesTheLowerRestitutionAndNoMinimumUnlessTold() {
        Bodies bodies = Scenes.bodies(new double[] {5, 10, 30, -40, 2});
        bodies.setRestitution(0, 0.75);
        TurnLog log = new TurnLog();
        Wall[] floor = {new HalfPlane(0, 0, 0, 1, 0.5)};
        new Collision(Scenes.WITH_RESTITUTION.withMinimumImpulse(120, false), floor).react(bodies, 0, ~0, 0.5, log);
        assertEquals(new Impact(0.5, 0, ~0, 5, 10, 5, 0, -0.0, -1, 120, -1200, 2, INFINITY, 30, -40, 30, 20,
            0, 0, 0, 0), log.impact(0));
        assertTrue(log.impact(0).isWall());
        assertEquals(0, log.impact(0).wall());
        bodies.setVelocity(0, 30, -40);
        new Collision(Scenes.WITH_RESTITUTION.withMinimumImpulse(120, true), floor).react(bodies, 0, ~0, 0.5, log);
        assertEquals(80 + 120, log.impact(1).impulse());
        assertEquals(60, bodies.vy[0]);
    }

    /** Centres that coincide part along x instead of dividing by 0. */
    @Test
    void coincidingCentresPartAlongX() {
        Bodies bodies = Scenes.bodies(new double[][] {{7, 7, 10, 0}, {7, 7, -10, 0}});
        TurnLog log = new TurnLog();
        new Collision(ImpactLaw.PHYSICS, new Wall[0]).react(bodies, 0, 1, 0, log);
        assertEquals(1, log.impact(0).normalX());
        assertEquals(-10, bodies.vx[0]);
        assertEquals(10, bodies.vx[1]);
    }
}

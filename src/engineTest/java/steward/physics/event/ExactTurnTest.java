package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** Whole turns in exact arithmetic: what is stored is what decimals say, rounded once. */
@Execution(ExecutionMode.CONCURRENT)
class ExactTurnTest {

    private static final MathContext DIGITS = new MathContext(70);

    private static EventAdvance exact(ImpactLaw law, Wall... walls) {
        return new EventAdvance(Scenes.parts(law, Arithmetic.EXACT, walls));
    }

    private static BigDecimal of(double value) {
        return new BigDecimal(value);
    }

    /** Two that meet in the turn, anywhere on their front, now and then grazing to the last digits. */
    private static Bodies meeting(SplitMix64 random) {
        Bodies bodies = new Bodies(2);
        double angle = 2 * Math.PI * random.nextDouble();
        double off = random.nextInt(4) == 0 ? 800 * (1 - Math.pow(10, -15 * random.nextDouble()))
            : 790 * random.nextDouble();
        double far = 900 + 3000 * random.nextDouble();
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double x = 16000 * random.nextDouble();
        double y = 9000 * random.nextDouble();
        bodies.add(x, y, 400, 1 + random.nextInt(9) * random.nextDouble());
        bodies.add(x + far * cos - off * sin, y + far * sin + off * cos, 400, random.nextInt(3) == 0 ? 10 : 1);
        bodies.setVelocity(0, far * 1.5 * cos, far * 1.5 * sin);
        bodies.setRestitution(0, random.nextDouble());
        return bodies;
    }

    /** The impact of two bodies in 70 digits: positions at the touch and velocities after it, by the textbook. */
    private static BigDecimal[] byHand(Bodies s, double e) {
        BigDecimal dx = of(s.x[1]).subtract(of(s.x[0]));
        BigDecimal dy = of(s.y[1]).subtract(of(s.y[0]));
        BigDecimal vx = of(s.vx[0]).subtract(of(s.vx[1]));
        BigDecimal vy = of(s.vy[0]).subtract(of(s.vy[1]));
        BigDecimal a = vx.pow(2).add(vy.pow(2));
        BigDecimal b = dx.multiply(vx).add(dy.multiply(vy));
        BigDecimal c = dx.pow(2).add(dy.pow(2)).subtract(of(s.radius[0]).add(of(s.radius[1])).pow(2));
        BigDecimal room = b.pow(2).subtract(a.multiply(c));
        if (room.signum() <= 0) {
            return null;
        }
        BigDecimal t = b.subtract(room.sqrt(DIGITS)).divide(a, DIGITS);
        BigDecimal ax = of(s.x[0]).add(of(s.vx[0]).multiply(t));
        BigDecimal ay = of(s.y[0]).add(of(s.vy[0]).multiply(t));
        BigDecimal nx = of(s.x[1]).add(of(s.vx[1]).multiply(t)).subtract(ax);
        BigDecimal ny = of(s.y[1]).add(of(s.vy[1]).multiply(t)).subtract(ay);
        BigDecimal squared = nx.pow(2).add(ny.pow(2));
        BigDecimal w = BigDecimal.ONE.divide(of(s.mass[0]), DIGITS).add(BigDecimal.ONE.divide(of(s.mass[1]), DIGITS));
        BigDecimal share = nx.multiply(vx).add(ny.multiply(vy)).divide(squared.multiply(w), DIGITS)
            .multiply(BigDecimal.ONE.add(of(e)));
        return new BigDecimal[] {t, ax, ay,
            of(s.vx[0]).subtract(share.multiply(nx).divide(of(s.mass[0]), DIGITS)),
            of(s.vy[0]).subtract(share.multiply(ny).divide(of(s.mass[0]), DIGITS)),
            of(s.vx[1]).add(share.multiply(nx).divide(of(s.mass[1]), DIGITS)),
            of(s.vy[1]).add(share.multiply(ny).divide(of(s.mass[1]), DIGITS)),
            share.multiply(squared.sqrt(DIGITS))};
    }

    @Test
    @Tag("sized")
    void timePositionsVelocitiesAndImpulseAreRoundedOnce() {
        int cases = TestSize.of(500, 3000);
        int hits = 0;
        double worst = 0;
        for (long seed = 1; seed <= cases; seed++) {
            Bodies bodies = meeting(new SplitMix64(seed));
            boolean elastic = seed % 2 == 0;
            BigDecimal[] expected = byHand(bodies, elastic ? 1 : bodies.restitution[0]);
            TurnLog log = Scenes.turn(exact(elastic ? ImpactLaw.PHYSICS : Scenes.WITH_RESTITUTION), bodies);
            assertEquals(expected == null ? 0 : 1, log.impacts(), "seed " + seed);
            if (expected != null) {
                Impact i = log.impact(0);
                double[] found = {i.time(), i.ax(), i.ay(), i.vaxAfter(), i.vayAfter(), i.vbxAfter(), i.vbyAfter(),
                    i.impulse()};
                for (int k = 0; k < found.length; k++) {
                    double ulp = Math.ulp(expected[k].doubleValue());
                    double error = of(found[k]).subtract(expected[k]).divide(of(ulp), DIGITS).abs().doubleValue();
                    assertTrue(error <= 0.51, "seed " + seed + " quantity " + k + ": " + error + " ulp");
                    worst = Math.max(worst, error);
                }
                hits++;
            }
        }
        assertTrue(hits > 0.8 * cases && worst > 0.49, hits + " hits, worst " + worst);
    }

    /** A body above a tilted floor, a segment's side and end, inside an arena: the time by 70 digits. */
    @Test
    @Tag("sized")
    void timesAtWallsAreRoundedOnce() {
        for (long seed = 1; seed <= TestSize.of(300, 1000); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double angle = 2 * Math.PI * random.nextDouble();
            double nx = Math.cos(angle);
            double ny = Math.sin(angle);
            double x = 5000 * random.nextDouble();
            double y = 5000 * random.nextDouble();
            double vx = -3000 * nx + 500 * random.nextDouble();
            double vy = -3000 * ny + 500 * random.nextDouble();
            double high = 500 + 1000 * random.nextDouble();
            HalfPlane floor = new HalfPlane(x - high * nx, y - high * ny, nx, ny, 1);
            BigDecimal gap = of(x).subtract(of(floor.x())).multiply(of(floor.insideX()))
                .add(of(y).subtract(of(floor.y())).multiply(of(floor.insideY()))).subtract(of(400));
            BigDecimal closing = of(vx).multiply(of(floor.insideX())).add(of(vy).multiply(of(floor.insideY())))
                .negate();
            check(floor, x, y, vx, vy, gap.divide(closing, DIGITS), "floor, seed " + seed);

            Arena arena = new Arena(x + 300 * ny, y, 2500, 1);
            BigDecimal dx = of(x).subtract(of(arena.x()));
            BigDecimal b = dx.multiply(of(vx));
            BigDecimal a = of(vx).pow(2).add(of(vy).pow(2));
            BigDecimal c = dx.pow(2).subtract(of(2100).pow(2));
            check(arena, x, y, vx, vy, b.pow(2).subtract(a.multiply(c)).sqrt(DIGITS).subtract(b).divide(a, DIGITS),
                "arena, seed " + seed);

            double ex = floor.x() - 2000 * ny;
            double ey = floor.y() + 2000 * nx;
            Segment segment = new Segment(ex, ey, floor.x() + 2000 * ny, floor.y() - 2000 * nx, 1);
            BigDecimal bx = of(segment.bx()).subtract(of(ex));
            BigDecimal by = of(segment.by()).subtract(of(ey));
            BigDecimal length = bx.pow(2).add(by.pow(2)).sqrt(DIGITS);
            BigDecimal side = bx.multiply(of(y).subtract(of(ey))).subtract(by.multiply(of(x).subtract(of(ex))));
            BigDecimal rise = bx.multiply(of(vy)).subtract(by.multiply(of(vx)));
            check(segment, x, y, vx, vy, side.abs().subtract(length.multiply(of(400))).divide(rise.abs(), DIGITS),
                "segment, seed " + seed);
        }
    }

    private static void check(Wall wall, double x, double y, double vx, double vy, BigDecimal expected, String what) {
        Bodies bodies = Scenes.bodies(new double[][] {{x, y, vx, vy, 3, 400}});
        TurnLog log = Scenes.turn(exact(ImpactLaw.PHYSICS, wall), bodies);
        assertTrue(log.impacts() > 0, what);
        double ulp = Math.ulp(expected.doubleValue());
        double error = of(log.impact(0).time()).subtract(expected).divide(of(ulp), DIGITS).abs().doubleValue();
        assertTrue(error <= 0.51, what + ": " + error + " ulp of " + expected);
        assertEquals(Math.hypot(vx, vy), Math.hypot(bodies.vx[0], bodies.vy[0]), 1e-12);
    }

    /** A body flies at 45 degrees into the open end of a segment: the tangent misses, one digit nearer hits. */
    @Test
    void anEndIsGrazedExactly() {
        for (double y : new double[] {20, Math.nextDown(20.0), Math.nextUp(20.0)}) {
            Bodies bodies = Scenes.bodies(new double[][] {{-50, y, 100, 0, 1, 20}});
            TurnLog log = Scenes.turn(exact(ImpactLaw.PHYSICS, new Segment(0, 0, 0, -100, 1)), bodies);
            assertEquals(y < 20 ? 1 : 0, log.impacts(), "at a height of " + y);
        }
    }

    /** Crowds with walls, sticky and elastic: as the plain arithmetic, but never through anything nor without end. */
    @Test
    void crowdsNeitherOverlapNorHangAndKeepTheirEnergy() {
        int impacts = 0;
        for (long seed = 1; seed <= 20; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Wall[] walls = seed % 2 == 0 ? Wall.box(1000, 1000, 1)
                : new Wall[] {new Arena(500, 500, 800, 1), new Segment(100, 500, 300, 510, 1)};
            Bodies bodies = Scenes.grid(random, 3, 1000, 100, 800);
            bodies.setMass(4, seed % 3 == 0 ? Double.POSITIVE_INFINITY : 1e-3);
            bodies.setVelocity(4, 0, 0);
            if (seed % 2 == 1) {
                bodies.setPosition(3, 200, 700);
            }
            double energy = Scenes.energy(bodies);
            EventAdvance advance = exact(Scenes.WITH_RESTITUTION, walls);
            for (int turn = 0; turn < 10; turn++) {
                TurnLog log = Scenes.turn(advance, bodies);
                impacts += log.impacts();
                assertFalse(log.limited(), "seed " + seed + " turn " + turn);
                assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-9, "seed " + seed + " turn " + turn);
            }
            assertEquals(energy, Scenes.energy(bodies), 1e-13 * energy, "seed " + seed);
        }
        assertTrue(impacts > 2000, impacts + " impacts");
    }

    @Test
    @Tag("sized")
    void inelasticImpactsEndTheApproachForGood() {
        for (long seed = 1; seed <= TestSize.of(150, 500); seed++) {
            Bodies bodies = meeting(new SplitMix64(seed));
            bodies.setRestitution(0, 0);
            TurnLog log = Scenes.turn(exact(Scenes.WITH_RESTITUTION), bodies);
            assertTrue(log.impacts() <= 1, "seed " + seed + ": " + log.impacts());
            Bodies sliding = Scenes.bodies(new double[][] {{1000, 1000, 3000 - seed, -4000, 1, 400}});
            sliding.setRestitution(0, 0);
            log.clear();
            Wall floor = new HalfPlane(0, -seed, -0.6, 0.8, 1);
            exact(Scenes.WITH_RESTITUTION, floor).turn(sliding, log);
            assertTrue(log.impacts() >= 1 && log.impacts() < 5, "seed " + seed + ": " + log.impacts());
        }
    }

    /** The official law too: the same impacts as in the official arithmetic, to its accuracy, push-outs included. */
    @Test
    @Tag("sized")
    void theOfficialLawGoesThroughTheSameImpacts() {
        EventAdvance official = new EventAdvance(
            new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL));
        EventAdvance exact = new EventAdvance(new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.EXACT));
        int same = 0;
        int pushed = 0;
        int turns = TestSize.of(150, 500);
        for (long seed = 1; seed <= turns; seed++) {
            Bodies bodies = Scenes.grid(new SplitMix64(seed), 2, 4000, 400, 900);
            Bodies twin = bodies.copy();
            TurnLog a = Scenes.turn(official, bodies);
            TurnLog b = Scenes.turn(exact, twin);
            boolean alike = a.impacts() == b.impacts() && a.knots() >= b.knots();
            for (int k = 0; alike && k < a.impacts(); k++) {
                alike = Math.abs(a.impact(k).time() - b.impact(k).time()) < 1e-9;
            }
            same += alike ? 1 : 0;
            pushed += b.knots() == 4 * b.impacts() ? 1 : 0;
        }
        assertTrue(same > 0.9 * turns, same + " of " + turns + " alike");
        assertTrue(pushed > 0.9 * turns, "whoever impacts at the touching distance touches: "
            + pushed + " of " + turns);
    }

    /**
     * <pre>
     *             1 (10, 2e-9)      the touch with 1 is at 1/2 + 6e-20, with 2 at 1/2 + 2e-20: the same double,
     *     0 -->   2 (10, 1e-9)      and the lower pair would be 0, 1
     * </pre>
     */
    @Test
    void whoIsNearerByLessThanADoubleCanSayIsFirst() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 16, 0, 1, 1}, {10, 2e-9, 0, 0, 1, 1},
            {10, 1e-9, 0, 0, 1, 1}});
        TurnLog log = Scenes.turn(exact(ImpactLaw.PHYSICS), bodies);
        assertEquals(0, log.impact(0).a());
        assertEquals(2, log.impact(0).b());
        assertEquals(0.5, log.impact(0).time());
    }
}

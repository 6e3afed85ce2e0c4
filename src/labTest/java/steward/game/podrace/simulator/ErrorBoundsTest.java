package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.podrace.Headings;
import steward.game.podrace.PodRaceSettings;
import steward.match.TestSize;
import steward.numerics.SineCosine;
import steward.numerics.SplitMix64;
import steward.physics.event.FarPairs;

/**
 * The bounds that the fast turn's proofs state, measured in 70 digits where they are closest: how far a certified
 * vector is from the true direction and from the game's, how far both ways to see a turn by 18 degrees differ, how far
 * a certified speed and place are from the game's, and that whoever is set aside stays out of reach. The figures seen
 * are printed.
 */
@Execution(ExecutionMode.CONCURRENT)
class ErrorBoundsTest {

    private static final long SEED = Long.getLong("steward.seed", 41);
    private static final double TOUCH = 800;
    /** Rest of its DOUBT that {@link PodTurn} leaves for speeds and places that come from certified vectors. */
    private static final double SPEED_ERROR = 0x1p-27;
    /** Bound on the difference of both ways to see an angle, see {@link Headings}. */
    private static final double ANGLE_ERROR = 0x1p-36;

    private final SplitMix64 random = new SplitMix64(SEED);
    private final Headings headings = new Headings();
    private final double[] heading = new double[Headings.NUMBERS];

    /** Chains of 40 turns, to one side and to both, from the largest angles that have a vector and from targets. */
    @Test
    @Tag("sized")
    void vectorsAreKnownAsWellAsIsSaid(TestReporter report) {
        double worst = 0;
        double worstSpeed = 0;
        int longest = 0;
        for (int trial = 0; trial < TestSize.of(100, 300); trial++) {
            begin(trial % 3);
            boolean oneSide = trial % 2 == 0;
            for (int turn = 0; turn < 40; turn++) {
                turnAside(oneSide ? 1 : random.nextInt(2) * 2 - 1);
                longest = Math.max(longest, 63 - Long.numberOfLeadingZeros((long) heading[Headings.CHAIN]));
                if (turn % 13 == 0 || turn == 39) {
                    double[] vector = {heading[Headings.X], heading[Headings.Y]};
                    double[] game = game(Headings.angle(heading, 0));
                    worst = Math.max(worst, ManyDigits.apart(exact(vector),
                        ManyDigits.direction(Headings.angle(heading, 0))));
                    worst = Math.max(worst, ManyDigits.apart(exact(vector), exact(game)));
                    worstSpeed = Math.max(worstSpeed, speedError(vector, game));
                }
            }
        }
        report.publishEntry("seed " + SEED + ": vectors are off by at most " + Double.toHexString(worst)
            + ", speeds and places by " + Double.toHexString(worstSpeed));
        assertEquals(40, longest, "the longest chain");
        assertTrue(worst > 0 && worst < Headings.VECTOR_ERROR, () -> "vectors");
        assertTrue(worstSpeed > 0 && worstSpeed < SPEED_ERROR, () -> "speeds");
    }

    private void begin(int kind) {
        double angle = switch (kind) {
            case 0 -> Math.nextDown(512.0) * (random.nextInt(2) * 2 - 1);
            case 1 -> (random.nextDouble() - 0.5) * 1023;
            default -> 1;
        };
        headings.set(heading, 0, angle);
        if (kind == 2) {
            headings.turnTo(heading, 0, StrictMath.cos(1.2) * 3001, StrictMath.sin(1.2) * 3001);
            assertEquals(StrictMath.cos(1.2) * 3001, heading[Headings.BASE_X], "straight to the target");
        }
    }

    /** Asks for a turn by 18 degrees, or for a target well beyond. */
    private void turnAside(int side) {
        if (random.nextInt(2) == 0) {
            headings.turnBy(heading, 0, 18 * side);
            return;
        }
        double hx = heading[Headings.X];
        double hy = heading[Headings.Y];
        headings.turnTo(heading, 0, 1000 * (hx - 2 * side * hy), 1000 * (hy + 2 * side * hx));
    }

    /** As the game computes it. */
    private static double[] game(double angle) {
        SineCosine direction = new SineCosine();
        direction.turn(angle);
        double cos = direction.cos();
        double sin = direction.sin();
        double length = Math.sqrt(cos * cos + sin * sin);
        return new double[] {cos / length, sin / length};
    }

    private static BigDecimal[] exact(double[] vector) {
        return new BigDecimal[] {new BigDecimal(vector[0]), new BigDecimal(vector[1])};
    }

    /** With a boost, at the greatest speed and place that are steered so. */
    private double speedError(double[] vector, double[] game) {
        double worst = 0;
        for (int k = 0; k < 2; k++) {
            double place = (random.nextDouble() - 0.5) * 2 * PodTurn.SMALL;
            double speed = (random.nextDouble() - 0.5) * 2 * PodTurn.SMALL;
            double certified = speed + vector[k] * PodRaceSettings.BOOST_THRUST;
            double games = speed + game[k] * PodRaceSettings.BOOST_THRUST;
            worst = Math.max(worst, Math.abs(certified - games));
            worst = Math.max(worst, Math.abs(certified * PodTurn.KEEP - games * PodTurn.KEEP));
            worst = Math.max(worst, Math.abs(place + certified + 0.5 - (place + games + 0.5)));
        }
        return worst;
    }

    /** The angle that the game sees to a target, and the true one between its heading and the target. */
    @Test
    @Tag("sized")
    void bothWaysToSeeATurnAgreeAsIsSaid(TestReporter report) {
        int trials = TestSize.of(300, 2_000);
        double worst = 0;
        for (int trial = 0; trial < trials; trial++) {
            double angle = (random.nextDouble() - 0.5) * 2 * (trial % 2 == 0 ? 525 : 4);
            double target = angle + (trial % 3 == 0 ? Headings.MAXIMUM_TURN * (1 + random.nextInt(-3, 3) * 1e-9)
                : random.nextDouble() * 2 * Math.PI);
            double dx = 5000 * StrictMath.cos(target);
            double dy = 5000 * StrictMath.sin(target);
            double delta = (StrictMath.atan2(dy, dx) - angle) % (2 * Math.PI);
            double shortest = 2 * delta % (2 * Math.PI) - delta;
            BigDecimal[] h = ManyDigits.direction(angle);
            BigDecimal x = new BigDecimal(dx);
            BigDecimal y = new BigDecimal(dy);
            BigDecimal length = ManyDigits.length(x, y);
            BigDecimal[] truth = {h[0].multiply(x).add(h[1].multiply(y)).divide(length, ManyDigits.DIGITS),
                h[0].multiply(y).subtract(h[1].multiply(x)).divide(length, ManyDigits.DIGITS)};
            worst = Math.max(worst, ManyDigits.apart(truth, ManyDigits.direction(shortest)));
        }
        report.publishEntry("seed " + SEED + ": the angles seen differ by at most " + Double.toHexString(worst));
        assertTrue(worst > 0 && worst < ANGLE_ERROR, () -> "angles");
    }

    /** On and around the very doubts at which vectors leave the decision to angles. */
    @Test
    @Tag("sized")
    void whatVectorsDecideIsWhatTheGameDecides() {
        int byVectors = 0;
        int trials = TestSize.of(60_000, 300_000);
        for (int trial = 0; trial < trials; trial++) {
            double angle = (random.nextDouble() - 0.5) * 2 * (trial % 2 == 0 ? 511 : 4);
            double aside = trial % 4 < 2 ? Headings.MAXIMUM_TURN : Math.PI;
            // A cosine moves by DOUBT when the angle moves by DOUBT / sin; a sine near 180 degrees moves as the angle.
            double doubt = trial % 4 < 2 ? Headings.DOUBT / Headings.SINE : Headings.DOUBT;
            double target = angle + (aside + doubt * 2 * (random.nextDouble() - 0.5)
                * Math.scalb(1, random.nextInt(-3, 2))) * (trial % 8 < 4 ? 1 : -1);
            double dx = 1e6 * StrictMath.cos(target);
            double dy = 1e6 * StrictMath.sin(target);
            headings.set(heading, 0, angle);
            headings.turnTo(heading, 0, dx, dy);
            byVectors += Double.isNaN(heading[Headings.BASE_Y]) && heading[Headings.CHAIN] == 1 ? 0 : 1;
            assertEquals(Headings.turned(angle, StrictMath.atan2(dy, dx)), Headings.angle(heading, 0),
                () -> "from " + angle + " to " + dx + " " + dy);
        }
        assertTrue(byVectors > trials / 6 && byVectors < trials / 2, byVectors + " were decided by vectors");
    }

    /** A place flown in 250 legs is that flown at once, but for less than what {@link PodTurn} allows. */
    @Test
    @Tag("sized")
    void legsAreAsNearToTheWholeWayAsIsSaid(TestReporter report) {
        double worst = 0;
        for (int trial = 0; trial < TestSize.of(4000, 20_000); trial++) {
            double start = (random.nextDouble() - 0.5) * 2 * PodTurn.SMALL;
            double speed = (random.nextDouble() - 0.5) * 2 * PodTurn.SMALL / PodTurn.KEEP;
            double place = start;
            double now = 0;
            for (int leg = 0; leg < 250; leg++) {
                double next = now + (1 - now) * random.nextDouble() / 60;
                place += speed * (next - now);
                now = next;
            }
            place += speed * (1 - now);
            worst = Math.max(worst, new BigDecimal(start).add(new BigDecimal(speed)).subtract(new BigDecimal(place))
                .abs().doubleValue());
        }
        report.publishEntry("seed " + SEED + ": places in 251 legs are off by at most " + Double.toHexString(worst));
        assertTrue(worst > 0 && worst < SPEED_ERROR, () -> "places");
    }

    /**
     * Pairs that pass, or end the turn, on the very margin of the filter: whoever is set aside stays farther away than
     * nine tenths of the margin in truth, and has no impact by the official expressions, also with velocities that are
     * off by 2^-26.
     */
    @Test
    @Tag("sized")
    void whoIsSetAsideStaysOutOfReach() {
        int aside = 0;
        for (int trial = 0; trial < TestSize.of(8000, 40_000); trial++) {
            double far = trial % 3 == 0 ? Math.scalb(1, random.nextInt(10, 40)) : 2000 + random.nextInt(30_000);
            double margin = 1 + 0x1p-40 * far * far;
            double least = Math.sqrt(TOUCH * TOUCH + margin * (1 + random.nextInt(-8, 8) * Math.scalb(1, -trial % 30)));
            double angle = random.nextDouble() * 7;
            double wx = far * StrictMath.cos(angle) * (1 + random.nextInt(2));
            double wy = far * StrictMath.sin(angle) * (1 + random.nextInt(2));
            double speed = Math.sqrt(wx * wx + wy * wy);
            boolean passing = trial % 2 == 0;
            double beside = passing ? least : least * random.nextDouble();
            double ahead = passing ? speed * random.nextDouble() : speed + Math.sqrt(least * least - beside * beside);
            double dx = -wx / speed * ahead - wy / speed * beside;
            double dy = -wy / speed * ahead + wx / speed * beside;
            if (!FarPairs.mayMeet(dx, dy, wx, wy, 1, TOUCH * TOUCH)) {
                aside++;
                double reserve = reserve(dx, dy, wx, wy);
                double of = 1 + 0x1p-40 * (dx * dx + dy * dy);
                assertTrue(reserve >= 0.9 * of, () -> reserve + " of " + of);
                assertTrue(!PodTurnTest.meets(dx, dy, wx, wy), "an impact");
                if (Math.max(Math.abs(dx), Math.abs(dy)) < 0x1p17) {
                    assertTrue(!PodTurnTest.meets(dx, dy, wx + error(), wy + error()), "an impact nearby");
                }
            }
        }
        assertTrue(aside > TestSize.of(2000, 10_000) && aside < TestSize.of(7000, 35_000), aside + " set aside");
    }

    private double error() {
        return (random.nextInt(2) * 2 - 1) * 0x1p-26;
    }

    /** The least of |d + w t|^2 on 0..1, less the square of the touching distance. */
    private static double reserve(double dx, double dy, double wx, double wy) {
        BigDecimal x = new BigDecimal(dx);
        BigDecimal y = new BigDecimal(dy);
        BigDecimal vx = new BigDecimal(wx);
        BigDecimal vy = new BigDecimal(wy);
        BigDecimal a = vx.multiply(vx).add(vy.multiply(vy));
        BigDecimal b = x.multiply(vx).add(y.multiply(vy));
        BigDecimal time = b.negate().divide(a, ManyDigits.DIGITS).max(BigDecimal.ZERO).min(BigDecimal.ONE);
        BigDecimal nearX = x.add(vx.multiply(time));
        BigDecimal nearY = y.add(vy.multiply(time));
        return nearX.multiply(nearX).add(nearY.multiply(nearY)).subtract(new BigDecimal(TOUCH * TOUCH)).doubleValue();
    }
}

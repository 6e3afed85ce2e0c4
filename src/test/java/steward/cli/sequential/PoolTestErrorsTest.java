package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.contest.Contest;
import steward.contest.PairedPlay.Outcome;
import steward.contest.PairedPlay.Seed;
import steward.league.sequential.Gsprt;
import steward.league.sequential.StoppedRange;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/**
 * Errors of a test against a pool, of made-up games: three opponents of different strength, seeds that favour both
 * tested bots or neither, sides of which one is better, and a new bot that in half of its games does as the base does.
 * {@code ./gradlew campaigns --tests '*PoolTestErrorsTest' -Psteward.games=20000}.
 */
@Execution(ExecutionMode.CONCURRENT)
class PoolTestErrorsTest {

    private static final int TESTS = Integer.getInteger("steward.games", TestSize.of(400, 5000));
    private static final double ALPHA = 0.05;
    private static final double BETA = 0.1;
    private static final double POINTS = 0.1;
    private static final double[] CHANCES = {0.3, 0.5, 0.65};
    private static final double SEED_EFFECT = 0.12;
    private static final double SIDE_EFFECT = 0.1;
    private static final long FIRST = 72;

    /** Share of tests that accepted H1, and whose range had the truth. */
    private record Errors(double accepted, double held) { }

    private static Errors errors(double ahead) {
        Gsprt test = Gsprt.ofScores(0.5, (1 + POINTS) / 2, ALPHA, BETA);
        Contest contest = PoolScoresTest.contest(2);
        long[] sums = LongStream.range(0, TESTS).mapToObj(number -> {
            SplitMix64 random = new SplitMix64(FIRST + number);
            PoolScores pool = new PoolScores(contest, List.of("a", "b", "c"), true);
            for (int seed = 0; test.state(pool.scores()) == Gsprt.State.OPEN; seed++) {
                pool.add(seed % CHANCES.length, seed(random, CHANCES[seed % CHANCES.length], ahead));
            }
            StoppedRange range = test.range(pool.scores());
            double score = (1 + ahead) / 2;
            return new long[] {test.state(pool.scores()) == Gsprt.State.H1 ? 1 : 0,
                range.scoreLow() <= score && score <= range.scoreHigh() ? 1 : 0};
        }).reduce((one, other) -> new long[] {one[0] + other[0], one[1] + other[1]}).orElseThrow();
        return new Errors((double) sums[0] / TESTS, (double) sums[1] / TESTS);
    }

    /** The games of a seed: two of the new bot, whose chance to win is more by so much, then two of the base. */
    private static Seed seed(SplitMix64 random, double chance, double ahead) {
        double ofSeed = chance + (random.nextDouble() < 0.5 ? SEED_EFFECT : -SEED_EFFECT);
        Outcome[] games = new Outcome[4];
        for (int side = 0; side < 2; side++) {
            double ofSide = ofSeed + (side == 0 ? SIDE_EFFECT : -SIDE_EFFECT);
            double base = random.nextDouble();
            double other = random.nextDouble() < 0.5 ? base : random.nextDouble();
            games[side] = PoolScoresTest.game(other < ofSide + ahead, side);
            games[2 + side] = PoolScoresTest.game(base < ofSide, side);
        }
        return new Seed(1, games);
    }

    private static double deviations(double share) {
        return 3 * Math.sqrt(share * (1 - share) / TESTS);
    }

    @Test
    @Tag("sized")
    @Tag("slow")
    void errorRatesAndRangesAreThoseThatWereAskedFor(TestReporter report) {
        Errors zero = errors(0);
        Errors one = errors(POINTS);
        Errors between = errors(POINTS / 2);
        report.publishEntry(String.format(Locale.ROOT, "%,d tests: H1 accepted at H0 %.4f, H0 accepted at H1 %.4f; "
            + "truth in the range %.3f at H0, %.3f between, %.3f at H1", TESTS, zero.accepted(), 1 - one.accepted(),
            zero.held(), between.held(), one.held()));
        assertTrue(zero.accepted() <= ALPHA + deviations(ALPHA), zero::toString);
        assertTrue(1 - one.accepted() <= BETA + deviations(BETA), one::toString);
        for (Errors each : List.of(zero, between, one)) {
            assertTrue(each.held() >= 1 - ALPHA - BETA - deviations(ALPHA + BETA), each::toString);
        }
    }
}

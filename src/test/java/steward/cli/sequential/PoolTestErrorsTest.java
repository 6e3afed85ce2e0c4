package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
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
 * Errors of a test against a pool, of made-up games: seeds that favour both tested bots or neither, sides of which one
 * is better, and a new bot that in half of its games does as the base does. One pool has three opponents of different
 * strength, the other twenty, of which the new bot is better against the first ten and worse against the others.
 * {@code ./gradlew campaigns --tests '*PoolTestErrorsTest' -Psteward.games=20000}.
 */
@Execution(ExecutionMode.CONCURRENT)
class PoolTestErrorsTest {

    private static final int TESTS = Integer.getInteger("steward.games", TestSize.of(400, 5000));
    private static final double ALPHA = 0.05;
    private static final double BETA = 0.1;
        private static final Opponents THREE = new Opponents(new double[] {0.3, 0.5, 0.65}, 0.1, 0, 0.12, 0.1);
    private static final Opponents TWENTY = new Opponents(new double[20], 0.2, 0.4, 0, 0);
    private static final long FIRST = 72;

    static {
        Arrays.fill(TWENTY.chances(), 0.4);
    }

    /**
     * A pool. With every effect added a chance stays between 0 and 1.
     *
     * @param chances of the base to win, by opponent
     * @param points  of H1
     * @param gain    of the new bot against the first half of the opponents, and loss against the others
     */
    private record Opponents(double[] chances, double points, double gain, double seedEffect,
                             double sideEffect) {

        /** The games of a seed: two of the new bot, whose chance to win is more by so much, then two of the base. */
        Seed seed(SplitMix64 random, int opponent, double ahead) {
            double ofSeed = chances[opponent] + (random.nextDouble() < 0.5 ? seedEffect : -seedEffect);
            double own = ahead + (opponent < chances.length / 2 ? gain : -gain);
            Outcome[] games = new Outcome[4];
            for (int side = 0; side < 2; side++) {
                double ofSide = ofSeed + (side == 0 ? sideEffect : -sideEffect);
                double base = random.nextDouble();
                double other = random.nextDouble() < 0.5 ? base : random.nextDouble();
                games[side] = PoolScoresTest.game(other < ofSide + own, side);
                games[2 + side] = PoolScoresTest.game(base < ofSide, side);
            }
            return new Seed(1, games);
        }
    }

    /** Share of tests that accepted H1, and whose range had the truth. */
    private record Errors(double accepted, double held) { }

    private static Errors errors(Opponents opponents, double ahead) {
        Gsprt test = Gsprt.ofScores(0.5, (1 + opponents.points()) / 2, ALPHA, BETA);
        Contest contest = PoolScoresTest.contest(2);
        int size = opponents.chances().length;
        List<String> names = Collections.nCopies(size, "a");
        long[] sums = LongStream.range(0, TESTS).mapToObj(number -> {
            SplitMix64 random = new SplitMix64(FIRST + number);
            PoolScores pool = new PoolScores(contest, names, true);
            for (long seed = number * size << 20; test.state(pool.scores()) == Gsprt.State.OPEN; seed++) {
                int opponent = PoolScores.opponent(seed, size);
                pool.add(opponent, opponents.seed(random, opponent, ahead));
            }
            StoppedRange range = test.range(pool.scores());
            double score = (1 + ahead) / 2;
            return new long[] {test.state(pool.scores()) == Gsprt.State.H1 ? 1 : 0,
                range.scoreLow() <= score && score <= range.scoreHigh() ? 1 : 0};
        }).reduce((one, other) -> new long[] {one[0] + other[0], one[1] + other[1]}).orElseThrow();
        return new Errors((double) sums[0] / TESTS, (double) sums[1] / TESTS);
    }

    private static double deviations(double share) {
        return 3 * Math.sqrt(share * (1 - share) / TESTS);
    }

    private static void hold(Opponents opponents, TestReporter report) {
        Errors zero = errors(opponents, 0);
        Errors one = errors(opponents, opponents.points());
        Errors between = errors(opponents, opponents.points() / 2);
        report.publishEntry(String.format(Locale.ROOT, "%,d tests, %d opponents: H1 accepted at H0 %.4f, H0 accepted "
            + "at H1 %.4f; truth in the range %.3f at H0, %.3f between, %.3f at H1", TESTS, opponents.chances().length,
            zero.accepted(), 1 - one.accepted(), zero.held(), between.held(), one.held()));
        assertTrue(zero.accepted() <= ALPHA + deviations(ALPHA), zero::toString);
        assertTrue(1 - one.accepted() <= BETA + deviations(BETA), one::toString);
        for (Errors each : List.of(zero, between, one)) {
            assertTrue(each.held() >= 1 - ALPHA - BETA - deviations(ALPHA + BETA), each::toString);
        }
    }

    @Test
    @Tag("sized")
    @Tag("slow")
    void errorRatesAndRangesAreThoseThatWereAskedFor(TestReporter report) {
        hold(THREE, report);
    }

    @Test
    @Tag("sized")
    @Tag("slow")
    void theyAreAlsoAgainstTwentyOfWhomTheNewBotBeatsTheFirst(TestReporter report) {
        hold(TWENTY, report);
    }
}

package steward.cli.play;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.TreeMap;
import java.util.stream.Collectors;
import steward.contest.Contest;
import steward.contest.Series;
import steward.contest.Standings;
import steward.game.GameSetup;
import steward.match.GuestSetup;
import steward.text.TextFormat;

/** Table of scores by test in a game for one player: a row for each test that was played, and their sum. */
final class TestScores {

    private static final int WIDTH = 14;

    /** Returns how many tests a scene has; 0 where games follow from seeds. */
    static int count(GameSetup setup) {
        return setup instanceof GuestSetup guest ? guest.tests() : 0;
    }

    static void print(PrintStream out, Series series, Standings standings) {
        Contest contest = series.contest();
        int tests = count(contest.setup());
        if (!contest.isAlone() || tests == 0) {
            return;
        }
        int bots = contest.entrants().size();
        TreeMap<Long, double[]> sums = new TreeMap<>();
        TreeMap<Long, int[]> games = new TreeMap<>();
        for (Series.Played game : standings.games()) {
            if (game.result() != null) {
                long test = Math.floorMod(game.seed() - 1, (long) tests) + 1;
                int bot = game.entrantOf(contest, 0);
                sums.computeIfAbsent(test, each -> new double[bots])[bot] += game.result().players().get(0).score();
                games.computeIfAbsent(test, each -> new int[bots])[bot]++;
            }
        }
        out.println();
        StringBuilder head = new StringBuilder("test");
        contest.entrants().forEach(entrant -> head.append(TextFormat.right(TextFormat.shorten(entrant.name(),
            WIDTH - 2), WIDTH)));
        out.println(TextFormat.plain(head.toString()) + (contest.lowerScoreIsBetter()
            ? "   (a lower score is better)" : ""));
        double[] all = new double[bots];
        sums.forEach((test, sum) -> {
            StringBuilder row = new StringBuilder(TextFormat.right(Long.toString(test), 4));
            for (int bot = 0; bot < bots; bot++) {
                double mean = sum[bot] / games.get(test)[bot];
                all[bot] += mean;
                row.append(TextFormat.right(Double.isNaN(mean) ? "-" : TextFormat.number(mean, 2), WIDTH));
            }
            out.println(row);
        });
        out.println("sum " + Arrays.stream(all).mapToObj(sum -> TextFormat.right(Double.isNaN(sum) ? "-"
            : TextFormat.number(sum, 2), WIDTH)).collect(Collectors.joining()));
    }
}

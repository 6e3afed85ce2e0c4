package steward.cli.play;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.contest.Contest;
import steward.contest.Series;
import steward.contest.Standings;
import steward.game.GameSetup;
import steward.match.GuestSetup;
import steward.report.Table;
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
        Map<String, double[]> rows = new LinkedHashMap<>();
        double[] all = new double[bots];
        sums.forEach((test, sum) -> {
            Arrays.setAll(sum, bot -> sum[bot] / games.get(test)[bot]);
            Arrays.setAll(all, bot -> all[bot] + sum[bot]);
            rows.put(Long.toString(test), sum);
        });
        rows.put("sum ", all);
        Table<Map.Entry<String, double[]>> table = new Table<>();
        table.right("test", 4, Map.Entry::getKey);
        for (int k = 0; k < bots; k++) {
            int bot = k;
            table.right(TextFormat.plain(TextFormat.shorten(contest.entrants().get(k).name(), WIDTH - 2)), WIDTH,
                row -> Double.isNaN(row.getValue()[bot]) ? "-" : TextFormat.number(row.getValue()[bot], 2));
        }
        List<String> lines = table.lines(rows.entrySet());
        out.println("\n" + lines.get(0) + (contest.lowerScoreIsBetter() ? "   (a lower score is better)" : ""));
        lines.subList(1, lines.size()).forEach(out::println);
    }
}

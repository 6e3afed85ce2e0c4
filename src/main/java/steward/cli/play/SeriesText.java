package steward.cli.play;

import java.io.PrintStream;
import java.util.List;
import steward.cli.shared.Streams;
import steward.contest.Contest;
import steward.contest.Series;
import steward.contest.Tally;
import steward.match.MatchResult;
import steward.text.TextFormat;

/** The result of a series for people. */
final class SeriesText {

    private static final int FAULTS_SHOWN = 10;

    private SeriesText() {
    }

    /** One line: how many games of what, and the points. */
    static String headline(Series series, List<Series.Played> games) {
        StringBuilder line = new StringBuilder(TextFormat.count(games.size(), "game") + " of "
            + series.contest().sceneName() + ":");
        for (int k = 0; k < series.contest().entrants().size(); k++) {
            Tally tally = Tally.of(series, games, k);
            line.append(k == 0 ? " " : ", ").append(series.contest().entrants().get(k).name()).append(' ')
                .append(TextFormat.fixed(tally.points(), 3));
        }
        return TextFormat.plain(line.toString());
    }

    /** Everything. */
    static void print(Streams streams, Series series, List<Series.Played> games) {
        PrintStream out = streams.out();
        long last = series.first() + series.seeds() - 1;
        out.println(TextFormat.count(games.size(), "game") + " of " + series.contest().sceneName() + ", "
            + (series.seeds() == 1 ? "seed " + series.first() : "seeds " + series.first() + " to " + last)
            + (series.swap() ? ", each with every order of sides" : "")
            + "; " + TextFormat.fixed(meanTurns(games), 1) + " turns on average");
        out.println();
        table(out, series, games);
        out.println();
        out.println("Points: 1 for a win, 1/2 for a draw"
            + (series.contest().entrants().size() > 2 ? " against each other bot, divided by their number" : "")
            + "; Wilson's 95% interval.");
        faults(out, games);
        if (series.folder() != null) {
            out.println("Replays: " + series.file(1) + (games.size() == 1 ? "" : " to " + series.file(games.size())));
        }
    }

    private static void table(PrintStream out, Series series, List<Series.Played> games) {
        List<Contest.Entrant> entrants = series.contest().entrants();
        int width = entrants.stream().mapToInt(entrant -> entrant.name().length()).max().orElse(0);
        int names = Math.min(40, Math.max(3, width));
        out.println(TextFormat.left("bot", names) + "    wins   draws  losses  faults  points   95% interval");
        for (int k = 0; k < entrants.size(); k++) {
            Tally tally = Tally.of(series, games, k);
            out.println(TextFormat.left(TextFormat.plain(TextFormat.shorten(entrants.get(k).name(), names)), names)
                + TextFormat.right(Integer.toString(tally.wins()), 8)
                + TextFormat.right(Integer.toString(tally.draws()), 8)
                + TextFormat.right(Integer.toString(tally.losses()), 8)
                + TextFormat.right(Integer.toString(tally.faults()), 8)
                + TextFormat.right(TextFormat.fixed(tally.points(), 3), 8)
                + "   " + TextFormat.fixed(tally.low(), 3) + " to " + TextFormat.fixed(tally.high(), 3));
        }
    }

    /** Mean turns of the games that have a result; NaN without any. */
    static double meanTurns(List<Series.Played> games) {
        return games.stream().filter(game -> game.result() != null).mapToInt(game -> game.result().turns())
            .average().orElse(Double.NaN);
    }

    private static void faults(PrintStream out, List<Series.Played> games) {
        int count = 0;
        for (Series.Played game : games) {
            if (game.result() == null) {
                continue;
            }
            for (MatchResult.PlayerResult player : game.result().players()) {
                if (player.fault() != null && count++ < FAULTS_SHOWN) {
                    out.println("game " + game.number() + " (seed " + game.seed() + "): "
                        + TextFormat.plain(player.name() + " failed: " + player.fault()));
                }
            }
        }
        if (count > FAULTS_SHOWN) {
            out.println("and " + TextFormat.count(count - FAULTS_SHOWN, "fault") + " more; --json lists all");
        }
    }
}

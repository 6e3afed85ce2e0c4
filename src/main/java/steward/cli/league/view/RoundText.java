package steward.cli.league.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import steward.league.LeagueBot;
import steward.league.LeagueSettings;
import steward.league.RoundOrder;
import steward.league.pairing.AdaptivePairing;
import steward.league.rating.LeagueTable;
import steward.league.rating.LeagueTable.Row;
import steward.text.TextFormat;

/**
 * Text about rounds of a league, in which every group of bots meets once: how long a round is, and the present one's
 * state.
 */
public final class RoundText {

    private RoundText() { }

    /**
     * Length of a round.
     *
     * @param versions that play
     * @param hero     the version that is in every game, or -1
     * @param meeting  whether versions may play together
     */
    public static String length(LeagueSettings settings, List<Integer> versions, int players, int hero,
                                Predicate<int[]> meeting) {
        if (players == 1) {
            return "a round is one map, " + TextFormat.count(versions.size(), "game");
        }
        long groups = RoundOrder.groups(versions, players, hero).stream().filter(meeting).count();
        return "a round takes " + TextFormat.count(groups * players, "game") + ": "
            + TextFormat.count(groups, "pairing") + " on one seed each, from all seats"
            + (settings.adaptive() ? "; after " + AdaptivePairing.FIRST + " rounds those play who are in doubt" : "");
    }

    /**
     * Returns how far the round is that has begun and is not complete; empty if there is none, or each bot plays alone,
     * or that is not known: of a game in which all failed, the table does not say who met.
     */
    public static Optional<String> unfinished(LeagueTable table, LeagueSettings settings, int players) {
        List<Row> rows = table.rows().stream().filter(row -> row.entry().active()).toList();
        if (players == 1 || rows.size() < players || table.results().games() == 0
            || rows.stream().anyMatch(row -> row.sums().allFailed() > 0)) {
            return Optional.empty();
        }
        double[] met = met(rows, table, settings.gauntlet());
        double ofRound = 2 * groupsOfPair(rows.size() - 2, players - 2);
        long whole = (long) (DoubleStream.of(met).min().orElse(0) / ofRound);
        long done = DoubleStream.of(met).filter(games -> games >= ofRound * (whole + 1)).count();
        boolean rounds = !settings.adaptive() || whole < AdaptivePairing.FIRST;
        boolean begun = whole == 0 || DoubleStream.of(met).anyMatch(games -> games > ofRound * whole);
        return !rounds || met.length == 0 || !begun ? Optional.empty()
            : Optional.of("Round " + (whole + 1) + " is not complete: " + done + " of "
                + TextFormat.count(met.length, "pair") + " have met in it.");
    }

    /** Games of each pair that is to meet, in whole games of two. */
    private static double[] met(List<Row> rows, LeagueTable table, String hero) {
        DoubleStream.Builder met = DoubleStream.builder();
        for (int i = 0; i < rows.size(); i++) {
            for (int j = 0; j < i; j++) {
                if ((hero == null || is(rows.get(i), hero) || is(rows.get(j), hero))
                    && mayMeet(rows.get(i), rows.get(j))) {
                    met.add(table.results().games(rows.get(i).entry().version(), rows.get(j).entry().version()));
                }
            }
        }
        return met.build().toArray();
    }

    private static boolean is(Row row, String bot) {
        return bot(row).equals(bot);
    }

    private static String bot(Row row) {
        return row.entry().name().replaceFirst("#\\d+$", "");
    }

    private static boolean mayMeet(Row one, Row other) {
        String platform = LeagueBot.platform(bot(one));
        return platform == null || LeagueBot.platform(bot(other)) == null
            || platform.equals(LeagueBot.platform(bot(other)));
    }

    private static double groupsOfPair(int others, int seats) {
        double groups = 1;
        for (int k = 0; k < seats; k++) {
            groups = groups * (others - k) / (k + 1);
        }
        return groups;
    }
}

package steward.contest;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import steward.contest.loss.LeadLog;
import steward.contest.loss.Losses;
import steward.match.MatchResult;
import steward.match.MatchResult.PlayerResult;

/** Converter of a series' games to {@link Losses}, the account of the games that one bot lost. */
public final class Losers {

    private Losers() { }

    /**
     * Returns the account of a bot, by its place in the call; games in which all failed tell nothing.
     *
     * @param repeats those of the games that only repeat others
     */
    public static Losses of(Contest contest, List<Series.Played> games, List<Series.Played> repeats, int entrant) {
        Losses losses = new Losses(contest.entrants().get(entrant).name(), contest.lowerScoreIsBetter());
        boolean lower = contest.lowerScoreIsBetter();
        for (Series.Played game : games) {
            if (repeats.contains(game)) {
                losses.repeat();
            } else if (game.result() != null && !game.allFailed()) {
                losses.add(game(game, game.playerOf(contest, entrant), lower));
            }
        }
        return losses;
    }

    private static Losses.Game game(Series.Played game, int player, boolean lower) {
        List<PlayerResult> players = game.result().players();
        PlayerResult own = players.get(player);
        long sharers = players.stream().filter(each -> each.rank() == 0).count();
        Comparator<Double> better = lower ? Comparator.reverseOrder() : Comparator.naturalOrder();
        double winner = IntStream.range(0, players.size()).filter(other -> other != player
            && players.get(other).rank() == 0)
            .mapToObj(other -> players.get(other).score()).max(better).orElse(own.score());
        List<Integer> behind = game.facts().behindFrom();
        return new Losses.Game("game " + game.number() + " (seed " + game.seed() + ")",
            Losses.Outcome.of(own.rank(), sharers), Losses.kind(own.fault() == null ? null : Failure.kind(own.fault()),
                own.out() == null ? null : Failure.kind(own.out()), game.result().ending()), game.result().turns(),
            player < behind.size() ? behind.get(player) : LeadLog.UNKNOWN, own.score(), winner,
            values(game.facts().values(player), own.data(), game.result()), game.replay() == null ? null
                : game.replay().toString());
    }

    private static Map<String, Double> values(Map<String, Double> own, Map<String, String> data, MatchResult result) {
        Map<String, Double> values = new TreeMap<>(own);
        addNumbers(values, data);
        addNumbers(values, result.data());
        return values;
    }

    /** Adds what bots reported about themselves, as far as it is numbers. */
    public static void addNumbers(Map<String, Double> values, Map<String, String> data) {
        data.forEach((name, text) -> {
            try {
                values.putIfAbsent(name, Double.valueOf(text));
            } catch (NumberFormatException word) {
                return;                                // words have no mean
            }
        });
    }
}

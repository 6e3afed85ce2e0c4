package steward.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import steward.match.MatchResult;

/**
 * Results of one bot in many games: ranks, points, scores and failures.
 *
 * <p>Points of a game: the share of the opponents ranked below, plus half of those on the same rank. Between two bots
 * that is 1 for a win, 1/2 for a draw, 0 for a loss. In a game for one player the results on the same map are compared
 * so; a bot without opponents has no points.
 *
 * <p>Two kinds of games say nothing about which bot is better, and give no points: games in which all bots failed in
 * the same turn, and repeats, in which the same bots in the same seats did exactly what they had done in an earlier
 * game.
 *
 * @param games     that have points
 * @param wins      alone on the first rank
 * @param draws     on the first rank with others
 * @param losses    the rest
 * @param allFailed games in which all bots failed in the same turn
 * @param faults    games in which the bot failed as a program, of all
 * @param points    per game, 0..1; NaN without games, and without other bots
 * @param score     the game's own, per game, of all
 * @param seeds     mean points of each seed; games of a seed belong together
 */
public record Tally(int games, int wins, int draws, int losses, int allFailed, int faults, double points,
                    double score, List<Double> seeds) {

    /** Copies the list. */
    public Tally {
        seeds = List.copyOf(seeds);
    }

    /**
     * The tally of a bot, by its place in the call.
     *
     * @param repeats numbers of the games that are repeats
     */
    static Tally of(Contest contest, List<Series.Played> played, Set<Integer> repeats, int entrant) {
        if (contest.isAlone()) {
            return AloneTally.of(contest, played, entrant);
        }
        int results = 0;
        int wins = 0;
        int draws = 0;
        int losses = 0;
        int allFailed = 0;
        int faults = 0;
        double score = 0;
        Map<Long, List<Double>> seeds = new TreeMap<>();
        for (Series.Played game : played) {
            MatchResult result = game.result();
            if (result == null) {
                continue;
            }
            int player = game.playerOf(contest, entrant);
            results++;
            allFailed += game.allFailed() ? 1 : 0;
            faults += result.players().get(player).fault() != null ? 1 : 0;
            score += result.players().get(player).score();
            if (!game.allFailed() && !repeats.contains(game.number())) {
                boolean first = result.players().get(player).rank() == 0;
                wins += result.winner() == player ? 1 : 0;
                draws += result.winner() != player && first ? 1 : 0;
                losses += first ? 0 : 1;
                seeds.computeIfAbsent(game.seed(), seed -> new ArrayList<>(2)).add(points(result, player));
            }
        }
        int games = wins + draws + losses;
        return new Tally(games, wins, draws, losses, allFailed, faults,
            seeds.values().stream().flatMap(List::stream).mapToDouble(each -> each).sum() / games, score / results,
            seeds.values().stream().map(each -> each.stream().mapToDouble(one -> one).average().orElseThrow())
                .toList());
    }

    static double points(MatchResult result, int player) {
        int rank = result.players().get(player).rank();
        double points = 0;
        int others = result.players().size() - 1;
        for (MatchResult.PlayerResult other : result.players()) {
            points += other.rank() > rank ? 1 : other.rank() == rank ? 0.5 : 0;
        }
        return (points - 0.5) / others;
    }
}

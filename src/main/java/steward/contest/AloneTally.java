package steward.contest;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.match.MatchResult;

/**
 * Results of one bot in a game for one player, compared with the other bots' results on the same maps. A map counts
 * only if every game on it has a result; the mean score is over all results of the bot.
 */
final class AloneTally {

    private final int entrant;
    private final boolean lowerIsBetter;
    private final int bots;
    private int maps;
    private int wins;
    private int draws;
    private double points;
    private final List<Double> ofMaps = new ArrayList<>();

    private AloneTally(Contest contest, int entrant) {
        this.entrant = entrant;
        lowerIsBetter = contest.lowerScoreIsBetter();
        bots = contest.entrants().size();
    }

    static Tally of(Contest contest, List<Series.Played> played, int entrant) {
        AloneTally tally = new AloneTally(contest, entrant);
        Map<Long, double[]> bySeed = new TreeMap<>();
        int games = 0;
        int faults = 0;
        double score = 0;
        for (Series.Played game : played) {
            int bot = game.entrantOf(contest, 0);
            if (game.result() == null) {
                continue;
            }
            MatchResult.PlayerResult result = game.result().players().get(0);
            bySeed.computeIfAbsent(game.seed(), seed -> tally.unknown())[bot] = result.score();
            if (bot == entrant) {
                games++;
                faults += result.fault() != null ? 1 : 0;
                score += result.score();
            }
        }
        bySeed.values().forEach(tally::compare);
        boolean others = tally.bots > 1;
        int maps = others ? tally.maps : games;
        return new Tally(maps, tally.wins, tally.draws, others ? maps - tally.wins - tally.draws : 0, 0, faults,
            others ? tally.points / maps : Double.NaN, score / games, tally.ofMaps);
    }

    private double[] unknown() {
        double[] scores = new double[bots];
        Arrays.fill(scores, Double.NaN);
        return scores;
    }

    private void compare(double[] scores) {
        if (bots == 1 || Arrays.stream(scores).anyMatch(Double::isNaN)) {
            return;
        }
        int behind = 0;
        int equal = 0;
        for (int other = 0; other < bots; other++) {
            if (other != entrant && scores[other] == scores[entrant]) {
                equal++;
            } else if (other != entrant && lowerIsBetter == scores[entrant] < scores[other]) {
                behind++;
            }
        }
        maps++;
        ofMaps.add((behind + 0.5 * equal) / (bots - 1));
        points += ofMaps.get(ofMaps.size() - 1);
        wins += behind == bots - 1 ? 1 : 0;
        draws += behind < bots - 1 && behind + equal == bots - 1 ? 1 : 0;
    }
}

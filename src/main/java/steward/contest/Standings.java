package steward.contest;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import steward.contest.repeat.Repeats;
import steward.match.MatchResult;

/**
 * Finished games of a series and their sums. Any thread may read them while games are played; no result depends on the
 * order in which games ended.
 */
public final class Standings {

    private final Contest contest;
    private final TreeMap<Integer, Series.Played> games = new TreeMap<>();
    private final AnswerTimes[] times;
    private final double[] points;
    private int results;
    private int counted;
    /** Games so far, as they ended: which of two equal ones counts makes no difference to {@link #points}. */
    private final Repeats seen = new Repeats();
    private int failed;
    private volatile boolean random;

    private final FailureCounts failures;

    Standings(Contest contest) {
        this.contest = contest;
        failures = new FailureCounts(contest);
        int entrants = contest.entrants().size();
        points = new double[entrants];
        times = new AnswerTimes[entrants];
        for (int k = 0; k < entrants; k++) {
            times[k] = new AnswerTimes();
        }
    }

    /**
     * Adds a game.
     *
     * @param found    failures with their lines, of which only those of the first failure of a kind are kept
     * @param measured answer times by player
     */
    synchronized void add(Series.Played game, List<Failure> found, List<AnswerTimes> measured) {
        games.put(game.number(), game);
        failures.add(game, found);
        for (int player = 0; player < measured.size(); player++) {
            times[game.entrantOf(contest, player)].addAll(measured.get(player), game.number());
        }
        MatchResult result = game.result();
        if (result != null) {
            results++;
            failed += result.anyFault() ? 1 : 0;
            if (!contest.isAlone() && !game.allFailed() && !isRepeat(game, seen)) {
                counted++;
                for (int player = 0; player < result.players().size(); player++) {
                    points[game.entrantOf(contest, player)] += Tally.points(result, player);
                }
            }
        }
    }

    private boolean isRepeat(Series.Played game, Repeats before) {
        return !random && before.isRepeat(game.rotation(), game.facts().transcript());
    }

    /** In the order of their numbers. */
    public synchronized List<Series.Played> games() {
        return List.copyOf(games.values());
    }

    /** Returns how many games have a result. */
    public synchronized int results() {
        return results;
    }

    /** In how many games with a result a bot failed. */
    public synchronized int gamesWithFaults() {
        return failed;
    }

    /** Points per game of a bot so far, by its place in the call; NaN without games. */
    public synchronized double points(int entrant) {
        return contest.isAlone() ? tally(entrant).points() : points[entrant] / counted;
    }

    /** Returns how a bot did, by its place in the call. */
    public Tally tally(int entrant) {
        List<Series.Played> all = games();
        return Tally.of(contest, all, repeats(all), entrant);
    }

    /** Returns the games that repeat an earlier one, in the order of their numbers. */
    public List<Series.Played> repeats() {
        List<Series.Played> all = games();
        Set<Integer> numbers = repeats(all);
        return all.stream().filter(game -> numbers.contains(game.number())).toList();
    }

    private Set<Integer> repeats(List<Series.Played> all) {
        Repeats before = new Repeats();
        Set<Integer> repeats = new HashSet<>();
        for (Series.Played game : all) {
            if (!contest.isAlone() && game.result() != null && !game.allFailed() && isRepeat(game, before)) {
                repeats.add(game.number());
            }
        }
        return repeats;
    }

    /** Bots draw by lot: equal games are independent draws, and no repeats. */
    public void random() {
        random = true;
    }

    /** Returns how long a bot took to answer; to be looked at when no more games are played. */
    public synchronized AnswerTimes times(int entrant) {
        return times[entrant];
    }

    /** Mean turns of the games that have a result; NaN without any. */
    public double meanTurns() {
        return games().stream().filter(game -> game.result() != null).mapToInt(game -> game.result().turns())
            .average().orElse(Double.NaN);
    }

    /** The games in which all bots failed in the same turn: they do not tell which bot is better. */
    public List<Series.Played> allFailed() {
        return games().stream().filter(Series.Played::allFailed).toList();
    }

    /** The games that were played again, see {@link Hiccups#REPLAY}. */
    public List<Series.Played> playedAgain() {
        return games().stream().filter(game -> game.starved() != null).toList();
    }

    /** Returns why bots failed, the bot and kind of the earliest game first. */
    public synchronized List<FailureKind> failures() {
        return failures.kinds();
    }
}

package steward.league.pairing;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import steward.league.Season;
import steward.league.rating.Results;

/**
 * Results of a schedule's games by decision. A decision uses only results of decisions below a given number, whatever
 * has been played meanwhile. Not thread-safe.
 */
public final class KnownResults {

    private final Results results;
    private final boolean alone;
    private final TreeMap<Integer, List<Game>> later = new TreeMap<>();

    private record Game(long seed, int[] lineup, double score, long transcript, int... ranks) { }

    /**
     * Goes on from results.
     *
     * @param results of all decisions below a number, which {@link #before} is not asked about any more
     */
    public KnownResults(Season season, Results results) {
        this.results = results;
        alone = season.players() == 1;
    }

    /**
     * Adds a game that counts.
     *
     * @param score      of the player, where each plays alone
     * @param transcript its digest; 0 if it is not known, or a bot draws by lot
     * @param ranks      by seat
     */
    public void add(int decision, long seed, int[] lineup, double score, long transcript, int... ranks) {
        later.computeIfAbsent(decision, number -> new ArrayList<>(2))
            .add(new Game(seed, lineup.clone(), score, transcript, ranks.clone()));
    }

    /** The results of all decisions below a number, which is not less than in the call before. */
    public Results before(int decision) {
        while (!later.isEmpty() && later.firstKey() < decision) {
            for (Game game : later.pollFirstEntry().getValue()) {
                if (results.isRepeat(Results.lineup(game.lineup()), game.transcript())) {
                    continue;
                }
                if (alone) {
                    results.addAlone(game.seed(), game.lineup()[0], game.score());
                } else {
                    results.addGame(game.seed(), game.lineup(), game.ranks());
                }
            }
        }
        return results;
    }
}

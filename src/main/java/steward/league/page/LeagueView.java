package steward.league.page;

import java.util.List;
import java.util.Map;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;

/**
 * Snapshot of a league: all data that its page shows.
 *
 * @param season  what all its games have in common
 * @param path    how the ratings went
 * @param games   the last games, the latest first
 * @param rate    games a second, or NaN when it is not being played
 * @param workers those that play on other machines
 * @param why     by version, lines on the games that it lost; none where that is not looked at
 */
public record LeagueView(Season season, LeagueTable table, RatingPath path, List<StoredGame> games, double rate,
                         List<WorkerRow> workers, Map<Integer, List<String>> why) {

    public LeagueView {
        games = List.copyOf(games);
        workers = List.copyOf(workers);
        why = Map.copyOf(why);
    }

    /** A view that does not look at lost games. */
    public LeagueView(Season season, LeagueTable table, RatingPath path, List<StoredGame> games, double rate,
                      List<WorkerRow> workers) {
        this(season, table, path, games, rate, workers, Map.of());
    }
}

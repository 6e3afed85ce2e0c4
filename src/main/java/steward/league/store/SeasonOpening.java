package steward.league.store;

import java.util.List;
import java.util.Optional;
import steward.files.InputException;
import steward.files.Remedied;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.text.TextFormat;

/** Opening of the season in which a league continues, refused if the settings have changed since its games. */
public final class SeasonOpening {

    private SeasonOpening() { }

    /**
     * Opens the season that the settings of a league mean.
     *
     * @param season that they mean
     * @param anew   whether a table may be begun beside one that has games
     * @return its number in the store
     * @throws InputException if the games so far are another season's
     */
    public static int open(LeagueFolder folder, GameStore store, Season season, boolean anew) {
        Optional<Season> last = store.lastSeason();
        if (last.isPresent() && !last.get().key().equals(season.key()) && !anew) {
            long games = store.games(store.season(last.get()).orElseThrow());
            if (games > 0) {
                throw changed(folder, last.get(), season, games);
            }
        }
        return store.open(season);
    }

    private static InputException changed(LeagueFolder folder, Season last, Season season, long games) {
        return new InputException(folder.path() + ": " + last.difference(season) + ", and the league has "
            + TextFormat.count(games, "game") + " of before; expected it as it was, or a new season, as 'steward "
            + "league run " + folder.path() + "' can begin one",
            List.of(new Remedied.Remedy("new-season", "begins a new table and keeps the old games")));
    }
}

package steward.league.play;

import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;

/**
 * The season that a run plays, with its database and its number there.
 *
 * @param number its number in the store
 * @param season what all of its games have in common
 */
public record OpenSeason(LeagueFolder folder, GameStore store, int number, Season season) {

    GameQueries queries() {
        return new GameQueries(store, number, season);
    }
}

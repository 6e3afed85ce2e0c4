package steward.league.store;

import java.util.Optional;
import java.util.stream.Stream;
import steward.files.InputException;
import steward.files.Remedied;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.text.TextFormat;

/** Opening of the season in which a league goes on. */
public final class SeasonOpening {

    private SeasonOpening() { }

    /**
     * Opens the season that the settings mean.
     *
     * @param season that they mean
     * @param anew   whether a table may be begun beside one that has games
     * @return its number in the store
     * @throws InputException if the games so far are another season's
     */
    public static int open(LeagueFolder folder, LeagueSettings settings, GameStore store, Season season,
                           boolean anew) {
        Optional<Season> last = store.lastSeason();
        if (last.isPresent() && !last.get().key().equals(season.key()) && !anew) {
            long games = store.games(store.season(last.get()).orElseThrow());
            if (games > 0) {
                throw changed(folder, settings, last.get(), season, games);
            }
        }
        return store.open(season);
    }

    private static InputException changed(LeagueFolder folder, LeagueSettings settings, Season last, Season season,
                                          long games) {
        boolean rules = RulesBefore.scene(folder, settings, last).isPresent();
        return new InputException(folder.path() + ": " + (rules
            ? "the rules of the scene " + season.sceneName() + " are those of the live server now"
            : last.difference(season)) + ", and the league has " + TextFormat.count(games, "game")
            + " of before; expected " + (rules ? "its rules" : "it as it was") + ", or a new season, as "
            + "'steward league run " + folder.path() + "' can begin one",
            Stream.of(new Remedied.Remedy("keep-rules", "goes on by the rules of before"),
                new Remedied.Remedy("new-season", "begins a new table and keeps the old games"))
                .filter(each -> rules || !each.option().equals("keep-rules")).toList());
    }
}

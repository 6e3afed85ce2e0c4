package steward.cli.tournament;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.cli.league.view.LeagueOpening;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.play.Roster;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.rating.Results;

/**
 * Stored games between the programs that play now. The table and the pages are made from these alone: games of older
 * versions and of programs that are gone stay in the league but are not shown.
 *
 * @param entries the versions that play, by the names of their programs
 * @param games   in the order in which they were stored, those that do not count among them
 */
record PlayedGames(Season season, List<LeagueTable.Entry> entries, List<StoredGame> games) {

    /** Reads the games of a league that has been played. */
    static PlayedGames read(LeagueOpening.Opened opened, Roster roster) {
        List<LeagueTable.Entry> entries = roster.members().stream().map(member ->
            new LeagueTable.Entry(member.version().id(), member.bot().name(), member.version().random(),
                true)).toList();
        List<Integer> versions = roster.versions();
        List<StoredGame> games = new ArrayList<>();
        opened.games().games(game -> {
            if (game.seats().stream().allMatch(seat -> versions.contains(seat.version()))) {
                games.add(game);
            }
        });
        return new PlayedGames(opened.season(), entries, games);
    }

    /** These games and one more. */
    PlayedGames with(StoredGame game) {
        List<StoredGame> more = new ArrayList<>(games);
        more.add(game);
        return new PlayedGames(season, entries, more);
    }

    /** The games that count, each once, however often it was played. */
    List<StoredGame> counted() {
        return games.stream().filter(StoredGame::counts).toList();
    }

    Map<Integer, String> names() {
        Map<Integer, String> names = new HashMap<>();
        entries.forEach(entry -> names.put(entry.version(), entry.name()));
        return names;
    }

    /** The version of a program, or -1 if it does not play. */
    int versionOf(String name) {
        return entries.stream().filter(entry -> entry.name().equals(name)).mapToInt(LeagueTable.Entry::version)
            .findFirst().orElse(-1);
    }

    /** The ratings over these games. */
    LeagueTable ratings() {
        Results results = new Results(season);
        games.forEach(game -> results.add(game, LeagueTable.Entry.random(entries)));
        return LeagueTable.of(results, entries);
    }

    /** Path of the ratings over these games. */
    RatingPath path() {
        Results results = new Results(season);
        RatingPath.Collector path = new RatingPath.Collector(entries, LeagueTable.Reference.NONE);
        long step = Math.max(1, games.size() / RatingPath.points(entries.size()));
        for (int k = 0; k < games.size(); k++) {
            results.add(games.get(k), LeagueTable.Entry.random(entries));
            if ((k + 1) % step == 0 || k + 1 == games.size()) {
                path.take(results);
            }
        }
        return path.path();
    }
}

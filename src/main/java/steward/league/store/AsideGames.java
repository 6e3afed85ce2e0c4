package steward.league.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import steward.league.StoredGame;

/**
 * Games that are set aside: they are stored but do not count; {@code problem} gives the reason. Games of a worker that
 * was caught cheating are set aside for good. Others can count again: games of a worker under suspicion wait for an
 * operator's decision, and an operator can forgive games of a bot. Thread-safe.
 */
public final class AsideGames {

    /** As {@link GameRows} writes it. */
    private static final String COUNTS = "iif((SELECT count(*) > 1 AND count(fault) = count(*) AND min(answers) = "
        + "max(answers) FROM seat WHERE seat.game = game.id), " + GameRows.ALL_FAILED + ", 1)";
    private static final String BEGINS = "counts = 0 AND substr(problem, 1, length(?)) = ? AND ";
    private static final String OF_MACHINE = "machine IN (SELECT id FROM machine WHERE substr(name, 1, length(?)) = ?)";
    private static final String OF_BOT = "id BETWEEN ? AND ? AND id IN (SELECT game FROM seat WHERE version IN "
        + "(SELECT id FROM version WHERE bot = ?))";
    private static final String FAILED = " AND decision IS NOT NULL AND id IN (SELECT game FROM seat WHERE fault IS "
        + "NOT NULL AND version IN (SELECT id FROM version WHERE bot = ?))";

    private final Database database;

    public AsideGames(GameStore store) {
        database = store.database();
    }

    /** Numbers of games, from the first to the last. */
    public record Range(long first, long last) { }

    /**
     * Sets games of a machine aside for good: they are played again.
     *
     * @param machine how its name begins
     * @param why     begins with {@link StoredGame#SET_ASIDE}
     * @return those that counted, or were suspended
     */
    public List<StoredGame> setAside(GameQueries games, int season, String machine, String why) {
        String which = OF_MACHINE + " AND season = ?";
        return database.inTransaction(() -> {
            back(StoredGame.SUSPENDED, which, machine, machine, season);
            return aside(why, which, machine, machine, season).stream().map(id -> games.game((long) id)).toList();
        });
    }

    /**
     * Games of a machine count no more, until {@link #restore}.
     *
     * @param machine how its name begins
     * @param why     begins with {@link StoredGame#SUSPENDED}
     * @return how many
     */
    public int suspend(String machine, String why) {
        return database.inTransaction(() -> aside(why, OF_MACHINE, machine, machine).size());
    }

    /** Suspended games of a machine count again. @return how many */
    public int restore(String machine) {
        return database.inTransaction(() -> back(StoredGame.SUSPENDED, OF_MACHINE, machine, machine).size());
    }

    /** All games of a bot among these count no more, whatever they came to. @return how many */
    public int forgive(String bot, Range games) {
        return database.inTransaction(() -> aside(StoredGame.FORGIVEN + ": " + words(bot, games), OF_BOT,
            games.first(), games.last(), bot).size());
    }

    /** All games of the schedule among these in which a bot failed are to be played again. @return how many */
    public int playAgain(String bot, Range games) {
        return database.inTransaction(() -> aside(StoredGame.FORGIVEN_AGAIN + words(bot, games), OF_BOT + FAILED,
            games.first(), games.last(), bot, bot).size());
    }

    private static String words(String bot, Range games) {
        return "games " + games.first() + " to " + games.last() + " of " + bot;
    }

    /** Forgiven games of a bot count again, and their further attempts no more. @return how many */
    public int takeBack(String bot, Range games) {
        return database.inTransaction(() -> {
            List<Object> back = back(StoredGame.FORGIVEN, OF_BOT, games.first(), games.last(), bot);
            for (Object game : back) {
                aside(StoredGame.REPLACED + game + ", an earlier attempt, counts again", "EXISTS (SELECT 1 "
                    + "FROM game o WHERE o.id = ? AND o.season = game.season AND o.lineup = game.lineup AND o.seed = "
                    + "game.seed AND o.attempt < game.attempt)", game);
            }
            return back.size();
        });
    }

    private List<Object> aside(String why, String which, Object... values) throws SQLException {
        List<Object> games = ids("counts > 0 AND " + which, values);
        for (Object game : games) {
            database.update("UPDATE game SET counts = 0, problem = ? WHERE id = ?", why, game);
            RowDigest.seal(database, "game", "id = ?", game);
        }
        return games;
    }

    private List<Object> back(String begin, String which, Object... values) throws SQLException {
        List<Object> all = new ArrayList<>(List.of(begin, begin));
        all.addAll(List.of(values));
        List<Object> games = ids(BEGINS + which, all.toArray());
        for (Object game : games) {
            database.update("UPDATE game SET counts = " + COUNTS + ", problem = NULL WHERE id = ?", game);
            RowDigest.seal(database, "game", "id = ?", game);
        }
        return games;
    }

    private List<Object> ids(String which, Object... values) throws SQLException {
        List<Object> games = new ArrayList<>();
        try (ResultSet row = database.query("SELECT id FROM game WHERE " + which, values)) {
            while (row.next()) {
                games.add(row.getLong(1));
            }
        }
        return games;
    }
}

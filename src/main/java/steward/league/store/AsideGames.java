package steward.league.store;

import java.util.List;
import java.util.stream.Stream;
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
            return aside(why, which, machine, machine, season).stream().map(games::game).toList();
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
            List<Long> back = back(StoredGame.FORGIVEN, OF_BOT, games.first(), games.last(), bot);
            for (long game : back) {
                aside(StoredGame.REPLACED + game + ", an earlier attempt, counts again", "EXISTS (SELECT 1 "
                    + "FROM game o WHERE o.id = ? AND o.season = game.season AND o.lineup = game.lineup AND o.seed = "
                    + "game.seed AND o.attempt < game.attempt)", game);
            }
            return back.size();
        });
    }

    private List<Long> aside(String why, String which, Object... values) {
        return RowDigest.sealed(database, "game", "UPDATE game SET counts = 0, problem = ? WHERE counts > 0 AND "
            + which, Stream.concat(Stream.of(why), Stream.of(values)).toArray());
    }

    private List<Long> back(String begin, String which, Object... values) {
        return RowDigest.sealed(database, "game", "UPDATE game SET counts = " + COUNTS + ", problem = NULL WHERE "
            + "counts = 0 AND substr(problem, 1, length(?)) = ? AND " + which,
            Stream.concat(Stream.of(begin, begin), Stream.of(values)).toArray());
    }
}

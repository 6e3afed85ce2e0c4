package steward.league.store;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import steward.files.InputException;
import steward.league.Decision;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.StoredGame;

/**
 * Storage of a league: seasons, versions of bots, games. Every method is one transaction, and any thread may call it.
 * Each throws {@link InputException} if the database cannot be used.
 *
 * <p>Over 400 lines, because each statement stands beside the method that runs it.
 */
public final class GameStore implements AutoCloseable {

    private static final String VERSION = "version";

    private final Database database;
    private final GameRows gameRows;
    private final DecisionRows decisionRows;

    /**
     * A version of a bot.
     *
     * @param id       its number in the store
     * @param bot      the bot's name
     * @param number   1 for the first of this bot
     * @param command  as it was first called
     * @param random   whether it was said to draw by lot
     * @param identity the first that it had: the one in names of games
     * @param played   when its last game ended or it began, in milliseconds since 1970
     * @param paused   whether it was paused when the league was last played
     * @param timeLimit its own limits as {@link steward.match.OwnLimits#written}, or {@code null} for the season's
     */
    public record Version(int id, String bot, int number, String command, boolean random, String identity,
                          long played, boolean paused, String timeLimit) {

        /** The bot's name, from the second version on with its number. */
        public String display() {
            return number == 1 ? bot : bot + "#" + number;
        }
    }

    GameStore(Database database) {
        this.database = database;
        TextRows lineups = new TextRows(database, "lineup", "versions");
        gameRows = new GameRows(database, lineups);
        decisionRows = new DecisionRows(database, lineups);
    }

    /** For reading alone; other programs may write meanwhile. */
    public static GameStore read(LeagueFolder folder) {
        return checked(Database.open(folder, false, false));
    }

    /** Opens with rows that may be bad: to look for them, or because they have just been looked for. */
    public static GameStore unchecked(LeagueFolder folder, boolean write) {
        return new GameStore(Database.open(folder, write, write));
    }

    /** True if the games of a league are in a database of an older form. */
    public static boolean isBehind(LeagueFolder folder) {
        return Database.isBehind(folder);
    }

    /** Refuses a database in which a row cannot be used, before anything is computed from it. */
    static GameStore checked(Database database) {
        GameStore store = new GameStore(database);
        try {
            List<BadRow> rows = store.badRows(1);
            if (!rows.isEmpty()) {
                throw new InputException(database.file() + ": " + rows.get(0)
                    + "; 'steward league verify' lists such rows and sets them aside");
            }
            return store;
        } catch (InputException bad) {
            database.close();
            throw bad;
        }
    }

    /** For reading and writing; made if it is not there. */
    public static GameStore write(LeagueFolder folder) {
        return checked(Database.open(folder, true, false));
    }

    /** Opens as {@link #write} does; each game is on the disk before the next, also if the power fails. */
    public static GameStore durable(LeagueFolder folder) {
        return checked(Database.open(folder, true, true));
    }

    Database database() {
        return database;
    }

    // ---- seasons ---------------------------------------------------------------------------------

    /** The number of a season that is there, by its key. */
    public Optional<Integer> season(Season season) {
        return database.list("SELECT id FROM season WHERE key = ?", row -> row.getInt(1), season.key()).stream()
            .findFirst();
    }

    /** The season that was opened last, if there is any. */
    public Optional<Season> lastSeason() {
        return database.list("SELECT scene, scene_key, limits, rules, players, lower_is_better FROM season ORDER BY "
            + "opened DESC, id DESC LIMIT 1", row -> Season.of(row.getString(1), row.getString(2), row.getString(3),
            row.getString(4), row.getInt(5), row.getBoolean(6))).stream().findFirst();
    }

    /** Opens a season, new or again; it is the last one then. */
    public int open(Season season) {
        return database.inTransaction(() -> RowDigest.sealed(database, "season", "INSERT INTO season (key, scene, "
            + "scene_key, limits, rules, players, lower_is_better, opened) VALUES (?, ?, ?, ?, ?, ?, ?, (SELECT 1 + "
            + "coalesce(max(opened), 0) FROM season)) ON CONFLICT (key) DO UPDATE SET opened = excluded.opened",
            season.key(), season.sceneName(), season.sceneKey(), season.limits(), season.rules(), season.players(),
            season.lowerScoreIsBetter() ? 1 : 0).get(0).intValue());
    }

    /** Returns how many games a season has, of whatever kind. */
    public long games(int season) {
        return database.number("SELECT count(*) FROM game WHERE season = ?", season);
    }

    // ---- versions of bots ------------------------------------------------------------------------

    /** All versions, by number. */
    public List<Version> versions() {
        return database.list("SELECT v.id, bot, number, command, random, "
            + "(SELECT hash FROM identity i WHERE i.version = v.id ORDER BY i.began, hash LIMIT 1), "
            + "max(began, coalesce((SELECT max(played) FROM game WHERE id IN (SELECT max(game) FROM seat WHERE "
            + "season IN (SELECT id FROM season) AND version = v.id GROUP BY season)), 0)), paused, "
            + "time_limit FROM version v ORDER BY v.id", row -> new Version(row.getInt(1), row.getString(2),
            row.getInt(3), row.getString(4), row.getBoolean(5), row.getString(6), row.getLong(7), row.getBoolean(8),
            row.getString(9)));
    }

    public Optional<Version> version(String identity) {
        Object id = database.value("SELECT version FROM identity WHERE hash = ?", identity);
        return id == null ? Optional.empty()
            : versions().stream().filter(version -> version.id() == ((Number) id).intValue()).findFirst();
    }

    /** The version of a bot that plays or has played last: an earlier one if its program was put back. */
    public Optional<Version> present(String bot) {
        return versions().stream().filter(version -> version.bot().equals(bot))
            .max(Comparator.comparingLong(Version::played).thenComparing(Version::number));
    }

    /** Adds a version. @param timeLimit its own limits, see {@link Version}; or {@code null} */
    public Version add(String bot, String command, String timeLimit, boolean random, String identity, long now) {
        database.inTransaction(() -> {
            database.update("INSERT INTO version (bot, number, command, time_limit, random, began) VALUES (?, 1 + "
                + "(SELECT coalesce(max(number), 0) FROM version WHERE bot = ?), ?, ?, ?, ?)", bot, bot, command,
                timeLimit, random ? 1 : 0, now);
            return addIdentity(database.number("SELECT last_insert_rowid()"), identity, now);
        });
        return version(identity).orElseThrow();
    }

    private List<Long> addIdentity(long version, String identity, long now) {
        database.update("INSERT INTO identity (hash, version, began) VALUES (?, ?, ?)", identity, version, now);
        return RowDigest.sealed(database, VERSION, "UPDATE version SET id = id WHERE id = ?", version);
    }

    /** Another identity of a version: a change that is said to change nothing. */
    public void same(Version version, String identity, long now) {
        database.inTransaction(() -> addIdentity(version.id(), identity, now));
    }

    /** Marks a version as one that draws by lot. @return the version with its mark */
    public Version markRandom(Version version) {
        update("UPDATE version SET random = 1 WHERE id = ?", version.id());
        return version(version.identity()).orElseThrow();
    }

    /** Notes whether a version is paused. */
    public void pause(int version, boolean paused) {
        update("UPDATE version SET paused = ? WHERE id = ?", paused ? 1 : 0, version);
    }

    /** All versions of a bot under another name. */
    public void rename(String bot, String name) {
        update("UPDATE version SET bot = ? WHERE bot = ?", name, bot);
    }

    private void update(String versions, Object... values) {
        database.inTransaction(() -> RowDigest.sealed(database, VERSION, versions, values));
    }

    /** Returns how many games of any season a version has that count. */
    public long gamesOf(int version) {
        return database.number("SELECT count(*) FROM seat WHERE season IN (SELECT id FROM season) AND version = ?",
            version);
    }

    // ---- games -----------------------------------------------------------------------------------

    /** Makes a game that is there part of a decision. */
    public void adopt(byte[] name, int decision) {
        database.inTransaction(() -> gameRows.adopt(name, decision));
    }

    /**
     * Stores games of no decision or one that is there, all or none. One that is there already stays as it is.
     *
     * @return how many are new
     */
    public int add(int season, List<StoredGame> games) {
        return add(season, List.of(), games);
    }

    /** Stores decisions, and games of these or earlier ones, all or nothing. @return how many games are new */
    int add(int season, List<Decision.News> news, List<StoredGame> games) {
        try {
            return database.inTransaction(() -> {
                news.forEach(each -> decisionRows.add(season, each));
                return gameRows.add(season, games);
            });
        } catch (InputException failed) {
            gameRows.forget();
            throw failed;
        }
    }

    /** Forgets where a replay was. */
    public void withoutReplays(List<Long> games) {
        database.inTransaction(() -> games.stream().map(game -> RowDigest.sealed(database, "game", "UPDATE game SET "
            + "replay = NULL WHERE id = ?", game)).toList());
    }

    /** Rows that no version of the program writes, at most so many. */
    public List<BadRow> badRows(int most) {
        return database.inSnapshot(() -> RowCheck.of(database, most));
    }

    /**
     * Deletes bad rows, and those that need them, until none is left. A decision that is lost is known by its games.
     *
     * @return how many
     */
    public long dropBadRows() {
        database.refer(false);                         // what needs a row may be deleted behind it
        return database.inTransaction(() -> {
            long dropped = 0;
            List<BadRow> rows;
            do {
                decisionRows.ofGames();
                rows = RowCheck.of(database, Integer.MAX_VALUE);
                rows.forEach(row -> database.execute("DELETE FROM " + row.table() + " WHERE " + row.key()));
                dropped += rows.size();
                gameRows.forget();
            } while (!rows.isEmpty());
            return dropped;
        });
    }

    /** Number of games of all seasons. */
    public long games() {
        return database.number("SELECT count(*) FROM game");
    }

    /**
     * Returns {@code ok} if the file is whole, as SQLite sees it, or what is wrong; values of another type than their
     * column's, or against its rules, are bad rows, whole as they are.
     */
    public String integrity() {
        return database.list("PRAGMA integrity_check", row -> row.getString(1)).stream()
            .filter(found -> !found.matches("\\S+ value in \\S+|CHECK .*")).findFirst().orElse("ok");
    }

    /**
     * Copies everything into a new file, also while games are being stored.
     *
     * @throws InputException if that cannot be written
     */
    public void backup(Path file) {
        // On a connection of its own: it must have no other statement, and others go on meanwhile.
        try (Database own = Database.open(new LeagueFolder(database.file().toAbsolutePath().getParent()), false,
                false)) {
            own.update("VACUUM INTO ?", file.toString());
        }
    }

    /** The copy of an older form that has been brought up to date when it was opened; empty if it was up to date. */
    public Optional<Path> before() {
        return Optional.ofNullable(database.before());
    }

    @Override
    public void close() {
        database.close();
    }
}

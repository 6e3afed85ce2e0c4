package steward.league.store;

import java.nio.file.Path;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Types;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;

/**
 * The games of a league: seasons, versions of bots, games. Every method is one transaction; all may be called by any
 * thread. Each throws {@link InputException} if the database cannot be used.
 */
public final class GameStore implements AutoCloseable {

    private final Database database;
    private final Map<String, Long> lineups = new HashMap<>();
    private final Map<String, Long> machines = new HashMap<>();

    /**
     * A version of a bot.
     *
     * @param id       its number in the store
     * @param bot      the bot's name
     * @param number   1 for the first of this bot
     * @param command  as it was first called
     * @param random   whether it was said to draw by lot
     * @param identity the first that it had: the one in names of games
     */
    public record Version(int id, String bot, int number, String command, boolean random, String identity) {

        /** The bot's name, from the second version on with its number. */
        public String display() {
            return number == 1 ? bot : bot + "#" + number;
        }
    }

    GameStore(Database database) {
        this.database = database;
    }

    /** For reading alone; other programs may write meanwhile. */
    public static GameStore read(LeagueFolder folder) {
        return new GameStore(Database.open(folder, false, false));
    }

    /** For reading, where nobody else uses it, on a disk of any machine; {@code null} if there are no games yet. */
    public static GameStore unused(LeagueFolder folder) {
        Database database = Database.unused(folder);
        return database == null ? null : new GameStore(database);
    }

    /** For reading and writing; made if it is not there. */
    public static GameStore write(LeagueFolder folder) {
        return new GameStore(Database.open(folder, true, false));
    }

    /** As {@link #write}; each game is on the disk before the next, also if the power fails. */
    public static GameStore durable(LeagueFolder folder) {
        return new GameStore(Database.open(folder, true, true));
    }

    Database database() {
        return database;
    }

    // ---- seasons ---------------------------------------------------------------------------------

    /** The number of a season that is there, by its key. */
    public Optional<Integer> season(Season season) {
        return database.with(() -> Optional.ofNullable(database.value("SELECT id FROM season WHERE key = ?",
            season.key())).map(id -> ((Number) id).intValue()));
    }

    /** The season that was opened last, if there is any. */
    public Optional<Season> lastSeason() {
        return database.with(() -> {
            try (ResultSet row = database.query("SELECT scene, scene_key, limits, rules, players, "
                + "lower_is_better FROM season ORDER BY opened DESC, id DESC LIMIT 1")) {
                return row.next() ? Optional.of(Season.of(row.getString(1), row.getString(2), row.getString(3),
                    row.getString(4), row.getInt(5), row.getBoolean(6))) : Optional.empty();
            }
        });
    }

    /** Opens a season, new or again; it is the last one then. */
    public int open(Season season) {
        return database.inTransaction(() -> {
            long order = 1 + ((Number) database.value("SELECT coalesce(max(opened), 0) FROM season")).longValue();
            database.update("INSERT INTO season (key, scene, scene_key, limits, rules, players, "
                + "lower_is_better, opened) VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (key) DO UPDATE "
                + "SET opened = excluded.opened", season.key(),
                season.sceneName(), season.sceneKey(), season.limits(), season.rules(), season.players(),
                season.lowerScoreIsBetter() ? 1 : 0, order);
            return ((Number) database.value("SELECT id FROM season WHERE key = ?", season.key())).intValue();
        });
    }

    /** How many games a season has, of whatever kind. */
    public long games(int season) {
        return database.with(() -> ((Number) database.value("SELECT count(*) FROM game WHERE season = ?", season))
            .longValue());
    }

    // ---- versions of bots ------------------------------------------------------------------------

    /** All versions, by number. */
    public List<Version> versions() {
        return database.with(() -> {
            List<Version> versions = new ArrayList<>();
            try (ResultSet row = database.query("SELECT v.id, bot, number, command, random, "
                + "(SELECT hash FROM identity i WHERE i.version = v.id ORDER BY i.began, hash LIMIT 1) "
                + "FROM version v ORDER BY v.id")) {
                while (row.next()) {
                    versions.add(new Version(row.getInt(1), row.getString(2), row.getInt(3), row.getString(4),
                        row.getBoolean(5), row.getString(6)));
                }
            }
            return versions;
        });
    }

    /** The version of an identity. */
    public Optional<Version> version(String identity) {
        Object id = database.with(() -> database.value("SELECT version FROM identity WHERE hash = ?", identity));
        return id == null ? Optional.empty()
            : versions().stream().filter(version -> version.id() == ((Number) id).intValue()).findFirst();
    }

    /** The newest version of a bot. */
    public Optional<Version> newest(String bot) {
        return versions().stream().filter(version -> version.bot().equals(bot)).reduce((one, other) -> other);
    }

    /** A new version of a bot. */
    public Version add(String bot, String command, boolean random, String identity, long now) {
        database.inTransaction(() -> {
            database.update("INSERT INTO version (bot, number, command, random, began) VALUES (?, 1 + (SELECT "
                + "coalesce(max(number), 0) FROM version WHERE bot = ?), ?, ?, ?)", bot, bot, command, random ? 1 : 0,
                now);
            return database.update("INSERT INTO identity (hash, version, began) VALUES (?, last_insert_rowid(), ?)",
                identity, now);
        });
        return version(identity).orElseThrow();
    }

    /** Takes over the versions and identities of another store, with their numbers; this one must have none. */
    public void copyVersions(GameStore other) {
        List<Object[]> versions = other.rows("SELECT id, bot, number, command, random, began FROM version", 6);
        List<Object[]> identities = other.rows("SELECT hash, version, began FROM identity", 3);
        database.inTransaction(() -> {
            for (Object[] row : versions) {
                database.update("INSERT INTO version (id, bot, number, command, random, began) "
                    + "VALUES (?, ?, ?, ?, ?, ?)", row);
            }
            for (Object[] row : identities) {
                database.update("INSERT INTO identity (hash, version, began) VALUES (?, ?, ?)", row);
            }
            return null;
        });
    }

    private List<Object[]> rows(String sql, int columns) {
        return database.with(() -> {
            List<Object[]> rows = new ArrayList<>();
            try (ResultSet row = database.query(sql)) {
                while (row.next()) {
                    Object[] values = new Object[columns];
                    for (int k = 0; k < columns; k++) {
                        values[k] = row.getObject(k + 1);
                    }
                    rows.add(values);
                }
            }
            return rows;
        });
    }

    /** Another identity of a version: a change that is said to change nothing. */
    public void same(Version version, String identity, long now) {
        database.inTransaction(() -> database.update("INSERT INTO identity (hash, version, began) VALUES (?, ?, ?)",
            identity, version.id(), now));
    }

    /** All versions of a bot under another name. */
    public void rename(String bot, String name) {
        database.inTransaction(() -> database.update("UPDATE version SET bot = ? WHERE bot = ?", name, bot));
    }

    /** How many games of any season a version has that count. */
    public long gamesOf(int version) {
        return database.with(() -> ((Number) database.value("SELECT count(*) FROM seat WHERE season IN "
            + "(SELECT id FROM season) AND version = ?", version)).longValue());
    }

    // ---- games -----------------------------------------------------------------------------------

    /** Whether a game of this name is there. */
    public boolean has(byte[] name) {
        return database.with(() -> database.value("SELECT 1 FROM game WHERE name = ?", (Object) name) != null);
    }

    /** Ranks by seat of the game of this name, and scores; empty if it is not there or does not count. */
    public Optional<Outcome> outcome(byte[] name) {
        return database.with(() -> {
            List<Integer> ranks = new ArrayList<>();
            List<Double> scores = new ArrayList<>();
            try (ResultSet row = database.query("SELECT s.rank, s.score FROM game g JOIN seat s ON s.game = g.id "
                + "WHERE g.name = ? AND g.counts = 1 ORDER BY s.seat", (Object) name)) {
                while (row.next()) {
                    ranks.add(row.getInt(1));
                    scores.add(row.getDouble(2));
                }
            }
            return ranks.isEmpty() ? Optional.empty() : Optional.of(new Outcome(ranks, scores));
        });
    }

    /**
     * How a game ended, by seat.
     *
     * @param ranks  0 is best
     * @param scores the game's own
     */
    public record Outcome(List<Integer> ranks, List<Double> scores) {

        /** Copies. */
        public Outcome {
            ranks = List.copyOf(ranks);
            scores = List.copyOf(scores);
        }
    }

    /** Makes a game that is there part of a decision. */
    public void adopt(byte[] name, int decision) {
        database.inTransaction(() -> database.update(
            "UPDATE game SET decision = ? WHERE name = ? AND decision IS NULL", decision, name));
    }

    /**
     * Stores games, all or none. One that is there already stays as it is.
     *
     * @return how many are new
     */
    public int add(int season, List<StoredGame> games) {
        try {
            return database.inTransaction(() -> addWithin(season, games));
        } catch (InputException failed) {
            lineups.clear();                           // what was rolled back may have been among them
            machines.clear();
            throw failed;
        }
    }

    /** The same within a transaction that has begun. */
    int addWithin(int season, List<StoredGame> games) throws SQLException {
        int added = 0;
        for (StoredGame game : games) {
            added += add(season, game) ? 1 : 0;
        }
        return added;
    }

    private boolean add(int season, StoredGame game) throws SQLException {
        PreparedStatement row = database.statement("INSERT INTO game (name, season, decision, seed, lineup, ranks, "
            + "attempt, counts, turns, problem, played, machine, replay) "
            + "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (name) DO NOTHING");
        row.setBytes(1, game.name());
        row.setInt(2, season);
        if (game.decision() < 0) {
            row.setNull(3, Types.INTEGER);
        } else {
            row.setInt(3, game.decision());
        }
        row.setLong(4, game.seed());
        row.setLong(5, lineup(game));
        row.setString(6, game.ranks());
        row.setInt(7, game.attempt());
        row.setInt(8, game.counts() ? 1 : 0);
        row.setInt(9, game.turns());
        row.setString(10, game.problem());
        row.setLong(11, game.played());
        row.setLong(12, machine(game.machine()));
        row.setString(13, game.replay());
        if (row.executeUpdate() == 0) {
            return false;
        }
        long id = ((Number) database.value("SELECT last_insert_rowid()")).longValue();
        for (int seat = 0; seat < game.seats().size(); seat++) {
            addSeat(season, id, seat, game.seats().get(seat));
        }
        return true;
    }

    private void addSeat(int season, long game, int place, StoredSeat seat) throws SQLException {
        PreparedStatement row = database.statement("INSERT INTO seat (season, version, game, seat, rank, score, fault, "
            + "answers, mean_nanos, worst_nanos, first_nanos) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
        row.setInt(1, season);
        row.setInt(2, seat.version());
        row.setLong(3, game);
        row.setInt(4, place);
        row.setInt(5, seat.rank());
        row.setDouble(6, seat.score());
        row.setString(7, seat.fault());
        row.setInt(8, seat.answers());
        row.setLong(9, seat.meanNanos());
        row.setLong(10, seat.worstNanos());
        row.setLong(11, seat.firstNanos());
        row.executeUpdate();
    }

    private long lineup(StoredGame game) throws SQLException {
        String versions = Arrays.stream(game.lineup()).mapToObj(Integer::toString).collect(Collectors.joining(" "));
        return number(lineups, "lineup", "versions", versions);
    }

    private long machine(String name) throws SQLException {
        return number(machines, "machine", "name", name);
    }

    /** The number of a text in a table of texts; it is known from then on only if the transaction succeeds. */
    private long number(Map<String, Long> known, String table, String column, String text) throws SQLException {
        Long number = known.get(text);
        if (number != null) {
            return number;
        }
        String find = "SELECT id FROM " + table + " WHERE " + column + " = ?";
        Object found = database.value(find, text);
        if (found == null) {
            database.update("INSERT INTO " + table + " (" + column + ") VALUES (?)", text);
            return ((Number) database.value(find, text)).longValue();
        }
        known.put(text, ((Number) found).longValue());
        return ((Number) found).longValue();
    }

    /**
     * A game that counted and was set aside.
     *
     * @param decision or -1
     * @param seed     its seed
     * @param lineup   the versions by seat, apart by blanks
     */
    public record SetAside(int decision, long seed, String lineup) {
    }

    /**
     * Sets games of a machine aside: they stay, under other names, have no result, and belong to no decision.
     *
     * @param machine how its name begins
     * @return those that counted
     */
    public List<SetAside> setAside(int season, String machine, String why) {
        String of = " WHERE season = ? AND machine IN (SELECT id FROM machine WHERE substr(name, 1, length(?)) = ?)";
        return database.inTransaction(() -> {
            List<SetAside> games = new ArrayList<>();
            try (ResultSet row = database.query("SELECT coalesce(decision, -1), seed, (SELECT versions FROM lineup l "
                + "WHERE l.id = game.lineup) FROM game" + of + " AND counts = 1", season, machine, machine)) {
                while (row.next()) {
                    games.add(new SetAside(row.getInt(1), row.getLong(2), row.getString(3)));
                }
            }
            database.update("UPDATE game SET name = randomblob(16), decision = NULL, counts = 0, problem = ?" + of
                + " AND problem IS NULL", why, season, machine, machine);
            return games;
        });
    }

    /** Forgets where a replay was. */
    public void withoutReplays(List<Long> games) {
        database.inTransaction(() -> {
            for (long game : games) {
                database.update("UPDATE game SET replay = NULL WHERE id = ?", game);
            }
            return null;
        });
    }

    /** Whether the file is whole, as SQLite sees it: {@code ok}, or what is wrong. */
    public String integrity() {
        return (String) database.with(() -> database.value("PRAGMA integrity_check"));
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
            own.with(() -> own.update("VACUUM INTO ?", file.toString()));
        }
    }

    /** Where it is. */
    public Path file() {
        return database.file();
    }

    @Override
    public void close() {
        database.close();
    }
}

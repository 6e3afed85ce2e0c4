package steward.league.store;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import steward.files.InputException;
import steward.files.OutputFiles;

/**
 * The form of the database, with its number in {@code PRAGMA user_version}; docs/league.md says what is in each table.
 * Form 4, that of Steward 0.2.0, is copied, then brought up to date in one transaction; others are refused.
 */
final class SchemaVersion {

    /** "Stwd": tells a league's database from others. */
    static final int APPLICATION = 0x53747764;

    private static final int OLDEST = 4;
    /** The newest one. */
    static final int NEWEST = 5;

    private static final List<String> FORM_4 = List.of(
        """
        CREATE TABLE season (
          id INTEGER PRIMARY KEY,
          key TEXT NOT NULL UNIQUE,
          scene TEXT NOT NULL,
          scene_key TEXT NOT NULL,
          limits TEXT NOT NULL,
          rules TEXT NOT NULL,
          players INTEGER NOT NULL,
          opened INTEGER NOT NULL,
          lower_is_better INTEGER NOT NULL)""",
        """
        CREATE TABLE version (
          id INTEGER PRIMARY KEY,
          bot TEXT NOT NULL,
          number INTEGER NOT NULL,
          command TEXT NOT NULL,
          random INTEGER NOT NULL,
          began INTEGER NOT NULL,
          UNIQUE (bot, number))""",
        """
        CREATE TABLE identity (
          hash TEXT PRIMARY KEY,
          version INTEGER NOT NULL REFERENCES version,
          began INTEGER NOT NULL) WITHOUT ROWID""",
        "CREATE TABLE machine (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE)",
        "CREATE TABLE lineup (id INTEGER PRIMARY KEY, versions TEXT NOT NULL UNIQUE)",
        """
        CREATE TABLE game (
          id INTEGER PRIMARY KEY,
          name BLOB NOT NULL UNIQUE,
          season INTEGER NOT NULL REFERENCES season,
          decision INTEGER,
          seed INTEGER NOT NULL,
          lineup INTEGER NOT NULL REFERENCES lineup,
          ranks TEXT NOT NULL,
          attempt INTEGER NOT NULL,
          counts INTEGER NOT NULL,
          turns INTEGER NOT NULL,
          problem TEXT,
          played INTEGER NOT NULL,
          machine INTEGER NOT NULL REFERENCES machine,
          replay TEXT,
          transcript INTEGER)""",
        """
        CREATE TABLE seat (
          season INTEGER NOT NULL REFERENCES season,
          version INTEGER NOT NULL REFERENCES version,
          game INTEGER NOT NULL REFERENCES game,
          seat INTEGER NOT NULL,
          rank INTEGER NOT NULL,
          score REAL NOT NULL,
          fault TEXT,
          answers INTEGER NOT NULL,
          mean_nanos INTEGER NOT NULL,
          worst_nanos INTEGER NOT NULL,
          first_nanos INTEGER NOT NULL,
          own TEXT,
          PRIMARY KEY (season, version, game, seat)) WITHOUT ROWID""",
        "CREATE INDEX game_by_result ON game (season, counts, lineup, ranks)",
        "CREATE INDEX seat_by_game ON seat (game, seat)",
        "CREATE INDEX game_without_result ON game (id) WHERE counts = 0",
        "CREATE INDEX game_with_replay ON game (id) WHERE replay IS NOT NULL");

    /** Rows of form 4 had no digests, and values of any type. */
    private static final List<String> FROM_4 = List.of(
        "ALTER TABLE version ADD COLUMN paused INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE version ADD COLUMN time_limit TEXT",
        "ALTER TABLE season ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE version ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE machine ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE lineup ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE game ADD COLUMN digest INTEGER NOT NULL DEFAULT 0");

    /** Makes tables strict, also those with values of other types: what SQLite stores of a strict table is the same. */
    private static final List<String> STRICT = List.of("PRAGMA writable_schema = ON",
        "UPDATE sqlite_schema SET sql = sql || iif(sql LIKE '%WITHOUT ROWID', ', STRICT', ' STRICT') WHERE type = "
            + "'table' AND name IN ('season', 'version', 'identity', 'machine', 'lineup', 'game', 'seat')",
        "PRAGMA writable_schema = RESET");

    /**
     * Refuses what is no league's database, or of a form that this program does not know.
     *
     * @return whether there is nothing in it yet, or it is of form 4
     */
    static boolean isBehind(Connection connection, Path file) throws SQLException {
        int found = number(connection, "user_version");
        if (found > 0 ? number(connection, "application_id") != APPLICATION
                : number(connection, "schema_version") > 0) {
            throw new InputException(file + ": found a database of another program, expected a league's");
        }
        if (found > NEWEST || found > 0 && found < OLDEST) {
            throw new InputException(file + ": found a database of form " + found + ", expected " + OLDEST + " or "
                + NEWEST + (found > NEWEST ? ": it is of a newer Steward" : ": 'steward league run' of Steward 0.2.0 "
                + "brings it to form " + OLDEST));
        }
        return found < NEWEST;
    }

    /**
     * Brings it up to date.
     *
     * @return a copy of it as it was, or {@code null} if there was nothing in it
     */
    static Path migrate(Database database) throws SQLException {
        int before = number(database.connection(), "user_version");
        Path copy = before == 0 ? null : OutputFiles.copyBeside(database.file(), "before-form-" + NEWEST);
        if (copy != null) {
            database.update("VACUUM INTO ?", copy.toString());
        }
        database.execute("BEGIN IMMEDIATE");
        if (before == 0) {
            for (String table : FORM_4) {
                database.execute(table);
            }
        }
        for (String change : FROM_4) {
            database.execute(change);
        }
        RowDigest.sealAll(database, RowCheck.withoutDigests(database));
        for (String change : STRICT) {
            database.execute(change);
        }
        database.execute("PRAGMA application_id = " + APPLICATION);
        database.execute("PRAGMA user_version = " + NEWEST);
        database.execute("COMMIT");
        return copy;
    }

    static int number(Connection connection, String pragma) throws SQLException {
        try (Statement statement = connection.createStatement();
             ResultSet result = statement.executeQuery("PRAGMA " + pragma)) {
            return result.getInt(1);
        }
    }
}

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
 * An older form is copied, then brought up to date step by step in one transaction; a newer one is refused.
 */
final class SchemaVersion {

    /** "Stwd": tells a league's database from others. */
    static final int APPLICATION = 0x53747764;

    /** From nothing to 1, from 1 to 2, and so on. */
    private static final List<List<String>> STEPS = List.of(List.of(
        """
        CREATE TABLE season (
          id INTEGER PRIMARY KEY,
          key TEXT NOT NULL UNIQUE,
          scene TEXT NOT NULL,
          scene_key TEXT NOT NULL,
          limits TEXT NOT NULL,
          rules TEXT NOT NULL,
          players INTEGER NOT NULL,
          opened INTEGER NOT NULL)""",
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
          replay TEXT)""",
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
          PRIMARY KEY (season, version, game, seat)) WITHOUT ROWID""",
        "CREATE INDEX game_by_result ON game (season, counts, lineup, ranks)",
        "CREATE INDEX seat_by_game ON seat (game, seat)",
        "CREATE INDEX game_without_result ON game (id) WHERE counts = 0",
        "CREATE INDEX game_with_replay ON game (id) WHERE replay IS NOT NULL"),
        // Form 1 compared all scores as if higher ones were better; its only game for one player was Search Race.
        List.of("ALTER TABLE season ADD COLUMN lower_is_better INTEGER NOT NULL DEFAULT 0",
            "UPDATE season SET lower_is_better = 1 WHERE players = 1"),
        // Earlier games get theirs from their replays, where these are kept.
        List.of("ALTER TABLE game ADD COLUMN transcript INTEGER", "ALTER TABLE seat ADD COLUMN own TEXT"),
        // Form 3 rated games in which all players failed in the same turn, see StoredGame.allFailed.
        List.of("UPDATE game SET counts = 2 WHERE counts = 1 AND id IN (SELECT game FROM seat GROUP BY game "
            + "HAVING count(*) > 1 AND count(fault) = count(*) AND min(answers) = max(answers))"),
        // Rows of form 4 had no digests, and values of any type.
        List.of("ALTER TABLE version ADD COLUMN paused INTEGER NOT NULL DEFAULT 0",
            "ALTER TABLE version ADD COLUMN time_limit TEXT",
            "ALTER TABLE season ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
            "ALTER TABLE version ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
            "ALTER TABLE machine ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
            "ALTER TABLE lineup ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
            "ALTER TABLE game ADD COLUMN digest INTEGER NOT NULL DEFAULT 0"));

    /** Makes tables strict, also those with values of other types: what SQLite stores of a strict table is the same. */
    private static final List<String> STRICT = List.of("PRAGMA writable_schema = ON",
        "UPDATE sqlite_schema SET sql = sql || iif(sql LIKE '%WITHOUT ROWID', ', STRICT', ' STRICT') WHERE type = "
            + "'table' AND name IN ('season', 'version', 'identity', 'machine', 'lineup', 'game', 'seat')",
        "PRAGMA writable_schema = RESET");

    /** The newest one. */
    static final int NEWEST = STEPS.size();

    /**
     * Refuses what is no league's database, or a newer one's.
     *
     * @return whether there is nothing in it yet, or it is of an older form
     */
    static boolean isBehind(Connection connection, Path file) throws SQLException {
        int found = number(connection, "user_version");
        if (found > 0 ? number(connection, "application_id") != APPLICATION
                : number(connection, "schema_version") > 0) {
            throw new InputException(file + ": found a database of another program, expected a league's");
        }
        if (found > NEWEST) {
            throw new InputException(file + ": found a database of form " + found + " of a newer Steward, expected "
                + NEWEST + " or older");
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
        for (int step = number(database.connection(), "user_version"); step < NEWEST; step++) {
            for (String change : STEPS.get(step)) {
                database.execute(change);
            }
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

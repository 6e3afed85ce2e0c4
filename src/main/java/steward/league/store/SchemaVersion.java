package steward.league.store;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.files.InputException;
import steward.files.OutputFiles;

/**
 * Version of the database's form, stored as {@code PRAGMA user_version}; docs/tables/league-database.md describes each
 * table. A database of form 4 (Steward 0.2.0) is copied, then brought up to date in one transaction; others are
 * refused.
 */
final class SchemaVersion {

    /** "Stwd": tells a league's database from others. */
    static final int APPLICATION = 0x53747764;

    /** The statement that asks for the form. */
    static final String FORM = "PRAGMA user_version";
    private static final int OLDEST = 4;
    /** The newest one. */
    static final int NEWEST = 5;

    /**
     * Its tables, by name, each before those that refer to it. What a column holds is said behind it where its type
     * does not say all: {@link RowCheck} reads these lines, too.
     */
    static final Map<String, String> TABLES = Stream.of(
        """
        CREATE TABLE season (
          id INTEGER PRIMARY KEY CHECK (id BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          key TEXT NOT NULL UNIQUE,
          scene TEXT NOT NULL,
          scene_key TEXT NOT NULL,
          limits TEXT NOT NULL,
          rules TEXT NOT NULL,
          players INTEGER NOT NULL CHECK (players BETWEEN 1 AND 16), -- 1 to 16
          opened INTEGER NOT NULL CHECK (opened >= 0), -- a whole number from 0 on
          lower_is_better INTEGER NOT NULL DEFAULT 0 CHECK (lower_is_better IN (0, 1)), -- 0 or 1
          digest INTEGER NOT NULL DEFAULT 0
        ) STRICT""",
        """
        CREATE TABLE version (
          id INTEGER PRIMARY KEY CHECK (id BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          bot TEXT NOT NULL,
          number INTEGER NOT NULL CHECK (number BETWEEN 1 AND 2147483647), -- a whole number from 1 on
          command TEXT NOT NULL,
          random INTEGER NOT NULL CHECK (random IN (0, 1)), -- 0 or 1
          began INTEGER NOT NULL CHECK (began >= 0), -- a whole number from 0 on
          paused INTEGER NOT NULL DEFAULT 0 CHECK (paused IN (0, 1)), -- 0 or 1
          time_limit TEXT,
          digest INTEGER NOT NULL DEFAULT 0,
          UNIQUE (bot, number)
        ) STRICT""",
        """
        CREATE TABLE identity (
          hash TEXT PRIMARY KEY,
          version INTEGER NOT NULL REFERENCES version,
          began INTEGER NOT NULL CHECK (began >= 0) -- a whole number from 0 on
        ) WITHOUT ROWID, STRICT""",
        """
        CREATE TABLE machine (
          id INTEGER PRIMARY KEY,
          name TEXT NOT NULL UNIQUE,
          digest INTEGER NOT NULL DEFAULT 0
        ) STRICT""",
        """
        CREATE TABLE lineup (
          id INTEGER PRIMARY KEY CHECK (id BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          versions TEXT NOT NULL UNIQUE,
          digest INTEGER NOT NULL DEFAULT 0
        ) STRICT""",
        """
        CREATE TABLE decision (
          season INTEGER NOT NULL REFERENCES season,
          number INTEGER NOT NULL CHECK (number BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          seed INTEGER NOT NULL,
          lineup INTEGER NOT NULL REFERENCES lineup,
          paused TEXT,
          dropped INTEGER NOT NULL CHECK (dropped IN (0, 1)), -- 0 or 1
          digest INTEGER NOT NULL,
          PRIMARY KEY (season, number)
        ) WITHOUT ROWID, STRICT""",
        """
        CREATE TABLE game (
          id INTEGER PRIMARY KEY,
          name BLOB NOT NULL UNIQUE CHECK (length(name) = 16), -- 16 bytes
          season INTEGER NOT NULL REFERENCES season,
          decision INTEGER CHECK (decision BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          seed INTEGER NOT NULL,
          lineup INTEGER NOT NULL REFERENCES lineup,
          ranks TEXT NOT NULL,
          attempt INTEGER NOT NULL CHECK (attempt BETWEEN 1 AND 2147483647), -- a whole number from 1 on
          counts INTEGER NOT NULL CHECK (counts BETWEEN 0 AND 2), -- 0, 1 or 2
          turns INTEGER NOT NULL CHECK (turns BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          problem TEXT CHECK (problem IS NULL OR counts = 0), -- nothing, as the game counts
          played INTEGER NOT NULL CHECK (played >= 0), -- a whole number from 0 on
          machine INTEGER NOT NULL REFERENCES machine,
          replay TEXT,
          transcript INTEGER,
          digest INTEGER NOT NULL DEFAULT 0,
          FOREIGN KEY (season, decision) REFERENCES decision (season, number)
        ) STRICT""",
        """
        CREATE TABLE seat (
          season INTEGER NOT NULL REFERENCES season,
          version INTEGER NOT NULL REFERENCES version,
          game INTEGER NOT NULL REFERENCES game,
          seat INTEGER NOT NULL CHECK (seat BETWEEN 0 AND 15), -- a seat of the game
          rank INTEGER NOT NULL CHECK (rank BETWEEN 0 AND 15), -- a rank of the game
          score REAL NOT NULL CHECK (score > -9e999 AND score < 9e999), -- a finite number
          fault TEXT,
          answers INTEGER NOT NULL CHECK (answers BETWEEN 0 AND 2147483647), -- a whole number from 0 to 2147483647
          mean_nanos INTEGER NOT NULL CHECK (mean_nanos >= 0), -- a whole number from 0 on
          worst_nanos INTEGER NOT NULL CHECK (worst_nanos >= 0), -- a whole number from 0 on
          first_nanos INTEGER NOT NULL CHECK (first_nanos >= 0), -- a whole number from 0 on
          own TEXT,
          PRIMARY KEY (season, version, game, seat)
        ) WITHOUT ROWID, STRICT""").collect(Collectors.toMap(sql -> sql.split(" ")[2], sql -> sql,
            (one, other) -> one, LinkedHashMap::new));

    private static final String ALL_FAILED = "CREATE INDEX game_all_failed ON game (id) WHERE counts = 2";
    private static final List<String> INDEXES = List.of(
        "CREATE INDEX seat_by_game ON seat (game, seat)",
        "CREATE INDEX game_without_result ON game (id) WHERE counts = 0",
        ALL_FAILED, "CREATE INDEX game_with_replay ON game (id) WHERE replay IS NOT NULL");

    /** Columns that form 4 did not have. */
    private static final List<String> ADDED = List.of("version ADD COLUMN paused INTEGER NOT NULL DEFAULT 0",
        "version ADD COLUMN time_limit TEXT", "season ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
        "version ADD COLUMN digest INTEGER NOT NULL DEFAULT 0", "machine ADD COLUMN digest INTEGER NOT NULL DEFAULT 0",
        "lineup ADD COLUMN digest INTEGER NOT NULL DEFAULT 0", "game ADD COLUMN digest INTEGER NOT NULL DEFAULT 0");

    /**
     * Refuses what is no league's database, or of a form that this program does not know.
     *
     * @return whether there is nothing in it yet, or it is of form 4
     */
    static boolean isBehind(Database database) {
        long found = database.number(FORM);
        if (found > 0 ? database.number("PRAGMA application_id") != APPLICATION
                : database.number("PRAGMA schema_version") > 0) {
            throw new InputException(database.file() + ": found a database of another program, expected a league's");
        }
        if (found > NEWEST || found > 0 && found < OLDEST) {
            throw new InputException(database.file() + ": found a database of form " + found + ", expected " + OLDEST
                + " or " + NEWEST + (found > NEWEST ? ": it is of a newer Steward" : ": 'steward league run' of "
                + "Steward 0.2.0 brings it to form " + OLDEST));
        }
        return found < NEWEST;
    }

    /** Brings it up to date. @return a copy of it as it was, or {@code null} if there was nothing in it */
    static Path migrate(Database database) {
        boolean isNew = database.number(FORM) == 0;
        Path copy = isNew ? null : OutputFiles.copyBeside(database.file(), "before-form-" + NEWEST);
        if (copy != null) {
            database.update("VACUUM INTO ?", copy.toString());
        }
        return database.inTransaction(() -> {
            if (isNew) {
                TABLES.values().forEach(database::execute);
                INDEXES.forEach(database::execute);
            } else {
                from4(database);
            }
            database.execute("PRAGMA application_id = " + APPLICATION);
            database.execute(FORM + " = " + NEWEST);
            return copy;
        });
    }

    /**
     * Rows stay where they are, also those that the rules refuse: {@link RowCheck} finds these. What SQLite stores of a
     * strict table with rules is the same.
     */
    private static void from4(Database database) {
        ADDED.forEach(column -> database.execute("ALTER TABLE " + column));
        database.execute("DROP INDEX game_by_result");
        database.execute(ALL_FAILED);
        database.execute(TABLES.get("decision"));
        new DecisionRows(database, new TextRows(database, "lineup", "versions")).ofGames();
        database.execute("UPDATE game SET decision = NULL WHERE seed <> (SELECT seed FROM decision o WHERE o.season = "
            + "game.season AND o.number = game.decision)");    // imported ones
        RowDigest.sealAll(database, RowCheck.withoutDigests(database));
        database.execute("PRAGMA writable_schema = ON");
        TABLES.forEach((name, table) -> database.update("UPDATE sqlite_schema SET sql = ? WHERE type = 'table' AND "
            + "name = ?", table, name));
        database.execute("PRAGMA writable_schema = RESET");
    }
}

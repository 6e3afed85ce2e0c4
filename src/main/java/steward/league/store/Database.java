package steward.league.store;

import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sqlite.SQLiteConfig;
import org.sqlite.SQLiteErrorCode;
import org.sqlite.SQLiteException;
import org.sqlite.SQLiteOpenMode;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;

/**
 * Connection to a league's SQLite database, which translates its errors for a person. Users take turns by synchronising
 * on it.
 */
final class Database implements AutoCloseable {

    /** How long another program's transaction is waited for, in milliseconds. */
    private static final int PATIENCE_MS = 5000;
    /** SQLite's own cache, in KiB: the pages of the indexes of some 100,000 games. */
    private static final int CACHE_KIB = 32 << 10;

    private final Path file;
    private final Connection connection;
    private final Map<String, PreparedStatement> prepared = new HashMap<>();
    /** Copy of an older form that has been brought up to date by this connection, or {@code null}. */
    private Path before;

    /** Work with the database. */
    interface Work<T> {
        T run() throws SQLException;
    }

    /** Reader of a row. */
    interface RowReader {
        void read(ResultSet row) throws SQLException;
    }

    /** Maker of a value from a row. */
    interface RowMaker<T> {
        T make(ResultSet row) throws SQLException;
    }

    private Database(Path file, Connection connection) {
        this.file = file;
        this.connection = connection;
    }

    /**
     * Opens it.
     *
     * @param write   whether it is written to; it is then made if it is not there
     * @param durable whether each transaction is on the disk when it ends, also if the power fails
     * @throws InputException if it cannot be used
     */
    static Database open(LeagueFolder folder, boolean write, boolean durable) {
        return open(folder, write, durable, PATIENCE_MS);
    }

    static Database open(LeagueFolder folder, boolean write, boolean durable, int patienceMs) {
        Path file = folder.database();
        if (!write && Files.notExists(file)) {
            throw new InputException(file + ": found no such file, expected the games of the league; "
                + "'steward league run' makes it");
        }
        if (Files.isDirectory(file)) {
            throw new InputException(file + ": found a folder, expected a database");
        }
        refuseUnusable(file, folder.path(), write);
        LeagueFolder.refuseRemote(folder.path());
        Database database = connect(folder, write, patienceMs);
        try {
            database.prepare(write, durable);
            return database;
        } catch (InputException refused) {
            database.close();
            throw refused;
        }
    }

    /** True if a league's database is there, and of an older form. */
    static boolean isBehind(LeagueFolder folder) {
        try (Database database = connect(folder, false, PATIENCE_MS)) {
            return SchemaVersion.isBehind(database) && database.number(SchemaVersion.FORM) > 0;
        }
    }

    private static Database connect(LeagueFolder folder, boolean write, int patienceMs) {
        NativeLibrary.prepare(folder.path());
        Path file = folder.database();
        boolean isImmutable = !write && !Files.isWritable(folder.path())
            && Files.notExists(file.resolveSibling(file.getFileName() + "-wal"));
        SQLiteConfig config = new SQLiteConfig();
        config.setBusyTimeout(patienceMs);
        config.setOpenMode(SQLiteOpenMode.OPEN_URI);
        config.setReadOnly(!write);
        try {
            return new Database(file, config.createConnection("jdbc:sqlite:" + (isImmutable
                ? file.toUri().toString().replace("file:///", "file:/") + "?immutable=1" : file.toString())));
        } catch (SQLException problem) {
            throw meaning(file, problem);
        }
    }

    private static void refuseUnusable(Path file, Path folder, boolean write) {
        if (Files.exists(file) && !Files.isReadable(file)) {
            throw new InputException(file + ": cannot be read: no permission" + OutputFiles.owner(file));
        }
        Path wanted = Files.exists(file) && !Files.isWritable(file) ? file : folder;
        if (write && !Files.isWritable(wanted)) {
            throw new InputException(wanted + ": cannot be written: no permission" + OutputFiles.owner(wanted));
        }
    }

    private void prepare(boolean write, boolean durable) {
        execute("PRAGMA cache_size = -" + CACHE_KIB);
        boolean behind = SchemaVersion.isBehind(this);
        if (write) {
            execute("PRAGMA journal_mode = WAL");
            execute("PRAGMA synchronous = " + (durable ? "FULL" : "NORMAL"));
            before = behind ? SchemaVersion.migrate(this) : null;
            refer(true);
        } else if (behind) {
            throw new InputException(file + ": found " + (number(SchemaVersion.FORM) == 0 ? "an empty database"
                : "a database of an older form") + ", expected one that 'steward league run' has made or 'steward "
                + "league verify' has brought up to date");
        }
    }

    /** Has rows to which others refer kept, or not; between transactions. */
    void refer(boolean kept) {
        execute("PRAGMA foreign_keys = " + (kept ? "ON" : "OFF"));
    }

    /** Translates an error of the database for a person. */
    static InputException meaning(Path file, SQLException problem) {
        SQLiteErrorCode code = problem instanceof SQLiteException known ? known.getResultCode()
            : SQLiteErrorCode.UNKNOWN_ERROR;
        String what = switch (code) {
            case SQLITE_NOTADB -> "found no database, expected one of SQLite";
            case SQLITE_BUSY, SQLITE_BUSY_SNAPSHOT, SQLITE_BUSY_RECOVERY, SQLITE_LOCKED ->
                "found it locked by another program, and it stayed so; nothing was written";
            case SQLITE_FULL -> "the disk is full; what was stored before is whole";
            case SQLITE_READONLY, SQLITE_READONLY_DBMOVED, SQLITE_READONLY_DIRECTORY, SQLITE_READONLY_CANTLOCK,
                SQLITE_READONLY_RECOVERY, SQLITE_READONLY_CANTINIT, SQLITE_PERM -> "it cannot be written: read-only";
            case SQLITE_CANTOPEN, SQLITE_CANTOPEN_ISDIR, SQLITE_CANTOPEN_FULLPATH -> "it cannot be opened";
            case SQLITE_CORRUPT, SQLITE_CORRUPT_INDEX, SQLITE_CORRUPT_VTAB ->
                "found it damaged, expected a whole database; restore a backup, or rescue it with sqlite3's .recover";
            default -> code.name().startsWith("SQLITE_IOERR") ? "the disk cannot be read or written (" + code.name()
                + ")" : String.valueOf(problem.getMessage());
        };
        return new InputException(file + ": " + what);
    }

    /** Does something with the database, its errors told in words for a person. */
    synchronized <T> T with(Work<T> work) {
        try {
            return work.run();
        } catch (SQLException problem) {
            throw meaning(file, problem);
        }
    }

    /** Reads by several queries that all see the same rows, whatever other connections write between them. */
    <T> T inSnapshot(Work<T> work) {
        return inTransaction("BEGIN", work);
    }

    /** Does something in one transaction: all of it or nothing. */
    <T> T inTransaction(Work<T> work) {
        return inTransaction("BEGIN IMMEDIATE", work);
    }

    private synchronized <T> T inTransaction(String begin, Work<T> work) {
        return with(() -> {
            update(begin);                             // kept for the next time, as other statements are
            boolean done = false;
            try {
                T result = work.run();
                update("COMMIT");
                done = true;
                return result;
            } finally {
                if (!done) {
                    rollback();
                }
            }
        });
    }

    private void rollback() {
        try {
            execute("ROLLBACK");
        } catch (InputException gone) {
            return;                                    // the database has rolled back by itself
        }
    }

    /** A query for one user at a time, its statement kept for the next time; the result is to be closed. */
    ResultSet query(String sql, Object... values) throws SQLException {
        return statement(sql, values).executeQuery();
    }

    private PreparedStatement statement(String sql, Object... values) throws SQLException {
        PreparedStatement statement = prepared.get(sql);
        if (statement == null) {
            statement = connection.prepareStatement(sql);
            prepared.put(sql, statement);
        }
        for (int k = 0; k < values.length; k++) {
            statement.setObject(k + 1, values[k]);
        }
        return statement;
    }

    /** Reads all rows of a query. */
    void each(String sql, RowReader reader, Object... values) {
        with(() -> {
            try (ResultSet row = query(sql, values)) {
                while (row.next()) {
                    reader.read(row);
                }
                return null;
            }
        });
    }

    /** Returns what is made of each row of a query. */
    <T> List<T> list(String sql, RowMaker<T> maker, Object... values) {
        List<T> made = new ArrayList<>();
        each(sql, row -> made.add(maker.make(row)), values);
        return made;
    }

    /** The first column of the first row, or {@code null}. */
    Object value(String sql, Object... values) {
        List<Object> found = list(sql, row -> row.getObject(1), values);
        return found.isEmpty() ? null : found.get(0);
    }

    /** The first column of a row that is there, and holds a whole number. */
    long number(String sql, Object... values) {
        return ((Number) value(sql, values)).longValue();
    }

    int update(String sql, Object... values) {
        return with(() -> statement(sql, values).executeUpdate());
    }

    void execute(String sql) {
        with(() -> {
            try (Statement statement = connection.createStatement()) {
                return statement.execute(sql);
            }
        });
    }

    Path file() {
        return file;
    }

    /** Returns the copy of an older form that has been brought up to date when it was opened, or {@code null}. */
    Path before() {
        return before;
    }

    @Override
    public synchronized void close() {
        try {
            connection.close();
        } catch (SQLException gone) {
            return;
        }
    }
}

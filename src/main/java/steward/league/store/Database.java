package steward.league.store;

import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.HashMap;
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
        NativeLibrary.prepare(folder.path());
        return connect(file, write, isImmutable(folder, write), patienceMs,
            database -> database.prepare(write, durable));
    }

    private static boolean isImmutable(LeagueFolder folder, boolean write) {
        return !write && !Files.isWritable(folder.path()) && Files.notExists(log(folder.database()));
    }

    /** True if a league's database is there, and of an older form. */
    static boolean isBehind(LeagueFolder folder) {
        Path file = folder.database();
        boolean[] behind = new boolean[1];
        NativeLibrary.prepare(folder.path());
        connect(file, false, isImmutable(folder, false), PATIENCE_MS, database ->
            behind[0] = SchemaVersion.isBehind(database.connection, file)
                && SchemaVersion.number(database.connection, "user_version") > 0).close();
        return behind[0];
    }

    /** Preparation of a connection before it is used. */
    private interface Preparation {
        void of(Database database) throws SQLException;
    }

    private static Database connect(Path file, boolean write, boolean immutable, int patienceMs,
                                    Preparation preparation) {
        SQLiteConfig config = new SQLiteConfig();
        config.setBusyTimeout(patienceMs);
        config.setOpenMode(SQLiteOpenMode.OPEN_URI);
        if (!write) {
            config.setReadOnly(true);
        }
        String address = "jdbc:sqlite:" + (immutable ? file.toUri().toString().replace("file:///", "file:/")
            + "?immutable=1" : file.toString());
        Connection connection = null;
        try {
            connection = config.createConnection(address);
            Database database = new Database(file, connection);
            preparation.of(database);
            return database;
        } catch (SQLException problem) {
            close(connection);
            throw meaning(file, problem);
        } catch (InputException refused) {
            close(connection);
            throw refused;
        }
    }

    private static Path log(Path file) {
        return file.resolveSibling(file.getFileName() + "-wal");
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

    private String unfit() throws SQLException {
        return SchemaVersion.number(connection, "user_version") == 0 ? "an empty database"
            : "a database of an older form";
    }

    private void prepare(boolean write, boolean durable) throws SQLException {
        execute("PRAGMA cache_size = -" + CACHE_KIB);
        boolean behind = SchemaVersion.isBehind(connection, file);
        if (!write) {
            if (behind) {
                throw new InputException(file + ": found " + unfit() + ", expected one that 'steward league run' "
                    + "has made or 'steward league verify' has brought up to date");
            }
            return;
        }
        execute("PRAGMA journal_mode = WAL");
        execute("PRAGMA synchronous = " + (durable ? "FULL" : "NORMAL"));
        if (behind) {
            before = SchemaVersion.migrate(this);
        }
        refer(true);
    }

    /** Has rows to which others refer kept, or not; between transactions. */
    void refer(boolean kept) {
        with(() -> {
            execute("PRAGMA foreign_keys = " + (kept ? "ON" : "OFF"));
            return null;
        });
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
            execute(begin);
            boolean done = false;
            try {
                T result = work.run();
                execute("COMMIT");
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
        } catch (SQLException gone) {
            return;                                    // the database has rolled back by itself
        }
    }

    /** A statement that is kept for the next time. */
    PreparedStatement statement(String sql, Object... values) throws SQLException {
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

    /** A query for one user at a time; the result is to be closed. */
    ResultSet query(String sql, Object... values) throws SQLException {
        return statement(sql, values).executeQuery();
    }

    /** The first column of the first row, or {@code null}. */
    Object value(String sql, Object... values) throws SQLException {
        try (ResultSet result = query(sql, values)) {
            return result.next() ? result.getObject(1) : null;
        }
    }

    int update(String sql, Object... values) throws SQLException {
        return statement(sql, values).executeUpdate();
    }

    void execute(String sql) throws SQLException {
        try (Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    Connection connection() {
        return connection;
    }

    Path file() {
        return file;
    }

    /** Returns the copy of an older form that has been brought up to date when it was opened, or {@code null}. */
    Path before() {
        return before;
    }

    private static void close(Connection connection) {
        try {
            if (connection != null) {
                connection.close();
            }
        } catch (SQLException gone) {
            return;
        }
    }

    @Override
    public synchronized void close() {
        close(connection);
    }
}

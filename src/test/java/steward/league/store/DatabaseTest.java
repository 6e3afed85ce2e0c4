package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.files.InputException;
import steward.league.LeagueFolder;

/** Databases that cannot be used are refused with a reason. */
@Execution(ExecutionMode.CONCURRENT)
class DatabaseTest {

    @TempDir
    private Path path;
    private LeagueFolder folder;

    @BeforeEach
    void open() {
        folder = new LeagueFolder(path);
    }

    private void run(String... statements) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + folder.database());
             Statement statement = connection.createStatement()) {
            for (String sql : statements) {
                statement.execute(sql);
            }
        }
    }

    private String refusal(boolean write) {
        return assertThrows(InputException.class, () -> Database.open(folder, write, false, 50).close()).getMessage()
            .replace(folder.database().toString(), "DB");
    }

    @Test
    void whatIsNoLeaguesDatabaseIsRefused() throws IOException, SQLException {
        assertEquals("DB: found no such file, expected the games of the league; 'steward league run' makes it",
            refusal(false));
        Files.writeString(folder.database(), "this is no database, and has more than a hundred bytes so that it is "
            + "read as one: " + "x".repeat(200));
        assertEquals("DB: found no database, expected one of SQLite", refusal(true));
        assertEquals("DB: found no database, expected one of SQLite", refusal(false));
        Files.delete(folder.database());
        run("CREATE TABLE addresses (name TEXT)");
        assertEquals("DB: found a database of another program, expected a league's", refusal(true));
        Files.delete(folder.database());
        GameStore.write(folder).close();
        run("PRAGMA user_version = 99");
        assertEquals("DB: found a database of form 99, expected 4 or 5: it is of a newer Steward", refusal(true));
        run("PRAGMA user_version = 3");
        assertEquals("DB: found a database of form 3, expected 4 or 5: 'steward league run' of Steward 0.2.0 brings it "
            + "to form 4", refusal(true));
        run("PRAGMA user_version = " + SchemaVersion.NEWEST, "PRAGMA application_id = 5");
        assertEquals("DB: found a database of another program, expected a league's", refusal(false));
    }

    @Test
    void aDatabaseThatStaysLockedIsToldOf() throws SQLException {
        try (GameStore fresh = GameStore.write(folder)) {
            assertTrue(fresh.lastSeason().isEmpty());
        }
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + folder.database());
             Statement statement = connection.createStatement();
             Database ours = Database.open(folder, true, false, 50)) {
            statement.execute("BEGIN IMMEDIATE");
            String told = assertThrows(InputException.class, () -> ours.inTransaction(() -> 1)).getMessage();
            assertEquals(folder.database() + ": found it locked by another program, and it stayed so; nothing was "
                + "written", told);
            statement.execute("ROLLBACK");
            assertEquals(1, ours.inTransaction(() -> 1));
        }
    }

    @Test
    void theMachineCodeIsUnpackedOnceAndWhole() throws IOException {
        String name = org.sqlite.util.LibraryLoaderUtil.getNativeLibName();
        Path unpacked = NativeLibrary.unpack(path, NativeLibrary.system(), name);
        Path file = unpacked.resolve(name);
        long size = Files.size(file);
        assertTrue(size > 100_000, () -> size + " bytes");
        Object before = Files.getLastModifiedTime(file);
        assertEquals(unpacked, NativeLibrary.unpack(path, NativeLibrary.system(), name));
        assertEquals(before, Files.getLastModifiedTime(file));
        try (var left = Files.list(unpacked)) {
            assertEquals(List.of(file), left.toList());
        }
    }
}

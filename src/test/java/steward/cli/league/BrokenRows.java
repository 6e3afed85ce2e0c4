package steward.cli.league;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import steward.cli.Cli;
import steward.league.store.OlderForm;

/**
 * Damages the rows of a league's database by SQL: another value, of any type, or a row that is not there. Every such
 * change has to be seen when the league is read, and told without a trace of the program.
 *
 * <p>The league is one that version 0.2.0 has played: two seasons, three bots of which one has a second version with
 * two identities, failures, a game that was played again, games outside of the schedule.
 */
public final class BrokenRows {

    private static final List<String> VALUES = List.of("NULL", "'abc'", "''", "-1", "0", "1", "7", "4294967296",
        "-9223372036854775808", "9223372036854775807", "0.5", "9e999", "-9e999", "x'00'", "x'c328'", "'1 99'",
        "'1 x'", "'99999999999'", "zeroblob(16)", "char(0)", "'\u20ac'", "COLUMN + 1", "COLUMN - 1", "-COLUMN",
        "COLUMN || 'x'", "upper(COLUMN)", "(SELECT min(COLUMN) FROM TABLE)", "(SELECT max(COLUMN) FROM TABLE)");
    private static final List<String> READERS = List.of("table", "games", "export", "list", "page");

    private final Path folder;
    private final byte[] whole;
    private final List<String[]> columns;
    private final long seed;

    /** Outcome of a change. */
    public enum Outcome {
        /** The database itself has refused it. */
        REFUSED,
        /** The value is as it was. */
        SAME,
        /** The program has seen it. */
        SEEN
    }

    /** Takes the league into a folder that is there, and brings it up to date. */
    public BrokenRows(Path folder, long seed) throws IOException {
        this.folder = folder;
        this.seed = seed;
        of020(folder.resolve("night"));
        Cli.run("league", "verify", league()).done();
        whole = Files.readAllBytes(database());
        columns = with(connection -> query(connection, "SELECT m.name, c.name FROM sqlite_schema m, "
            + "pragma_table_info(m.name) c WHERE m.type = 'table' ORDER BY 1, 2"));
    }

    /** Lays out a league that version 0.2.0 has played. */
    static void of020(Path league) throws IOException {
        Files.createDirectories(league);
        for (String name : List.of("league.json", "league.db")) {
            try (InputStream in = BrokenRows.class.getResourceAsStream("/steward/league/form-4/" + name)) {
                Files.write(league.resolve(name), in.readAllBytes());
            }
        }
    }

    /** Returns how many columns all tables have. */
    public int columns() {
        return columns.size();
    }

    private String league() {
        return folder.resolve("night").toString();
    }

    private Path database() {
        return folder.resolve("night/league.db");
    }

    /** Damages a value or a row, chosen by number: every column has its turn. */
    public Outcome check(int number) throws IOException {
        SplittableRandom random = new SplittableRandom(seed * 1_000_003 + number);
        String table = columns.get(number % columns.size())[0];
        String column = columns.get(number % columns.size())[1];
        List<String> keys = with(connection -> query(connection, "SELECT " + key(table) + ", 0 FROM " + table))
            .stream().map(row -> row[0]).toList();
        String which = " WHERE " + key(table) + " = '" + keys.get(random.nextInt(keys.size())) + "'";
        String value = VALUES.get(random.nextInt(VALUES.size())).replace("COLUMN", column).replace("TABLE", table);
        String change = random.nextInt(8) == 0 ? "DELETE FROM " + table + which
            : "UPDATE " + table + " SET " + column + " = " + value + which;
        Outcome outcome = with(connection -> change(connection, table, column, change));
        String at = change + ", seed " + seed + ", number " + number + ": ";
        Cli verified = Cli.run("league", "verify", league());
        String reader = READERS.get(random.nextInt(READERS.size()));
        Path page = folder.resolve("page.html");
        Cli read = reader.equals("page") ? Cli.run("league", reader, league(), "--out", page.toString())
            : Cli.run("league", reader, league());
        Files.deleteIfExists(page);
        boolean seen = outcome == Outcome.SEEN;
        if (verified.status() != (seen ? 1 : 0) || seen && !verified.out().startsWith("table ")
                || read.status() != (seen ? 2 : 0) || seen && !read.err().contains("league.db: table ")
                || (verified.err() + read.err()).contains("\tat ")) {
            throw new AssertionError(at + outcome + ", verify: " + verified + ", read: " + read);
        }
        if (seen && random.nextInt(10) == 0) {
            Cli.run("league", "verify", league(), "--drop").done();
            if (Cli.run("league", "verify", league()).status() != 0) {
                throw new AssertionError(at + "not whole after --drop");
            }
        }
        return outcome;
    }

    private static String key(String table) {
        return switch (table) {
            case "seat" -> "season || ' ' || version || ' ' || game || ' ' || seat";
            case "identity" -> "hash";
            case "decision" -> "season || ' ' || number";
            default -> "id";
        };
    }

    private static Outcome change(Connection connection, String table, String column, String change)
            throws SQLException {
        String content = "SELECT group_concat(quote(" + column + ") || typeof(" + column + ")), count(*) FROM " + table;
        String before = String.join(" ", query(connection, content).get(0));
        try (Statement statement = connection.createStatement()) {
            statement.executeUpdate(change);
        } catch (SQLException refused) {
            return Outcome.REFUSED;
        }
        return before.equals(String.join(" ", query(connection, content).get(0))) ? Outcome.SAME : Outcome.SEEN;
    }

    private static List<String[]> query(Connection connection, String sql) throws SQLException {
        List<String[]> rows = new ArrayList<>();
        try (Statement statement = connection.createStatement(); ResultSet row = statement.executeQuery(sql)) {
            while (row.next()) {
                rows.add(new String[] {row.getString(1), row.getString(2)});
            }
        }
        return rows;
    }

    /** Changes a fresh copy by a statement, and says what a reading of it comes to. */
    public Cli table(String change) throws IOException {
        with(connection -> query(connection, change + " RETURNING 1, 2"));
        return Cli.run("league", "table", league());
    }

    /** Damages the league as form 4 has it, and brings it up to date; returns what that says. */
    public Cli brought(String change) throws IOException, SQLException {
        with(connection -> null);
        OlderForm.of(database());
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + database());
             Statement statement = connection.createStatement()) {
            statement.executeUpdate(change);
        }
        return Cli.run("league", "verify", league());
    }

    private interface Change<T> {
        T of(Connection connection) throws SQLException;
    }

    private <T> T with(Change<T> change) throws IOException {
        for (String beside : List.of("-wal", "-shm")) {
            Files.deleteIfExists(folder.resolve("night/league.db" + beside));
        }
        Files.write(database(), whole);
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + database())) {
            return change.of(connection);
        } catch (SQLException problem) {
            throw new AssertionError(problem);
        }
    }
}

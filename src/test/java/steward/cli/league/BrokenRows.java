package steward.cli.league;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import steward.cli.Cli;

/**
 * Damages the rows of a league's database by SQL: a value of another type or size, a row that is not there. The table
 * of the league must then be refused with table, row and column, or be printed, if the row is as one could be.
 */
public final class BrokenRows {

    private static final List<String> TABLES = List.of("season", "version", "identity", "machine", "lineup", "game",
        "seat");
    private static final List<String> VALUES = List.of("NULL", "'abc'", "''", "-1", "0", "1", "7", "4294967296",
        "-9223372036854775808", "9223372036854775807", "0.5", "9e999", "-9e999", "x'00'", "x'c328'", "'1 99'",
        "'1 x'", "'99999999999'", "zeroblob(100)", "char(0)", "'\u20ac'");
    private static final Set<String> NUMBERS = Set.of("integer", "real");

    private final Path folder;
    private final byte[] whole;
    private final long seed;

    /** Makes a small league in a folder that is there. */
    public BrokenRows(Path folder, long seed) throws IOException {
        this.folder = folder;
        this.seed = seed;
        Path league = folder.resolve("night");
        Cli.run("league", "init", league.toString(), "--scene", "duel", "--seed", "1").done();
        Cli.run("league", "generate", league.toString(), "--games", "6", "--bots", "3").done();
        whole = Files.readAllBytes(league.resolve("league.db"));
    }

    /** Damages a value or a row, chosen by number; true if the league was refused. */
    public boolean check(int number) throws IOException {
        SplittableRandom random = new SplittableRandom(seed * 1_000_003 + number);
        String table = TABLES.get(random.nextInt(TABLES.size()));
        boolean delete = random.nextInt(5) == 0;
        int place = random.nextInt(1000);
        int column = random.nextInt(1000);
        String value = VALUES.get(random.nextInt(VALUES.size()));
        String[] change = new String[1];
        boolean bad = with(connection -> {
            List<String> columns = new ArrayList<>();
            try (Statement statement = connection.createStatement();
                 ResultSet row = statement.executeQuery("PRAGMA table_info(" + table + ")")) {
                while (row.next()) {
                    columns.add(row.getString(2));
                }
            }
            String name = columns.get(column % columns.size());
            String which = " WHERE (" + key(table) + ") = (SELECT " + key(table) + " FROM " + table + " ORDER BY "
                + key(table) + " LIMIT 1 OFFSET " + place + " % (SELECT count(*) FROM " + table + "))";
            change[0] = delete ? "DELETE FROM " + table + which : "UPDATE " + table + " SET " + name + " = " + value
                + which;
            return damaged(connection, table, name, delete, change[0]);
        });
        Cli said = Cli.run("league", "table", folder.resolve("night").toString());
        boolean refused = said.status() == 2;
        if (said.status() != 0 && !refused || said.err().contains("\tat ") || refused && !said.err().contains(
            "league.db: ") || bad && !refused) {
            throw new AssertionError(change[0] + ": status " + said.status() + ", " + said.err());
        }
        return refused;
    }

    private static String key(String table) {
        return switch (table) {
            case "seat" -> "season, version, game, seat";
            case "identity" -> "hash";
            default -> "id";
        };
    }

    /** Makes the change; true if no league can be so: a type that is not the column's, or a row that others need. */
    private static boolean damaged(Connection connection, String table, String column, boolean delete, String change)
            throws SQLException {
        try (Statement statement = connection.createStatement()) {
            if (delete) {
                statement.execute(change);
                return !table.equals("identity");
            }
            String before = type(statement, table, column);
            statement.execute(change);
            String after = type(statement, table, column);
            return !before.equals(after) && !before.contains("null") && !after.contains("null")
                && !NUMBERS.containsAll(Set.of(after.split(",")));
        } catch (SQLException refused) {
            return false;                              // by a constraint of the database: nothing has changed
        }
    }

    /** The types in a column. */
    private static String type(Statement statement, String table, String column) throws SQLException {
        try (ResultSet row = statement.executeQuery("SELECT group_concat(DISTINCT typeof(" + column + ")) FROM "
                + table)) {
            return String.valueOf(row.getString(1));
        }
    }

    /** Damages a fresh copy by a statement, and says what the table of the league comes to. */
    public Cli table(String change) throws IOException {
        with(connection -> {
            try (Statement statement = connection.createStatement()) {
                return statement.executeUpdate(change) > 0;
            }
        });
        return Cli.run("league", "table", folder.resolve("night").toString());
    }

    private interface Change {
        boolean of(Connection connection) throws SQLException;
    }

    private boolean with(Change change) throws IOException {
        Path file = folder.resolve("night/league.db");
        for (String beside : List.of("-wal", "-shm")) {
            Files.deleteIfExists(file.resolveSibling("league.db" + beside));
        }
        Files.write(file, whole);
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file)) {
            return change.of(connection);
        } catch (SQLException problem) {
            throw new AssertionError(problem);
        }
    }
}

package steward.league.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.league.Season;
import steward.league.StoredGame.StoredSeat;
import steward.text.TextFormat;

/**
 * Finds rows of a league's database that no version of the program writes: those that break a rule of their table, as
 * rows of form 4 may, rows that others need and that are not there, and those whose {@link RowDigest} is another one.
 */
final class RowCheck {

    static final Pattern VERSIONS = Pattern.compile("\\d{1,9}( \\d{1,9})*");
    /** A line of a table in {@link SchemaVersion}: column, type, rule, table to which it refers, what is expected. */
    private static final Pattern COLUMN = Pattern.compile("(?m)^ +([a-z_]+) (INTEGER|REAL|TEXT|BLOB)"
        + "( NOT NULL| PRIMARY KEY)?(?: UNIQUE)?(?: DEFAULT 0)?(?: CHECK \\((.+)\\))?(?: REFERENCES ([a-z]+))?,?"
        + "(?: -- (.+))?$");
    private static final Map<String, String> EXPECTED = Map.of("INTEGER", "a whole number", "REAL", "a finite number",
        "TEXT", "a text", "BLOB", "bytes");
    /** Columns that find a row, by table; others have an id. */
    private static final Map<String, String> KEYS = Map.of("identity", "'hash = ' || quote(hash)", "decision",
        "'season = ' || quote(season) || ' AND number = ' || quote(number)", "seat", "'season = ' || quote(season) || "
        + "' AND version = ' || quote(version) || ' AND game = ' || quote(game) || ' AND seat = ' || quote(seat)");
    private static final int LONGEST_SHOWN = 60;

    private final Database database;
    private final int most;
    private final List<BadRow> found = new ArrayList<>();

    /**
     * A condition on a column.
     *
     * @param bad is true of rows that are wrong
     */
    private record Rule(String column, String bad, String expected) { }

    private RowCheck(Database database, int most) {
        this.database = database;
        this.most = most;
    }

    /**
     * Looks through all tables. If digests and references are as they should be, nothing else is looked at.
     *
     * @param most after which it stops
     */
    static List<BadRow> of(Database database, int most) throws SQLException {
        if (RowDigest.isSound(database)) {
            return List.of();
        }
        RowCheck check = new RowCheck(database, most);
        check.rules();
        Set<String> known = check.found.stream().map(row -> row.table() + " " + row.key()).collect(Collectors.toSet());
        RowDigest.check(database, row -> {
            if (!known.contains(row.table() + " " + row.key())) {
                check.add(row);
            }
        });
        return check.found;
    }

    /** Finds the rows that cannot be used in a database whose rows have no digests yet. */
    static List<BadRow> withoutDigests(Database database) throws SQLException {
        RowCheck check = new RowCheck(database, Integer.MAX_VALUE);
        check.rules();
        return check.found;
    }

    /** The rules of the tables, which rows of an older form or of a damaged file may break, and what is none of SQL. */
    private void rules() throws SQLException {
        for (Map.Entry<String, String> table : SchemaVersion.TABLES.entrySet()) {
            List<Rule> rules = new ArrayList<>();
            COLUMN.matcher(table.getValue()).results().forEach(column -> rules.addAll(rules(column)));
            table(table.getKey(), rules);
        }
        table("game", List.of(new Rule("decision", "decision IS NOT NULL AND NOT EXISTS (SELECT 1 FROM decision o WHERE"
            + " o.season = t.season AND o.number = t.decision)", "a row of the table decision of this season")));
        table("version", List.of(new Rule("id", "NOT EXISTS (SELECT 1 FROM identity o WHERE o.version = t.id)",
            "one that a row of the table identity has")));
        seasons();
        lineups();
        ownValues();
        if (found.isEmpty()) {
            table("game", List.of(new Rule("lineup", seats("version")
                + " <> (SELECT versions FROM lineup o WHERE o.id = t.lineup)", "the versions of its rows of the table "
                + "seat"), new Rule("ranks", seats("rank") + " <> ranks", "the ranks of its rows of the table seat")));
            table("seat", List.of(new Rule("game", "NOT EXISTS (SELECT 1 FROM game o WHERE o.id = t.game "
                + "AND o.season = t.season)", "a row of the table game of this season")));
        }
    }

    private static List<Rule> rules(MatchResult line) {
        String column = line.group(1);
        String expected = line.group(6) == null ? EXPECTED.get(line.group(2)) : line.group(6);
        List<Rule> rules = new ArrayList<>();
        rules.add(new Rule(column, "typeof(" + column + ") <> '" + line.group(2).toLowerCase(Locale.ROOT) + "'"
            + (line.group(3) == null ? " AND " + column + " IS NOT NULL" : ""), expected));
        if (line.group(4) != null) {
            rules.add(new Rule(column, "NOT (" + line.group(4) + ")", expected));
        }
        if (line.group(5) != null) {
            rules.add(new Rule(column, "NOT EXISTS (SELECT 1 FROM " + line.group(5) + " o WHERE o.id = t." + column
                + ")", "a row of the table " + line.group(5)));
        }
        return rules;
    }

    private void ownValues() throws SQLException {
        try (ResultSet row = database.query("SELECT " + KEYS.get("seat") + ", own FROM seat WHERE own IS NOT NULL")) {
            while (found.size() < most && row.next()) {
                try {
                    StoredSeat.values(row.getString(2));
                } catch (IllegalArgumentException problem) {
                    add(new BadRow("seat", row.getString(1), "own", "'" + shortened(row.getString(2)) + "'",
                        "names with numbers, such as 'laps=2.0'"));
                }
            }
        }
    }

    /** Rows of the seats of a game, in their order; empty where it has none. */
    private static String seats(String column) {
        return "coalesce((SELECT group_concat(s." + column + ", ' ') FROM (SELECT * FROM seat WHERE game = t.id "
            + "ORDER BY seat) s), '')";
    }

    /** A key is computed from the rest of the row: it is what finds the row. */
    private void seasons() throws SQLException {
        Set<String> bad = new HashSet<>();
        found.stream().filter(row -> row.table().equals("season")).forEach(row -> bad.add(row.key()));
        try (ResultSet row = database.query("SELECT id, key, scene, scene_key, limits, rules, players, lower_is_better "
            + "FROM season")) {
            while (row.next()) {
                String key = "id = " + row.getLong(1);
                String expected = bad.contains(key) ? null : Season.of(row.getString(3), row.getString(4),
                    row.getString(5), row.getString(6), row.getInt(7), row.getBoolean(8)).key();
                if (expected != null && !expected.equals(row.getString(2))) {
                    add(new BadRow("season", key, "key", "'" + shortened(row.getString(2)) + "'", "'" + expected
                        + "', which follows from the row"));
                }
            }
        }
    }

    private void lineups() throws SQLException {
        Set<Integer> versions = new HashSet<>();
        try (ResultSet row = database.query("SELECT id FROM version")) {
            while (row.next()) {
                versions.add(row.getInt(1));
            }
        }
        try (ResultSet row = database.query("SELECT id, versions, quote(versions) FROM lineup")) {
            while (row.next()) {
                String text = row.getString(2);
                boolean form = text != null && VERSIONS.matcher(text).matches();
                if (!form || !versions.containsAll(Arrays.stream(GameQueries.numbers(text)).boxed().toList())) {
                    add(new BadRow("lineup", "id = " + row.getLong(1), "versions", shortened(row.getString(3)), form
                        ? "numbers of rows of the table version" : "numbers of versions, apart by blanks"));
                }
            }
        }
    }

    private void table(String table, List<Rule> rules) throws SQLException {
        StringBuilder which = new StringBuilder("CASE");
        for (int k = 0; k < rules.size(); k++) {
            which.append(" WHEN ").append(rules.get(k).bad()).append(" THEN ").append(k);
        }
        String first = which + " END";
        StringBuilder value = new StringBuilder("CASE k");
        for (int k = 0; k < rules.size(); k++) {
            value.append(" WHEN ").append(k).append(" THEN quote(").append(rules.get(k).column()).append(')');
        }
        try (ResultSet row = database.query("SELECT " + KEYS.getOrDefault(table, "'id = ' || id") + ", k, " + value
            + " END FROM (SELECT *, " + first + " AS k FROM " + table + " t) WHERE k IS NOT NULL")) {
            while (found.size() < most && row.next()) {
                Rule rule = rules.get(row.getInt(2));
                add(new BadRow(table, row.getString(1), rule.column(), shortened(row.getString(3)), rule.expected()));
            }
        }
    }

    private void add(BadRow row) {
        if (found.size() < most) {
            found.add(row);
        }
    }

    private static String shortened(String value) {
        String text = TextFormat.plain(String.valueOf(value));
        return text.length() > LONGEST_SHOWN ? text.substring(0, LONGEST_SHOWN) + "..." : text;
    }
}

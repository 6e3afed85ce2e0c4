package steward.league.store;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import steward.league.Season;
import steward.league.StoredGame.StoredSeat;
import steward.text.TextFormat;

/**
 * Check for corrupt rows of a league's database, which no version of the program writes. Such a row breaks a rule of
 * its table (as rows of form 4 may), refers to a missing row, or differs from its {@link RowDigest}.
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
    /** By table and key, the first that was found of each. */
    private final Map<String, BadRow> found = new LinkedHashMap<>();

    private RowCheck(Database database, int most) {
        this.database = database;
        this.most = most;
    }

    /**
     * Looks through all tables. If digests and references are as they should be, nothing else is looked at.
     *
     * @param most after which it stops
     */
    static List<BadRow> of(Database database, int most) {
        if (RowDigest.isSound(database)) {
            return List.of();
        }
        RowCheck check = new RowCheck(database, most);
        check.rules();
        RowDigest.check(database, check::add);
        return List.copyOf(check.found.values());
    }

    /** Finds the rows that cannot be used in a database whose rows have no digests yet. */
    static List<BadRow> withoutDigests(Database database) {
        RowCheck check = new RowCheck(database, Integer.MAX_VALUE);
        check.rules();
        return List.copyOf(check.found.values());
    }

    /** The rules of the tables, which rows of an older form or of a damaged file may break, and what is none of SQL. */
    private void rules() {
        SchemaVersion.TABLES.forEach((name, table) -> COLUMN.matcher(table).results().forEach(column ->
            rules(name, column)));
        refuse("game", "decision", "decision IS NOT NULL AND NOT EXISTS (SELECT 1 FROM decision o WHERE o.season = "
            + "t.season AND o.number = t.decision)", "a row of the table decision of this season");
        refuse("version", "id", "NOT EXISTS (SELECT 1 FROM identity o WHERE o.version = t.id)", "one that a row of the "
            + "table identity has");
        // A key is computed from the rest of the row: it is what finds the row.
        look("season", "key", "key, scene, scene_key, limits, rules, players, lower_is_better", "1", row -> {
            String key = found.containsKey("season " + row.getString(1)) ? null : Season.of(row.getString(4),
                row.getString(5), row.getString(6), row.getString(7), row.getInt(8), row.getBoolean(9)).key();
            return key == null || key.equals(row.getString(3)) ? null : "'" + key + "', which follows from the row";
        });
        Set<Integer> versions = Set.copyOf(database.list("SELECT id FROM version", row -> row.getInt(1)));
        look("lineup", "versions", "versions", "1", row -> {
            boolean isForm = row.getString(3) != null && VERSIONS.matcher(row.getString(3)).matches();
            return !isForm ? "numbers of versions, apart by blanks" : versions.containsAll(Arrays.stream(GameQueries
                .numbers(row.getString(3))).boxed().toList()) ? null : "numbers of rows of the table version";
        });
        look("seat", "own", "own", "own IS NOT NULL", row -> {
            try {
                StoredSeat.values(row.getString(3));
                return null;
            } catch (IllegalArgumentException problem) {
                return "names with numbers, such as 'laps=2.0'";
            }
        });
        if (found.isEmpty()) {
            refuse("game", "lineup", seats("version") + " <> (SELECT versions FROM lineup o WHERE o.id = t.lineup)",
                "the versions of its rows of the table seat");
            refuse("game", "ranks", seats("rank") + " <> ranks", "the ranks of its rows of the table seat");
            refuse("seat", "game", "NOT EXISTS (SELECT 1 FROM game o WHERE o.id = t.game AND o.season = t.season)",
                "a row of the table game of this season");
        }
    }

    private void rules(String table, MatchResult line) {
        String column = line.group(1);
        String expected = line.group(6) == null ? EXPECTED.get(line.group(2)) : line.group(6);
        refuse(table, column, "typeof(" + column + ") <> '" + line.group(2).toLowerCase(Locale.ROOT) + "'"
            + (line.group(3) == null ? " AND " + column + " IS NOT NULL" : ""), expected);
        if (line.group(4) != null) {
            refuse(table, column, "NOT (" + line.group(4) + ")", expected);
        }
        if (line.group(5) != null) {
            refuse(table, column, "NOT EXISTS (SELECT 1 FROM " + line.group(5) + " o WHERE o.id = t." + column + ")",
                "a row of the table " + line.group(5));
        }
    }

    /** Rows of the seats of a game, in their order; empty where it has none. */
    private static String seats(String column) {
        return "coalesce((SELECT group_concat(s." + column + ", ' ') FROM (SELECT * FROM seat WHERE game = t.id "
            + "ORDER BY seat) s), '')";
    }

    /** Finds the rows of a table of which a condition is true. */
    private void refuse(String table, String column, String bad, String expected) {
        look(table, column, "1", bad, row -> expected);
    }

    /**
     * @param more  columns for the judge, from the third on: the first two are key and value
     * @param judge returns what is expected in place of the value; {@code null} if it can be used
     */
    private void look(String table, String column, String more, String which, Database.RowMaker<String> judge) {
        database.each("SELECT " + KEYS.getOrDefault(table, "'id = ' || id") + ", quote(" + column + "), " + more
            + " FROM " + table + " t WHERE " + which, row -> {
                String expected = judge.make(row);
                if (expected != null) {
                    add(new BadRow(table, row.getString(1), column, shortened(row.getString(2)), expected));
                }
            });
    }

    private void add(BadRow row) {
        if (found.size() < most) {
            found.putIfAbsent(row.table() + " " + row.key(), row);
        }
    }

    private static String shortened(String value) {
        String text = TextFormat.plain(String.valueOf(value));
        return text.length() > LONGEST_SHOWN ? text.substring(0, LONGEST_SHOWN) + "..." : text;
    }
}

package steward.league.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.league.Season;
import steward.league.StoredGame.StoredSeat;
import steward.text.TextFormat;

/**
 * Finds rows of a league's database that no version of the program writes: values of another type or out of range, rows
 * that others need and that are not there, and those whose {@link RowDigest} is another one.
 */
final class RowCheck {

    private static final Pattern VERSIONS = Pattern.compile("\\d{1,9}( \\d{1,9})*");
    private static final int LONGEST_SHOWN = 60;
    /** As many as a scene may have. */
    private static final int MOST_PLAYERS = 16;
    private static final String WHOLE = "a whole number from 0 on";
    private static final String SMALL = "a whole number from 0 to 2147483647";
    private static final String TEXT = "a text";
    private static final String GAME = "'id = ' || id";
    private static final String SEAT = "'season = ' || quote(season) || ' AND version = ' || quote(version) "
        + "|| ' AND game = ' || quote(game) || ' AND seat = ' || quote(seat)";

    private final Database database;
    private final int most;
    private final List<BadRow> found = new ArrayList<>();

    /**
     * A condition on a column. Conditions are made of comparisons alone, since calls of functions would take several
     * seconds for a million games: SQL orders values as nothing, numbers, texts, bytes, and {@code x | 0} is a whole
     * number for every {@code x}.
     *
     * @param bad is true of rows that are wrong
     */
    private record Rule(String column, String bad, String expected) {

        static Rule text(String column) {
            return new Rule(column, column + " < '' OR " + column + " >= x''", TEXT);
        }

        static Rule whole(String column, long least, long most, String expected) {
            return new Rule(column, "(" + column + " | 0) <> " + column + " OR " + column + " NOT BETWEEN " + least
                + " AND " + most, expected);
        }

        static Rule whole(String column) {
            return whole(column, 0, Long.MAX_VALUE, WHOLE);
        }

        static Rule small(String column) {
            return whole(column, 0, Integer.MAX_VALUE, SMALL);
        }

        static Rule flag(String column) {
            return whole(column, 0, 1, "0 or 1");
        }

        static Rule refers(String column, String table) {
            return new Rule(column, "NOT EXISTS (SELECT 1 FROM " + table + " o WHERE o.id = t." + column + ")",
                "a row of the table " + table);
        }
    }

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

    private void rules() throws SQLException {
        seasons();
        table("version", "'id = ' || id", List.of(Rule.small("id"), Rule.text("bot"),
            Rule.whole("number", 1, Integer.MAX_VALUE, "a whole number from 1 on"), Rule.text("command"),
            Rule.text("time_limit"), Rule.flag("random"), Rule.whole("began"), Rule.flag("paused"),
            new Rule("id", "NOT EXISTS (SELECT 1 FROM identity o WHERE o.version = t.id)",
            "one that a row of the table identity has")));
        table("identity", "'hash = ' || quote(hash)", List.of(Rule.text("hash"),
            Rule.refers("version", "version"), Rule.whole("began")));
        table("machine", "'id = ' || id", List.of(Rule.text("name")));
        lineups();
        table("game", GAME, List.of(new Rule("name", "name < x'' OR length(name) <> 16", "16 bytes"),
            Rule.refers("season", "season"), Rule.small("decision"), Rule.whole("seed", -Long.MAX_VALUE, Long.MAX_VALUE,
            "a whole number"), Rule.refers("lineup", "lineup"), Rule.text("ranks"), Rule.whole("attempt", 1,
            Integer.MAX_VALUE, "a whole number from 1 on"), Rule.whole("counts", 0, GameRows.ALL_FAILED, "0, 1 or 2"),
            Rule.small("turns"), Rule.text("problem"), new Rule("problem", "counts AND problem IS NOT NULL",
            "nothing, as the game counts"), Rule.whole("played"), Rule.refers("machine", "machine"),
            Rule.text("replay"), Rule.whole("transcript", -Long.MAX_VALUE, Long.MAX_VALUE, "a whole number")));
        table("seat", SEAT, List.of(Rule.small("season"), Rule.small("version"), Rule.whole("game"),
            Rule.whole("seat", 0, MOST_PLAYERS - 1, "a seat of the game"),
            Rule.whole("rank", 0, MOST_PLAYERS - 1, "a rank of the game"), new Rule("score", "score NOT BETWEEN "
            + "-1.7976931348623157e308 AND 1.7976931348623157e308", "a finite number"), Rule.text("fault"),
            Rule.small("answers"), Rule.whole("mean_nanos"), Rule.whole("worst_nanos"), Rule.whole("first_nanos"),
            Rule.text("own")));
        ownValues();
        if (found.isEmpty()) {
            table("game", GAME, List.of(new Rule("lineup", seats("version")
                + " <> (SELECT versions FROM lineup o WHERE o.id = t.lineup)", "the versions of its rows of the table "
                + "seat"), new Rule("ranks", seats("rank") + " <> ranks", "the ranks of its rows of the table seat")));
            table("seat", SEAT, List.of(new Rule("game", "NOT EXISTS (SELECT 1 FROM game o WHERE o.id = t.game "
                + "AND o.season = t.season)", "a row of the table game of this season")));
        }
    }

    private void ownValues() throws SQLException {
        try (ResultSet row = database.query("SELECT " + SEAT + ", own FROM seat WHERE own IS NOT NULL")) {
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
        table("season", "'id = ' || id", List.of(Rule.small("id"), Rule.text("key"), Rule.text("scene"),
            Rule.text("scene_key"), Rule.text("limits"), Rule.text("rules"), Rule.whole("players", 1,
            MOST_PLAYERS, "1 to " + MOST_PLAYERS), Rule.whole("opened"), Rule.flag("lower_is_better")));
        Set<String> bad = new HashSet<>();
        found.forEach(row -> bad.add(row.key()));
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
        try (ResultSet row = database.query("SELECT id, versions, quote(versions), typeof(id) FROM lineup")) {
            while (row.next()) {
                String text = row.getString(2);
                boolean form = text != null && VERSIONS.matcher(text).matches();
                boolean numbered = row.getLong(1) >= 0 && row.getLong(1) <= Integer.MAX_VALUE;
                if (!form || !numbered) {
                    add(new BadRow("lineup", "id = " + row.getLong(1), form ? "id" : "versions", form
                        ? Long.toString(row.getLong(1)) : shortened(row.getString(3)), form ? SMALL
                        : "numbers of versions, apart by blanks"));
                } else if (!versions.containsAll(Arrays.stream(GameQueries.numbers(text)).boxed().toList())) {
                    add(new BadRow("lineup", "id = " + row.getLong(1), "versions", shortened(row.getString(3)),
                        "numbers of rows of the table version"));
                }
            }
        }
    }

    private void table(String table, String key, List<Rule> rules) throws SQLException {
        StringBuilder which = new StringBuilder("CASE");
        for (int k = 0; k < rules.size(); k++) {
            which.append(" WHEN ").append(rules.get(k).bad()).append(" THEN ").append(k);
        }
        String first = which + " END";
        StringBuilder value = new StringBuilder("CASE k");
        for (int k = 0; k < rules.size(); k++) {
            value.append(" WHEN ").append(k).append(" THEN quote(").append(rules.get(k).column()).append(')');
        }
        try (ResultSet row = database.query("SELECT " + key + ", k, " + value + " END FROM (SELECT *, " + first
            + " AS k FROM " + table + " t) WHERE k IS NOT NULL")) {
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

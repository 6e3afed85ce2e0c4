package steward.league.store;

import java.nio.charset.StandardCharsets;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import steward.numerics.StateHash;

/**
 * Digests of rows, stored in their column {@code digest}, which reveal accidental changes. A digest covers all other
 * columns in their order, and the rows of another table that belong to the row, such as the seats of a game. It
 * protects against accidents, such as a bad bit of the disk or a statement by hand, not against forgery: anyone can
 * compute it. Code that writes or changes a row seals it in the same transaction.
 */
final class RowDigest {

    /**
     * A table whose rows have digests. A column of any table that is called like one of them refers to its rows.
     *
     * @param part  the table whose rows belong to a row of this one, or {@code null}
     * @param owner its column with the id of the row to which they belong
     */
    private record Table(String name, String part, String owner) {

        /** The column {@code id}, or both that are the key of a decision. */
        String id() {
            return name.equals(DECISION) ? "season << 32 | number" : "id";
        }

        String order() {
            return name.equals(DECISION) ? "season, number" : "id";
        }

        /** A condition on the id, which is its first parameter. */
        String which() {
            return name.equals(DECISION) ? "season = ?1 >> 32 AND number = ?1 & 4294967295" : "id = ?1";
        }

        /** The condition with an id, for a person too. */
        String key(long id) {
            return name.equals(DECISION) ? "season = " + (id >> Integer.SIZE) + " AND number = " + (int) id
                : "id = " + id;
        }

        String rows() {
            return part == null ? "the row" : "the row and its rows of the table " + part;
        }
    }

    private static final String DECISION = "decision";
    /** Each stands behind those to which it refers. */
    private static final List<Table> TABLES = List.of(new Table("season", null, null),
        new Table("version", "identity", "version"), new Table("machine", null, null), new Table("lineup", null, null),
        new Table(DECISION, null, null), new Table("game", "seat", "game"));
    /** Whole numbers from 0 to 2^31 - 1 in every row. */
    private static final Set<String> SMALL = Set.of("season", "version", "seat", "rank", "lineup", "attempt", "counts",
        "dropped");
    /** Stands for a value that is not there. */
    private static final long NOTHING = 0x6E6F7468696E67L;

    private RowDigest() { }

    /** Types of columns: the tables are strict, so that no other value stands in them. */
    private enum Kind { INTEGER, REAL, TEXT, BLOB }

    /**
     * A column.
     *
     * @param isAlways true if it has a value in each row: then one call asks for it
     * @param referred the rows to which it refers; {@code null} if it refers to none, or they are not known
     * @param lower    place of the column that is fetched with it as the lower half of one number, or -1
     */
    private record Column(String name, Kind kind, boolean isAlways, Rows referred, int lower) {

        String expression(Column... columns) {
            return lower < 0 ? name : "(" + name + " << 32) + " + columns[lower].name;
        }
    }

    /** Rows by ascending id, each with a digest as it is stored and as it is computed. */
    private static final class Rows {
        private long[] ids = new long[16];
        private long[] stored = new long[16];
        private long[] computed = new long[16];
        private int size;
        /** True if a row refers to another that is not there. */
        private boolean broken;

        void add(long id, long digest, long found) {
            if (size == ids.length) {
                ids = Arrays.copyOf(ids, 2 * size);
                stored = Arrays.copyOf(stored, 2 * size);
                computed = Arrays.copyOf(computed, 2 * size);
            }
            ids[size] = id;
            stored[size] = digest;
            computed[size++] = found;
        }

        /** Adds a part's digest to that of its row, if there is one. */
        void addPart(long id, long digest) {
            int row = find(id);
            if (row >= 0) {
                computed[row] += digest;
            }
        }

        /** The place of an id; negative if it is not there. */
        int find(long id) {
            long guess = size == 0 ? -1 : id - ids[0];                    // right where no row is missing
            return guess >= 0 && guess < size && ids[(int) guess] == id ? (int) guess
                : Arrays.binarySearch(ids, 0, size, id);
        }

        boolean isSound() {
            return !broken && Arrays.equals(stored, 0, size, computed, 0, size);
        }
    }

    /** Computes the digest of values in the order of their columns. */
    static long of(Object... values) {
        StateHash hash = new StateHash();
        for (Object value : values) {
            if (value == null) {
                hash.add(NOTHING);
            } else if (value instanceof Double number) {
                hash.add(number + 0.0);                                   // SQLite does not keep the sign of 0
            } else if (value instanceof Number whole) {
                hash.add(whole.longValue());
            } else {
                add(hash, value instanceof String text ? text.getBytes(StandardCharsets.UTF_8) : (byte[]) value);
            }
        }
        return hash.value();
    }

    private static void add(StateHash hash, byte[] bytes) {
        hash.add((long) bytes.length);
        for (int from = 0; from < bytes.length; from += Long.BYTES) {
            long word = 0;
            for (int k = from; k < Math.min(bytes.length, from + Long.BYTES); k++) {
                word = word << Byte.SIZE | bytes[k] & 0xFF;
            }
            hash.add(word);
        }
    }

    /** Gives rows of a table the digests that they should have. */
    static void seal(Database database, String table, String where, Object... values) throws SQLException {
        Table of = TABLES.stream().filter(each -> each.name().equals(table)).findFirst().orElseThrow();
        List<Long> ids = new ArrayList<>();
        try (ResultSet row = database.query("SELECT " + of.id() + " FROM " + table + " WHERE " + where, values)) {
            while (row.next()) {
                ids.add(row.getLong(1));
            }
        }
        for (long id : ids) {
            set(database, of, rows(database, of, null, " WHERE " + of.which(), " WHERE " + of.owner() + " = ?", id));
        }
    }

    /** Gives all rows their digests, but those that cannot be used: an earlier form had none. */
    static void sealAll(Database database, List<BadRow> unusable) throws SQLException {
        for (Table table : TABLES) {
            set(database, table, rows(database, table, null, "", ""));
            for (BadRow row : unusable) {
                String which = row.table().equals(table.name()) ? row.key() : row.table().equals(table.part())
                    ? "id IN (SELECT " + table.owner() + " FROM " + table.part() + " WHERE " + row.key() + ")" : "0";
                database.execute("UPDATE " + table.name() + " SET digest = 0 WHERE " + which);
            }
        }
    }

    private static void set(Database database, Table table, Rows rows) throws SQLException {
        for (int k = 0; k < rows.size; k++) {
            database.update("UPDATE " + table.name() + " SET digest = ?2 WHERE " + table.which(), rows.ids[k],
                rows.computed[k]);
        }
    }

    /** True if all rows have their digests, and none refers to another that is not there. */
    static boolean isSound(Database database) throws SQLException {
        Map<String, Rows> known = new HashMap<>();
        boolean sound = true;
        for (Table table : TABLES) {
            sound = sound && rows(database, table, known, "", "").isSound();
        }
        return sound;
    }

    /** Finds rows whose digest is another one. */
    static void check(Database database, Consumer<BadRow> taker) throws SQLException {
        for (Table table : TABLES) {
            Rows rows = rows(database, table, null, "", "");
            for (int k = 0; k < rows.size; k++) {
                if (rows.stored[k] != rows.computed[k]) {
                    taker.accept(new BadRow(table.name(), table.key(rows.ids[k]), "digest",
                        Long.toString(rows.stored[k]), rows.computed[k] + ", which follows from " + table.rows()
                        + ": a value was changed"));
                }
            }
        }
    }

    /** @param known the rows of tables, those of this one are added; {@code null} if nobody asks for references */
    private static Rows rows(Database database, Table table, Map<String, Rows> known, String where, String partWhere,
                             Object... values) throws SQLException {
        Rows rows = new Rows();
        scan(database, table, false, known, where + " ORDER BY " + table.order(), rows, values);
        if (known != null) {
            known.put(table.name(), rows);
        }
        if (table.part() != null) {
            scan(database, table, true, known, partWhere, rows, values);
        }
        return rows;
    }

    /** Reads a table, or its part; each value once, since fetching it costs more than finding it. */
    private static void scan(Database database, Table table, boolean isPart, Map<String, Rows> known, String which,
                             Rows rows, Object... values) throws SQLException {
        String name = isPart ? table.part() : table.name();
        Column[] columns = columns(database, name, known);
        List<String> names = Arrays.stream(columns).map(Column::name).toList();
        boolean isDecision = name.equals(DECISION);
        List<String> fetched = new ArrayList<>(isPart ? List.of() : isDecision ? List.of(table.id(), "digest")
            : List.of("digest"));
        int digestAt = fetched.size();
        int[] places = new int[columns.length];
        Set<Integer> lower = Arrays.stream(columns).map(Column::lower).collect(Collectors.toSet());
        for (int k = 0; k < columns.length; k++) {
            if (!lower.contains(k)) {
                fetched.add(columns[k].expression(columns));
                places[k] = fetched.size();
            }
        }
        int idAt = names.indexOf(isPart ? table.owner() : "id");
        int seasonAt = names.indexOf("season");
        int decisionAt = names.indexOf(DECISION);
        long[] found = new long[columns.length];
        StateHash hash = new StateHash();
        try (ResultSet row = database.query("SELECT " + String.join(", ", fetched) + " FROM " + name + which, values)) {
            while (row.next()) {
                hash.reset();
                long id = isDecision ? row.getLong(1) : 0;
                if (isDecision) {
                    hash.add(id >> Integer.SIZE);
                    hash.add((long) (int) id);
                }
                for (int k = 0; k < columns.length; k++) {
                    if (columns[k].lower() >= 0) {
                        long both = row.getLong(places[k]);
                        found[columns[k].lower()] = (int) both;
                        found[k] = both >> Integer.SIZE;
                        hash.add(found[k]);
                    } else if (places[k] == 0) {
                        hash.add(found[k]);
                    } else {
                        found[k] = add(hash, row, places[k], columns[k]);
                    }
                    rows.broken |= columns[k].referred() != null && found[k] != NOTHING && columns[k].referred()
                        .find(k == decisionAt ? found[seasonAt] << Integer.SIZE | found[k] : found[k]) < 0;
                }
                id = idAt < 0 ? id : found[idAt];
                if (isPart) {
                    rows.addPart(id, hash.value());
                } else {
                    rows.add(id, row.getLong(digestAt), hash.value());
                }
            }
        }
    }

    /** Adds a value. @return what it refers to if it is a whole number */
    private static long add(StateHash hash, ResultSet row, int place, Column column) throws SQLException {
        if (column.kind() == Kind.TEXT || column.kind() == Kind.BLOB) {
            byte[] bytes = row.getBytes(place);
            if (bytes == null) {
                hash.add(NOTHING);
            } else {
                add(hash, bytes);
            }
            return NOTHING;
        }
        if (column.kind() == Kind.REAL) {
            hash.add(row.getDouble(place) + 0.0);
            return NOTHING;
        }
        long whole = row.getLong(place);
        long value = whole == 0 && !column.isAlways() && row.wasNull() ? NOTHING : whole;
        hash.add(value);
        return value;
    }

    /** The columns of a table, but its digest and the two that are the id of a decision. */
    private static Column[] columns(Database database, String table, Map<String, Rows> known) throws SQLException {
        List<Column> columns = new ArrayList<>();
        int upper = -1;
        try (ResultSet row = database.query("SELECT name, type, \"notnull\" OR pk FROM pragma_table_info(?1) "
            + "WHERE name <> 'digest' AND NOT (?1 = '" + DECISION + "' AND name IN ('season', 'number'))", table)) {
            while (row.next()) {
                Column column = new Column(row.getString(1), Kind.valueOf(row.getString(2)), row.getBoolean(3),
                    known == null ? null : known.get(row.getString(1)), -1);
                boolean isSmall = SMALL.contains(column.name());
                if (isSmall && upper >= 0) {
                    Column other = columns.get(upper);
                    columns.set(upper, new Column(other.name(), other.kind(), true, other.referred(), columns.size()));
                }
                upper = !isSmall ? upper : upper < 0 ? columns.size() : -1;
                columns.add(column);
            }
        }
        return columns.toArray(new Column[0]);
    }
}

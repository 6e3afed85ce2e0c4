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
     * @param part the table whose rows belong to a row of this one, by a column of this one's name; or {@code null}
     */
    private record Table(String name, String part) {

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
    private static final List<Table> TABLES = List.of(new Table("season", null), new Table("version", "identity"),
        new Table("machine", null), new Table("lineup", null), new Table(DECISION, null), new Table("game", "seat"));
    /** Whole numbers from 0 to 2^31 - 1 in every row. */
    private static final Set<String> SMALL = Set.of("season", "version", "seat", "rank", "lineup", "number", "attempt",
        "counts", "turns", "dropped", "answers");
    /** Stands for a value that is not there. */
    private static final long NOTHING = 0x6E6F7468696E67L;

    private RowDigest() { }

    /** Types of columns: the tables are strict, so that no other value stands in them. */
    private enum Kind { INTEGER, REAL, TEXT, BLOB }

    /**
     * A column.
     *
     * @param half     which half of the numbers that are fetched by twos has it; 0 if it is fetched alone
     * @param place    where it is fetched alone
     * @param lacks    its bit in the first half, number 0, which is set where it has no value
     * @param referred the rows to which it refers; {@code null} if it refers to none, or they are not known
     */
    private record Column(String name, Kind kind, int half, int place, int lacks, Rows referred) { }

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
            if (value instanceof Double number) {
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
        hash.add(bytes == null ? NOTHING : bytes.length);
        for (int from = 0; bytes != null && from < bytes.length; from += Long.BYTES) {
            long word = 0;
            for (int k = from; k < Math.min(bytes.length, from + Long.BYTES); k++) {
                word = word << Byte.SIZE | bytes[k] & 0xFF;
            }
            hash.add(word);
        }
    }

    /**
     * Runs a statement that changes rows of a table, or adds some, and gives them the digests that they should have.
     *
     * @return the ids of these rows
     */
    static List<Long> sealed(Database database, String table, String statement, Object... values) {
        Table of = TABLES.stream().filter(each -> each.name().equals(table)).findFirst().orElseThrow();
        List<Long> ids = database.list(statement + " RETURNING " + of.id(), row -> row.getLong(1), values);
        ids.forEach(id -> set(database, of, rows(database, of, null, " WHERE " + of.which(), " WHERE " + table + " = ?",
            id)));
        return ids;
    }

    /** Gives all rows their digests, but those that cannot be used: an earlier form had none. */
    static void sealAll(Database database, List<BadRow> unusable) {
        for (Table table : TABLES) {
            set(database, table, rows(database, table, null, "", ""));
            for (BadRow row : unusable) {
                String which = row.table().equals(table.name()) ? row.key() : row.table().equals(table.part())
                    ? "id IN (SELECT " + table.name() + " FROM " + table.part() + " WHERE " + row.key() + ")" : "0";
                database.execute("UPDATE " + table.name() + " SET digest = 0 WHERE " + which);
            }
        }
    }

    private static void set(Database database, Table table, Rows rows) {
        for (int k = 0; k < rows.size; k++) {
            database.update("UPDATE " + table.name() + " SET digest = ?2 WHERE " + table.which(), rows.ids[k],
                rows.computed[k]);
        }
    }

    /** True if all rows have their digests, and none refers to another that is not there. */
    static boolean isSound(Database database) {
        Map<String, Rows> known = new HashMap<>();
        boolean sound = true;
        for (Table table : TABLES) {
            sound = sound && rows(database, table, known, "", "").isSound();
        }
        return sound;
    }

    /** Finds rows whose digest is another one. */
    static void check(Database database, Consumer<BadRow> taker) {
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
                             Object... values) {
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

    /** Reads a table, or its part: few values a row, since fetching one costs more than finding it. */
    private static void scan(Database database, Table table, boolean isPart, Map<String, Rows> known, String which,
                             Rows rows, Object... values) {
        String name = isPart ? table.part() : table.name();
        List<Column> columns = new ArrayList<>();
        List<String> fetched = new ArrayList<>(isPart ? List.of() : List.of("digest"));
        List<String> halves = new ArrayList<>(List.of("0"));
        database.each("SELECT name, type, \"notnull\" OR pk FROM pragma_table_info(?) WHERE name <> 'digest'", row -> {
            String column = row.getString(1);
            boolean isSmall = SMALL.contains(column);
            int bit = row.getBoolean(3) ? 0 : 1 << columns.size();
            (isSmall ? halves : fetched).add(column);
            halves.set(0, halves.get(0) + (bit == 0 ? "" : " + iif(" + column + " IS NULL, " + bit + ", 0)"));
            columns.add(new Column(column, Kind.valueOf(row.getString(2)), isSmall ? halves.size() - 1 : 0,
                fetched.size(), bit, known == null ? null : known.get(column)));
        }, name);
        int alone = fetched.size();
        for (int k = 0; k < halves.size(); k += 2) {
            fetched.add("(" + halves.get(k) + " << 32) | " + (k + 1 < halves.size() ? halves.get(k + 1) : "0"));
        }
        List<String> names = columns.stream().map(Column::name).toList();
        int idAt = names.indexOf(isPart ? table.name() : "id");
        int seasonAt = names.indexOf("season");
        long[] pairs = new long[fetched.size() - alone];
        long[] found = new long[columns.size()];
        StateHash hash = new StateHash();
        database.each("SELECT " + String.join(", ", fetched) + " FROM " + name + which, row -> {
            hash.reset();
            for (int k = 0; k < pairs.length; k++) {
                pairs[k] = row.getLong(alone + 1 + k);
            }
            for (int k = 0; k < found.length; k++) {
                Column column = columns.get(k);
                if (column.half() > 0) {
                    long pair = pairs[column.half() / 2];
                    found[k] = column.half() % 2 == 0 ? pair >> Integer.SIZE : (int) pair;
                    hash.add(found[k]);
                } else {
                    found[k] = add(hash, row, column, (pairs[0] >> Integer.SIZE & column.lacks()) != 0);
                }
                rows.broken |= column.referred() != null && found[k] != NOTHING && column.referred().find(
                    column.name().equals(DECISION) ? found[seasonAt] << Integer.SIZE | found[k] : found[k]) < 0;
            }
            long id = idAt >= 0 ? found[idAt] : found[seasonAt] << Integer.SIZE | found[seasonAt + 1];
            if (isPart) {
                rows.addPart(id, hash.value());
            } else {
                rows.add(id, row.getLong(1), hash.value());
            }
        }, values);
    }

    /** Adds a value that is fetched alone. @return what it refers to if it is a whole number */
    private static long add(StateHash hash, ResultSet row, Column column, boolean isLacking) throws SQLException {
        if (isLacking) {
            hash.add(NOTHING);
        } else if (column.kind() == Kind.INTEGER) {
            long whole = row.getLong(column.place());
            hash.add(whole);
            return whole;
        } else if (column.kind() == Kind.REAL) {
            hash.add(row.getDouble(column.place()) + 0.0);
        } else {
            add(hash, row.getBytes(column.place()));
        }
        return NOTHING;
    }
}

package steward.league.store;

import java.util.HashMap;
import java.util.Map;

/**
 * Table of numbered texts, written within a running transaction. Numbers are cached, so that they are not looked up for
 * every game. Not thread-safe.
 */
final class TextRows {

    private final Database database;
    private final String table;
    private final String column;
    private final Map<String, Long> known = new HashMap<>();

    TextRows(Database database, String table, String column) {
        this.database = database;
        this.table = table;
        this.column = column;
    }

    /** Forgets all numbers: what is rolled back may be among them. */
    void forget() {
        known.clear();
    }

    /** The number of a text, which is added if it is not there; it is kept only once it is surely stored. */
    long number(String text) {
        Long number = known.get(text);
        if (number != null) {
            return number;
        }
        Object found = database.value("SELECT id FROM " + table + " WHERE " + column + " = ?", text);
        if (found == null) {
            return RowDigest.sealed(database, table, "INSERT INTO " + table + " (" + column + ") VALUES (?)", text)
                .get(0);
        }
        known.put(text, ((Number) found).longValue());
        return ((Number) found).longValue();
    }
}

package steward.league.store;

/**
 * Unusable row of a league's database, with the reason.
 *
 * @param key      a condition of SQL that selects it
 * @param column   the first of its columns that is wrong
 * @param value    of the column, as SQL writes it
 * @param expected in its place
 */
public record BadRow(String table, String key, String column, String value, String expected) {

    @Override
    public String toString() {
        return "table " + table + ", row " + key + ", column " + column + ": found " + value + ", expected " + expected;
    }
}

package steward.text;

/**
 * A row of a table of comma-separated values (RFC 4180, but with the end of line that Unix has). Built cell by cell,
 * from left to right.
 */
public final class CsvRow {

    private final StringBuilder line = new StringBuilder();
    private boolean begun;

    /** Cells of words or numbers, each quoted if something in it would otherwise be read as part of the table. */
    public CsvRow words(String... cells) {
        for (String cell : cells) {
            boolean special = cell.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
            put(special ? quoted(cell) : cell);
        }
        return this;
    }

    /** A cell of free text, always quoted. */
    public CsvRow text(String cell) {
        put(quoted(cell));
        return this;
    }

    private void put(String written) {
        line.append(begun ? "," : "").append(written);
        begun = true;
    }

    private static String quoted(String cell) {
        return '"' + cell.replace("\"", "\"\"") + '"';
    }

    /** The row with its end of line. */
    public String line() {
        return line + "\n";
    }
}

package steward.text;

import java.util.regex.Pattern;

/**
 * Builder of a row of a CSV table (RFC 4180, but with the line end of Unix), cell by cell from left to right. A text
 * that a spreadsheet would take for a formula has an apostrophe before it.
 */
public final class CsvRow {

    /** Begins of formulas; apostrophes before one are part of the text. */
    private static final Pattern FORMULA = Pattern.compile("'*[=+@\\-\t\r].*", Pattern.DOTALL);
    private static final Pattern NUMBER = Pattern.compile("-?(\\d+(\\.\\d+)?(E-?\\d+)?|Infinity)");

    private final StringBuilder line = new StringBuilder();
    private boolean begun;

    /** Cells of words or numbers, each quoted if something in it would otherwise be read as part of the table. */
    public CsvRow words(String... cells) {
        for (String given : cells) {
            String cell = shielded(given);
            boolean special = cell.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
            put(special ? quoted(cell) : cell);
        }
        return this;
    }

    /** A cell of free text, always quoted. */
    public CsvRow text(String cell) {
        put(quoted(shielded(cell)));
        return this;
    }

    private static String shielded(String cell) {
        return FORMULA.matcher(cell).matches() && !NUMBER.matcher(cell).matches() ? "'" + cell : cell;
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

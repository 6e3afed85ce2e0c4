package steward.report;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.Function;
import steward.text.CsvRow;
import steward.text.TextFormat;

/**
 * Columns of a table, each described once for programs and for people. Programs read its name and value, as JSON and
 * CSV; people read its head and words in a width. A column may have one side only. Not thread-safe.
 *
 * @param <R> a row
 */
public final class Table<R> {

    private final List<String> names = new ArrayList<>();
    private final List<String> heads = new ArrayList<>();
    private final List<Function<R, ?>> values = new ArrayList<>();
    private final List<Shown<R>> shown = new ArrayList<>();

    /** Side of a column that people read. @param gap blanks before it; {@code width} includes them */
    private record Shown<R>(String head, int gap, int width, boolean left, Function<R, String> text,
                            BiFunction<R, String, String> painted) {

        private String padded(String word, int most) {
            return left ? " ".repeat(gap) + TextFormat.left(word, most) : TextFormat.right(word, width);
        }
    }

    /**
     * Adds a column for programs.
     *
     * @param name  in CSV, where a unit in brackets may follow, as {@code speed [u/turn]}; in JSON the part before it
     * @param value see {@link Fields}
     */
    public Table<R> value(String name, Function<R, ?> value) {
        names.add(name.replaceFirst(" \\[.*", ""));
        heads.add(name);
        values.add(value);
        return this;
    }

    /** Shows the last column for programs to people too, right-aligned. */
    public Table<R> shown(String head, int width) {
        Function<R, ?> value = values.get(values.size() - 1);
        return right(head, width, row -> value.apply(row).toString());
    }

    /** As above, of a number with so many decimals. */
    public Table<R> shown(String head, int width, int decimals) {
        Function<R, ?> value = values.get(values.size() - 1);
        return right(head, width, row -> TextFormat.fixed((Double) value.apply(row), decimals));
    }

    /** Adds a right-aligned column for people. @param width with the blanks before it */
    public Table<R> right(String head, int width, Function<R, String> text) {
        shown.add(new Shown<>(head, 0, width, false, text, (row, word) -> word));
        return this;
    }

    /** Adds a left-aligned column for people, as wide as its widest word. @param gap blanks before it */
    public Table<R> left(String head, int gap, Function<R, String> text) {
        shown.add(new Shown<>(head, gap, head.length(), true, text, (row, word) -> word));
        return this;
    }

    /** Gives the last column for people colours, which take no width. @param painted of a row and its padded word */
    public Table<R> painted(BiFunction<R, String, String> painted) {
        Shown<R> last = shown.remove(shown.size() - 1);
        shown.add(new Shown<>(last.head, last.gap, last.width, last.left, last.text, painted));
        return this;
    }

    /** The lines for people, the heads first. */
    public List<String> lines(Collection<R> rows) {
        int[] widths = shown.stream().mapToInt(column -> !column.left ? column.width : rows.stream()
            .mapToInt(row -> column.text.apply(row).length()).reduce(column.width, Math::max)).toArray();
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder();
        for (int k = 0; k < widths.length; k++) {
            line.append(shown.get(k).padded(shown.get(k).head, widths[k]));
        }
        lines.add(line.toString());
        for (R row : rows) {
            line.setLength(0);
            for (int k = 0; k < widths.length; k++) {
                Shown<R> column = shown.get(k);
                line.append(column.painted.apply(row, column.padded(column.text.apply(row), widths[k])));
            }
            lines.add(line.toString().stripTrailing());
        }
        return lines;
    }

    /** The values of a row as an object of JSON. */
    public Fields fields(R row) {
        Fields fields = Fields.of();
        for (int k = 0; k < names.size(); k++) {
            fields.with(names.get(k), values.get(k).apply(row));
        }
        return fields;
    }

    /** The rows as an array of JSON. */
    public Iterable<Object> json(Collection<R> rows) {
        return Fields.each(rows, this::fields);
    }

    /** The rows as CSV below the names, see {@link #csvRows}. */
    public String csv(Collection<R> rows, Function<Double, String> number, boolean quoted) {
        return new CsvRow().words(heads.toArray(new String[0])).line() + csvRows(rows, number, quoted);
    }

    /**
     * The rows as CSV; what is null or not finite is empty.
     *
     * @param number of a double
     * @param quoted whether every text stands between quotes
     */
    public String csvRows(Collection<R> rows, Function<Double, String> number, boolean quoted) {
        StringBuilder lines = new StringBuilder();
        for (R row : rows) {
            CsvRow cells = new CsvRow();
            for (Function<R, ?> value : values) {
                Object cell = value.apply(row);
                if (cell instanceof String text && quoted) {
                    cells.text(text);
                } else {
                    cells.words(cell == null || cell instanceof Double none && !Double.isFinite(none) ? ""
                        : cell instanceof Double some ? number.apply(some)
                        : cell instanceof Enum ? cell.toString().toLowerCase(Locale.ROOT) : cell.toString());
                }
            }
            lines.append(cells.line());
        }
        return lines.toString();
    }
}

package steward.replay.page;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/**
 * Rows of numbers over the turns of a match, by column, in steps as fine as a screen shows. A cell is a code of 32
 * bits. It is 0 for a value that is absent, and otherwise one more than the difference from a prediction, in steps.
 * Differences are folded, so that small ones of either sign are small numbers. The first bytes of all codes of a column
 * stand before the second bytes of all, and so on: of what is predicted well, most bytes are zero.
 */
final class PackedTable {

    /** Steps in the largest value of a column that is not whole: four to a pixel of a screen 4K wide, zoomed by 4. */
    private static final int STEPS = 1 << 16;
    /** Whole numbers below it are kept to the last digit. */
    private static final int MOST_WHOLE = 1 << 23;

    /** Values of one name; NaN where there is none. */
    private static final class Column {
        private float[] values = new float[256];
        private int filled;
        private float most;
        private boolean isWhole = true;

        private void put(int row, double value) {
            if (row >= values.length) {
                values = Arrays.copyOf(values, 2 * row);
            }
            Arrays.fill(values, Math.min(filled, row), row, Float.NaN);
            values[row] = (float) value;
            filled = row + 1;
            most = Math.max(most, Math.abs(values[row]));
            isWhole &= value == Math.rint(value) && Math.abs(value) < MOST_WHOLE;
        }

        private float value(int row) {
            return row < filled ? values[row] : Float.NaN;
        }

        private double step() {
            return isWhole ? 1 : most / STEPS;
        }
    }

    private final String name;
    private final boolean isSteady;
    private final Map<String, Column> columns = new LinkedHashMap<>();
    private int rows;
    /** Rows of each turn; -1 for a turn without such a table. */
    private final List<Integer> counts = new ArrayList<>();

    /** @param isSteady whether a row is predicted from its place in the two turns before, and not from the row above */
    PackedTable(String name, boolean isSteady) {
        this.name = name;
        this.isSteady = isSteady;
    }

    /** Sets a value of the row that is being filled. */
    void set(String column, double value) {
        columns.computeIfAbsent(column, none -> new Column()).put(rows, value);
    }

    void endRow() {
        rows++;
    }

    int rows() {
        return rows;
    }

    /** Forgets the rows from one on, and what was set behind it. */
    void dropFrom(int row) {
        rows = row;
        columns.values().forEach(column -> column.filled = Math.min(column.filled, row));
    }

    /** Ends a turn. @param from the first row of the turn, or -1 if it has no such table */
    void endTurn(int from) {
        counts.add(from < 0 ? -1 : rows - from);
    }

    /** Writes its name, the columns with their steps, and how many rows each turn has. */
    void describe(JsonGenerator out) {
        out.writeStringProperty("name", name);
        out.writeBooleanProperty("steady", isSteady);
        JsonObject.writeTexts(out, "columns", List.copyOf(columns.keySet()));
        JsonNumbers.writeAll(out, "steps", columns.values().stream().mapToDouble(Column::step).toArray());
        JsonNumbers.writeAll(out, "counts", counts.size(), counts::get);
    }

    /** Writes the codes of the turns that are kept, column by column. */
    void write(OutputStream out, IntPredicate isKept) throws IOException {
        for (Column column : columns.values()) {
            int[] codes = codes(column, isKept);
            byte[] plane = new byte[codes.length];
            for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
                for (int k = 0; k < codes.length; k++) {
                    plane[k] = (byte) (codes[k] >>> shift);
                }
                out.write(plane);
            }
        }
    }

    private int[] codes(Column column, IntPredicate isKept) {
        double step = column.step();
        int[] codes = new int[rows];
        int made = 0;
        int row = 0;
        int[] last = {};
        int[] lastButOne = {};
        for (int turn = 0; turn < counts.size(); turn++) {
            int count = Math.max(0, counts.get(turn));
            if (count == 0 || !isKept.test(turn)) {
                row += count;
                continue;
            }
            int[] steps = new int[count];
            for (int k = 0; k < count; k++, row++) {
                int predicted = prediction(k, steps, last, lastButOne);
                float value = column.value(row);
                steps[k] = Float.isNaN(value) ? predicted : (int) Math.rint(value / step);
                int off = steps[k] - predicted;
                codes[made++] = Float.isNaN(value) ? 0 : (off << 1 ^ off >> Integer.SIZE - 1) + 1;
            }
            lastButOne = last;
            last = steps;
        }
        return Arrays.copyOf(codes, made);
    }

    private int prediction(int k, int[] steps, int[] last, int[] lastButOne) {
        if (!isSteady || k >= last.length) {
            return k == 0 ? 0 : steps[k - 1];
        }
        return k < lastButOne.length ? 2 * last[k] - lastButOne[k] : last[k];
    }
}

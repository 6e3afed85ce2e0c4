package steward.lab.cli.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.cli.streams.Streams;
import steward.lab.bench.PerformancePage;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.text.TextFormat;

/** Printer of the benchmarks' table, row by row as it is measured. */
final class BenchTable {

    private static final int NAME = 42;
    private static final int FIGURE = 14;
    private static final int TIME = 12;
    private static final int RATIO = 9;
    private static final int WIDTH = 100;

    private final Streams streams;
    private final List<Row> held = new ArrayList<>();

    /** @param streams with a standard output that goes nowhere where JSON is printed in place of the table */
    BenchTable(Streams streams) {
        this.streams = streams;
    }

    void begin(Section section) {
        streams.out().println("\n" + section.name() + ": " + TextFormat.wrap(section.about(), " ", WIDTH, ""));
        streams.out().println("  " + TextFormat.left("", NAME) + TextFormat.right("a second", FIGURE)
            + TextFormat.right("each", TIME) + TextFormat.right("ratio", RATIO) + TextFormat.right("bytes", RATIO));
        streams.out().flush();
    }

    /** Holds a row back while a progress line is in its place. */
    synchronized void hold(Row row) {
        held.add(row);
    }

    /** Prints the rows that were held back; also when the run is interrupted. */
    synchronized void release() {
        held.forEach(this::add);
        held.clear();
    }

    void add(Row row) {
        String line = "  " + TextFormat.left(row.name(), NAME)
            + TextFormat.right(String.format(Locale.ROOT, "%,.0f", row.perSecond()), FIGURE)
            + TextFormat.right(PerformancePage.time(row.nanos()), TIME)
            + TextFormat.right(TextFormat.fixed(row.ratio(), 2), RATIO)
            + TextFormat.right(TextFormat.fixed(row.bytes(), 0), RATIO);
        streams.out().println(row.note().isEmpty() ? line : line + "  " + row.note());
        streams.out().flush();
    }
}

package steward.lab.cli.bench;

import java.util.ArrayList;
import java.util.List;
import steward.cli.streams.Streams;
import steward.lab.bench.BenchFiles;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.text.TextFormat;

/** Printer of the benchmarks' table, row by row as it is measured. */
final class BenchTable {

    private static final int WIDTH = 100;

    private final Streams streams;
    private final List<Row> held = new ArrayList<>();

    /** @param streams with a standard output that goes nowhere where JSON is printed in place of the table */
    BenchTable(Streams streams) {
        this.streams = streams;
    }

    void begin(Section section) {
        streams.out().println("\n" + section.name() + ": " + TextFormat.wrap(section.about(), " ", WIDTH, ""));
        streams.out().println(BenchFiles.COLUMNS.lines(List.of()).get(0));
        streams.out().flush();
    }

    /** Prints a row, or holds it back while a progress line is in its place. */
    synchronized void add(Row row) {
        held.add(row);
        if (!streams.errTerminal()) {
            release();
        }
    }

    /** Prints the rows that were held back; also when the run is interrupted. */
    synchronized void release() {
        held.forEach(row -> streams.out().println(BenchFiles.COLUMNS.lines(List.of(row)).get(1)));
        streams.out().flush();
        held.clear();
    }
}

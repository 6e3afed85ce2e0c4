package steward.cli.lab;

import java.util.Locale;
import java.util.function.Supplier;
import steward.cli.shared.Streams;
import steward.lab.stability.StabilityRow;
import steward.lab.trial.Finding;
import steward.text.TextFormat;

/** Prints the stability table as it is measured: per case the demand, and a line per rung with the result. */
final class StabilityTable {

    private static final int WIDTH = 100;
    private static final long PAUSE_NANOS = 250_000_000;
    private static final int RUNG = 13;
    private static final int VERDICT = 10;
    private static final String CLEAR = "\r" + " ".repeat(79) + "\r";

    private final Streams streams;
    private final int rows;
    private String lastCase = "";
    private String present = "";
    private volatile String unfinished = "";
    private long saidNanos = System.nanoTime();
    private int begun;
    private int held;
    private int failed;

    StabilityTable(Streams streams, int rows) {
        this.streams = streams;
        this.rows = rows;
    }

    /** Shows on a terminal what is being run. */
    void about(String name, String rung) {
        begun++;
        present = TextFormat.shorten(name, 40) + ", " + rung;
        show("");
    }

    /** Shows the progress of the current run. */
    void reached(double share, Supplier<String> soFar) {
        long now = System.nanoTime();
        if (now - saidNanos >= PAUSE_NANOS) {
            saidNanos = now;
            String percent = String.format(Locale.ROOT, ", %.1f%%", 100 * share);
            unfinished = present + percent + ": " + soFar.get();
            show(percent);
        }
    }

    /** The figures of the unfinished row, or nothing; any thread may call this. */
    String unfinished() {
        return unfinished;
    }

    private void show(String percent) {
        if (streams.errTerminal()) {
            streams.err().print(CLEAR + begun + " of " + rows + ": " + present + percent);
            streams.err().flush();
        }
    }

    void add(StabilityRow row) {
        clear();
        unfinished = "";
        if (!row.name().equals(lastCase)) {
            streams.out().println((lastCase.isEmpty() ? "" : "\n") + row.name());
            line("demanded", "", row.demand());
            lastCase = row.name();
        }
        Finding seen = row.seen();
        held += seen.verdict() == Finding.Verdict.HOLDS ? 1 : 0;
        failed += row.failed() ? 1 : 0;
        line(row.rung(), seen.verdict().name().toLowerCase(Locale.ROOT), seen.text());
        streams.out().flush();
    }

    private void line(String rung, String verdict, String text) {
        String start = "  " + TextFormat.left(rung, RUNG) + TextFormat.left(verdict, VERDICT);
        String next = "\n" + " ".repeat(start.length());
        String lines = TextFormat.wrap(TextFormat.plain(text), " ", WIDTH - start.length(), "");
        streams.out().println(start + lines.replace("\n", next));
    }

    private void clear() {
        if (streams.errTerminal()) {
            streams.err().print(CLEAR);
            streams.err().flush();
        }
    }

    /** @return whether no demand has failed */
    boolean end() {
        streams.out().println();
        streams.out().println(TextFormat.count(held, "demand") + (held == 1 ? " is" : " are") + " met, " + failed
            + (failed == 1 ? " is" : " are") + " not");
        return failed == 0;
    }
}

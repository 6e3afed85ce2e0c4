package steward.lab.cli;

import java.util.Locale;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import steward.cli.streams.Colour;
import steward.cli.streams.Streams;
import steward.lab.cli.shared.RunProgress;
import steward.lab.stability.StabilityRow;
import steward.lab.trial.Finding;
import steward.text.TextFormat;

/**
 * Printer of the stability table as it is measured: each case with its requirement, and a line per rung with the
 * result.
 */
final class StabilityTable {

    private static final int WIDTH = 100;
    private static final long PAUSE_NANOS = 250_000_000;
    private static final int RUNG = 13;
    private static final int VERDICT = 10;
    /** How long the name of a case may be, so that there is room for the bar. */
    private static final int NAME = 24;

    private final Streams streams;
    private final Colour colour;
    private final RunProgress progress;
    private String lastCase = "";
    private String present = "";
    private volatile String unfinished = "";
    private long saidNanos = System.nanoTime();
    private int held;
    private int failed;

    /** @param progress of all rows */
    StabilityTable(Streams streams, RunProgress progress) {
        this.streams = streams;
        colour = streams.outColour();
        this.progress = progress;
    }

    /** Shows on a terminal what is being run. */
    void about(String name, String rung) {
        present = name + ", " + rung;
        progress.begin(TextFormat.shorten(name, NAME) + ", " + rung);
    }

    /** Shows the progress of the current run. */
    void reached(double share, Supplier<String> soFar) {
        long now = System.nanoTime();
        if (now - saidNanos >= PAUSE_NANOS) {
            saidNanos = now;
            String percent = String.format(Locale.ROOT, ", %.1f%%", 100 * share);
            unfinished = present + percent + ": " + soFar.get();
            progress.reach(share);
        }
    }

    /** The figures of the unfinished row, or nothing; any thread may call this. */
    String unfinished() {
        return unfinished;
    }

    void add(StabilityRow row) {
        progress.end();
        unfinished = "";
        if (!row.name().equals(lastCase)) {
            streams.out().println((lastCase.isEmpty() ? "" : "\n") + colour.strong(row.name()));
            line("demanded", "", row.demand(), UnaryOperator.identity());
            lastCase = row.name();
        }
        Finding seen = row.seen();
        held += seen.verdict() == Finding.Verdict.HOLDS ? 1 : 0;
        failed += row.failed() ? 1 : 0;
        line(row.rung(), seen.verdict().name().toLowerCase(Locale.ROOT), seen.text(), switch (seen.verdict()) {
            case HOLDS -> colour::good;
            case FAILS -> colour::bad;
            default -> UnaryOperator.identity();
        });
        streams.out().flush();
    }

    private void line(String rung, String verdict, String text, UnaryOperator<String> painted) {
        int width = 2 + RUNG + VERDICT;
        String next = "\n" + " ".repeat(width);
        String lines = TextFormat.wrap(TextFormat.plain(text), " ", WIDTH - width, "");
        streams.out().println("  " + TextFormat.left(rung, RUNG) + painted.apply(TextFormat.left(verdict, VERDICT))
            + lines.replace("\n", next));
    }

    /** @return whether no demand has failed */
    boolean end() {
        streams.out().println();
        String not = failed + (failed == 1 ? " is" : " are") + " not";
        streams.out().println(TextFormat.count(held, "demand") + (held == 1 ? " is" : " are") + " met, "
            + (failed == 0 ? not : colour.bad(not)));
        return failed == 0;
    }
}

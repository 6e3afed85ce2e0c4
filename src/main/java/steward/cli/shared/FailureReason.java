package steward.cli.shared;

import java.io.PrintStream;
import java.util.List;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.contest.Failure;
import steward.report.Fields;
import steward.text.TextFormat;

/** Reason of a bot's failure, as text for people and as JSON for programs. */
public final class FailureReason {

    private static final int LONGEST = 120;

    private FailureReason() { }

    /** Prints the lines below the one with the reason: what its stderr says, and hints. */
    public static void print(PrintStream out, Failure failure, String indent) {
        List<String> lines = failure.stderr();
        if (lines.isEmpty()) {
            out.println(indent + "it wrote nothing to its stderr");
        } else if (!failure.error().isEmpty()) {
            out.println(indent + "its stderr says: " + TextFormat.plain(failure.error()));
        }
        if (lines.size() > (failure.error().isEmpty() ? 0 : 1)) {
            boolean onward = !failure.error().isEmpty() && lines.size() == Failure.LINES
                && lines.get(0).contains(failure.error());
            out.println(indent + (onward ? "with the lines behind it:" : lines.size() == 1
                ? "the last line of its stderr:" : "the last " + lines.size() + " lines of its stderr:"));
            lines.forEach(line -> out.println(indent + "  " + TextFormat.plain(line)));
        }
        for (String hint : failure.hints()) {
            out.println(indent + "hint: " + hint);
        }
    }

    /** {@code me failed in turn 3: exited with status 1 before answering (ValueError: found a dog)}. */
    static String line(String name, Failure failure) {
        return name + " failed in turn " + failure.turn() + ": " + failure.reason() + said(failure);
    }

    /** The line of its stderr that says why, in brackets and behind a blank; empty if none does. */
    public static String said(Failure failure) {
        return failure.error().isEmpty() ? "" : " (" + TextFormat.shorten(failure.error(), LONGEST) + ")";
    }

    /** The turn, and what may help. @return {@code null} for no failure, which is {@code null} */
    public static Fields fields(Failure failure) {
        return failure == null ? null : Fields.of("turn", failure.turn(), "error",
            failure.error().isEmpty() ? null : failure.error(), "stderr", failure.stderr(), "hints", failure.hints(),
            "time", time(failure.time()));
    }

    /**
     * Where the time of a late answer went, in milliseconds; null for what the system does not show.
     *
     * @param time or {@code null}, which is returned
     */
    public static Fields time(TimeSpent time) {
        if (time == null) {
            return null;
        }
        boolean any = time.shows() != TimeSpent.Shows.NOTHING;
        boolean waiting = any && time.shows() != TimeSpent.Shows.STEPS;
        return Fields.of("limitOf", (time.overCpu() ? TimeBasis.CPU : TimeBasis.WALL).word(),
            "limitMs", ms(time.limit(), true), "takenMs", ms(time.taken(), true),
            "unobservedMs", ms(time.unobserved(), any), "computedMs", ms(time.computed(), any),
            "waitedMs", ms(time.waited(), waiting), "otherMs", ms(time.other(), any), "cpuMs", ms(time.cpu(), any),
            "inSteps", any && time.shows() != TimeSpent.Shows.ALL, "starved", time.starved());
    }

    private static double ms(long nanos, boolean shown) {
        return shown ? nanos / TextFormat.NANOS_PER_MS : Double.NaN;
    }
}

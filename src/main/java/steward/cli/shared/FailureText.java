package steward.cli.shared;

import java.io.PrintStream;
import java.util.List;
import steward.contest.Failure;
import steward.text.TextFormat;

/** Reason of a bot's failure as text, for people. */
public final class FailureText {

    private static final int LONGEST = 120;

    private FailureText() { }

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
}

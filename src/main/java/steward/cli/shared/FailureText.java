package steward.cli.shared;

import java.io.PrintStream;
import steward.contest.Failure;
import steward.text.TextFormat;

/** Reason of a bot's failure, for people. */
public final class FailureText {

    private static final int LONGEST_LAST = 120;

    private FailureText() { }

    /** Prints the lines below the one with the reason: the last lines of its stderr, and hints. */
    public static void print(PrintStream out, Failure failure, String indent) {
        if (failure.stderr().isEmpty()) {
            out.println(indent + "it wrote nothing to its stderr");
        } else {
            out.println(indent + (failure.stderr().size() == 1 ? "the last line of its stderr:"
                : "the last " + failure.stderr().size() + " lines of its stderr:"));
            for (String line : failure.stderr()) {
                out.println(indent + "  " + TextFormat.plain(line));
            }
        }
        for (String hint : failure.hints()) {
            out.println(indent + "hint: " + hint);
        }
    }

    /** {@code me failed in turn 3: exited with status 1 before answering (ValueError: found a dog)}. */
    static String line(String name, Failure failure) {
        int lines = failure.stderr().size();
        String last = lines == 0 ? "" : " ("
            + TextFormat.shorten(failure.stderr().get(lines - 1).strip(), LONGEST_LAST) + ")";
        return name + " failed in turn " + failure.turn() + ": " + failure.reason() + last;
    }
}

package steward.bot;

import java.util.List;
import java.util.regex.Pattern;

/**
 * Line of a program's stderr that explains the program's failure. A line is recognised by the form in which
 * interpreters, virtual machines and C libraries write errors, never by a word alone: a bot may print "no Error" as
 * often as it likes. Of a chain of causes the first cause is taken, of compiler errors the first, otherwise the last
 * line.
 */
public final class ErrorLine {

    /** Characters of a line that are looked at. */
    private static final int LONGEST = 1000;
    /** Lines that a message with line ends may have, before its first frame. */
    private static final int MESSAGE = 50;

    /** One line that is enough by itself. */
    private static final Pattern FATAL = Pattern.compile("^FATAL ERROR: |^Fatal Python error: |^terminate called "
        + "|^libc\\+\\+abi: |: Assertion .* failed\\.$|^Assertion failed: |^==\\d+==\\s*ERROR: |:\\d+: runtime error: "
        + "|^memory allocation of \\d+ bytes failed|^thread '.*' .*has overflowed its stack|^Exception in thread \""
        + "|^Exception: \\S+ thrown from|^Unhandled exception\\. |^PHP Fatal error: |^\\S+:\\d+:in .* \\([\\w:]+\\)$");
    /** One that a Java launcher writes before what seems to be its cause. */
    private static final Pattern LAUNCHER = Pattern.compile("^Error: (Could not find or load|Unable to|Main method"
        + "|LinkageError|A JNI)");
    private static final Pattern WHAT = Pattern.compile("^\\s+what\\(\\): ");

    private static final Pattern FRAME = Pattern.compile("^\\s+at .*(\\)|:\\d+|line \\d+)( \\{|,)?$"
        + "|^\\s+\\.\\.\\. \\d+ (more|lines matching .*)$");
    private static final Pattern THROWN = Pattern.compile("^(Caused by: |Uncaught |Unhandled |\\(node:"
        + "|\\[?[\\w$.]*(Error|Exception|Rejection|Throwable)\\b|([\\w$]+\\.)+[\\w$]+(:|$))");
    private static final Pattern CAUSE = Pattern.compile("^\\s+\\[cause]: ");

    private static final Pattern CARET = Pattern.compile("^\\s*\\^+\\s*$");
    private static final Pattern PLACE = Pattern.compile("^\\S.*:\\d+$");

    private static final Pattern FILE = Pattern.compile("^\\s+File \".*\", line \\d+(, in .*)?$");
    private static final Pattern OF_GROUP = Pattern.compile("^\\s+\\| ");
    private static final String DIRECT = "The above exception was the direct cause of the following exception:";

    private static final Pattern GO = Pattern.compile("^(panic: |fatal error: |SIG[A-Z]+: )");
    private static final Pattern GOROUTINE = Pattern.compile("^goroutine \\d+ .*:$");

    private static final Pattern PANIC = Pattern.compile("^thread '.*' .*panicked at ");
    /** A panic that follows from another one. */
    private static final Pattern SECOND_PANIC = Pattern.compile("`Err` value: Any \\{|^panic in a ");

    private static final Pattern COMPILER = Pattern.compile("^\\S+:\\d+:(\\d+:)? (fatal )?error: "
        + "|^\\S+\\.go:\\d+:\\d+: |^\\S+\\(\\d+,\\d+\\): error ");
    private static final Pattern RUST_COMPILER = Pattern.compile("^error(\\[E\\d+])?: ");
    private static final Pattern ARROW = Pattern.compile("^\\s+--> ");

    /** Advice of Node's before the reason itself. */
    private static final Pattern ADVICE = Pattern.compile("This error originated either by throwing inside of an async "
        + "function .*?\\.catch\\(\\)\\. ");

    private final List<String> lines;
    private int found = -1;
    private int panic = -1;
    private boolean compiler;
    private boolean launcher;
    private boolean inFile;
    private boolean ignored;
    private boolean cause;

    private ErrorLine(List<String> lines) {
        this.lines = lines;
    }

    /**
     * Finds the line.
     *
     * @param lines what a program wrote to stderr, the failure at its end
     * @return its index, or -1 if none has a known form: then the last line is the likeliest
     */
    public static int index(List<String> lines) {
        ErrorLine search = new ErrorLine(lines);
        for (int at = 0; at < lines.size(); at++) {
            search.look(at);
        }
        return search.found < lines.size() ? search.found : -1;
    }

    /** Returns the line of a stderr, the last if none has a known form; empty for none, and for {@code null}. */
    public static String of(String stderr) {
        List<String> lines = stderr == null ? List.of() : stderr.lines().filter(line -> !line.isBlank()).toList();
        int index = index(lines);
        return lines.isEmpty() ? "" : text(lines.get(index < 0 ? lines.size() - 1 : index));
    }

    /** Returns a line without the space around it, and without what its interpreter always adds. */
    public static String text(String line) {
        return ADVICE.matcher(line).replaceFirst("").strip();
    }

    private String line(int at) {
        String line = at < 0 || at >= lines.size() ? "" : lines.get(at);
        return line.substring(0, Math.min(LONGEST, line.length()));
    }

    private void look(int at) {
        String line = line(at);
        boolean own = is(FATAL, line) || is(WHAT, line) && is(FATAL, line(at - 1)) || is(CAUSE, line);
        if (own) {
            found(at);
        } else if (is(LAUNCHER, line)) {
            found(at);
            launcher = true;
        } else if (line.startsWith("Caused by:") && found >= 0 && !launcher) {
            found(line.length() > "Caused by:".length() ? at : lastIndented(at));
        } else if (line.equals("Caused by:")) {
            found(lastIndented(at));
        } else if (line.equals("stack traceback:") && at > 0) {
            found(at - 1);
        } else if (is(CARET, line) && is(PLACE, line(at - 2))) {
            found(line(at + 1).isBlank() ? at + 2 : at + 1);
        } else if (is(FRAME, line) && !is(FRAME, line(at - 1))) {
            beforeFrames(at);
        } else if (is(PANIC, line)) {
            int message = line.endsWith(":") ? at + 1 : at;
            found(found >= 0 && is(SECOND_PANIC, line(message)) ? found : message);
        } else if (is(COMPILER, line) || is(RUST_COMPILER, line) && is(ARROW, line(at + 1))) {
            found(compiler ? found : at);
            compiler = true;
        }
        go(at, line);
        python(at, line);
    }

    private static boolean is(Pattern pattern, String line) {
        return pattern.matcher(line).find();
    }

    private void found(int at) {
        found = at;
        launcher = false;
    }

    private int lastIndented(int at) {
        int last = at;
        while (line(last + 1).startsWith(" ")) {
            last++;
        }
        return last;
    }

    /** Java and Node: the line before the frames, or some lines before if the message has line ends. */
    private void beforeFrames(int at) {
        int nearest = -1;
        for (int k = at - 1; k >= Math.max(0, at - MESSAGE) && !is(FRAME, line(k)); k--) {
            if (k == found) {
                return;
            }
            if (is(THROWN, line(k))) {
                found(k);
                return;
            }
            nearest = nearest < 0 && !line(k).isBlank() && !Character.isWhitespace(line(k).charAt(0)) ? k : nearest;
        }
        if (nearest == at - 1) {
            found(nearest);
        }
    }

    /** A panic is one if the routines follow. */
    private void go(int at, String line) {
        if (is(GO, line)) {
            panic = at;
        } else if (panic >= 0 && is(GOROUTINE, line)) {
            found(panic);
            panic = -1;
        }
    }

    /** The first line behind the files that is not indented. */
    private void python(int at, String whole) {
        String line = OF_GROUP.matcher(whole).replaceFirst("");
        if (line.startsWith("Exception ignored ")) {
            ignored = true;
        } else if (line.equals(DIRECT)) {
            cause = true;
        } else if (is(FILE, line)) {
            inFile = true;
        } else if (inFile && !line.isBlank() && !Character.isWhitespace(line.charAt(0))) {
            if (!ignored && !cause) {
                found(at);
            }
            inFile = false;
            ignored = false;
            cause = false;
        }
    }
}

package steward.game;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.io.Reader;
import java.math.BigDecimal;
import steward.text.TextFormat;

/**
 * Line protocol with which simulators of a game are checked. Input is states and commands, output the states one turn
 * later. The input is a sequence of courses of
 * <pre>
 * checkpointCount
 * x y                               checkpointCount times
 * tests
 * (lines of a test)                 tests times
 * </pre>
 * and each answer is flushed. Blank lines are skipped. An error names the line, what was found and what was expected.
 */
public abstract class SimulationLines {

    private static final int MAXIMUM_CHECKPOINTS = 1000;
    /** In characters; eight numbers with all their digits take a fifth of it. */
    private static final int LONGEST_LINE = 1000;
    /** Positions, speeds and angles beyond this are input errors; much larger ones would overflow. */
    private static final double MOST = 1e9;
    private static final int SHOWN = 60;

    private final BufferedReader in;
    private final PrintStream out;
    private int lineNumber;

    protected SimulationLines(BufferedReader in, PrintStream out) {
        this.in = in;
        this.out = out;
    }

    /** Refuses a course that has been read, if the game cannot be played on it. */
    protected void check(double[][] checkpoints) {
        // most games take any
    }

    /** Reads a test on a course and gives its answer, with line ends. */
    protected abstract String answer(double[][] checkpoints) throws IOException;

    /**
     * Answers every test until the end of the input, or until the output is closed.
     *
     * @return how many tests there were
     * @throws IllegalArgumentException if a line is missing or wrong
     */
    public final long run() throws IOException {
        long answered = 0;
        for (String first = line(); first != null; first = line()) {
            double[][] checkpoints = new double[whole(only(first), "checkpointCount", 2, MAXIMUM_CHECKPOINTS)][];
            for (int k = 0; k < checkpoints.length; k++) {
                String[] words = words("checkpoint " + k + ": ", "x y");
                checkpoints[k] = new double[] {number(words[0], "x"), number(words[1], "y")};
            }
            check(checkpoints);
            int tests = whole(only(required("the number of tests")), "number of tests", 0, Integer.MAX_VALUE);
            for (int test = 0; test < tests; test++) {
                out.print(answer(checkpoints));
                out.flush();
                answered++;
                if (out.checkError()) {
                    return answered;
                }
            }
        }
        return answered;
    }

    /**
     * Reads the words of the next line.
     *
     * @param what said before the form if there is no line
     * @param form a word for each word
     */
    protected final String[] words(String what, String form) throws IOException {
        String line = required(what + form);
        String[] words = line.split("\\s+");
        if (words.length != form.split(" ").length) {
            throw wrong("\"" + TextFormat.beginning(String.join(" ", words), SHOWN) + "\"", form);
        }
        return words;
    }

    /** Reads the next line. */
    protected final String required(String expected) throws IOException {
        String line = line();
        if (line == null) {
            throw wrong("the end of the input", expected);
        }
        return line;
    }

    private String only(String line) {
        if (line.split("\\s+").length > 1) {
            throw wrong("\"" + TextFormat.beginning(line, SHOWN) + "\"", "one number");
        }
        return line;
    }

    /** The next line that is not blank, or {@code null} at the end. */
    private String line() throws IOException {
        for (;;) {
            String line = read(in, LONGEST_LINE);
            lineNumber++;
            if (line != null && line.length() > LONGEST_LINE) {
                throw wrong("a line of more than " + LONGEST_LINE + " characters", "at most 8 words");
            }
            if (line == null || !line.isBlank()) {
                return line == null ? null : line.strip();
            }
        }
    }

    /** A whole number of a range. */
    protected final int whole(String word, String what, int low, int high) {
        try {
            int value = Integer.parseInt(word);
            if (value >= low && value <= high) {
                return value;
            }
        } catch (NumberFormatException problem) {
            // reported below, with the range
        }
        throw wrong(what + " \"" + TextFormat.beginning(word, SHOWN) + "\"", "a whole number " + low + ".." + high);
    }

    /** A number that is not too large. */
    protected final double number(String word, String what) {
        double value;
        try {
            value = Double.parseDouble(word);
        } catch (NumberFormatException problem) {
            value = Double.NaN;
        }
        if (!(Math.abs(value) <= MOST)) {
            throw wrong(what + " \"" + TextFormat.beginning(word, SHOWN) + "\"", "a number -1e9..1e9");
        }
        return value;
    }

    /** All digits without an exponent, which not every reader accepts. */
    protected static String plain(double value) {
        return value == 0 ? "0" : new BigDecimal(Double.toString(value)).stripTrailingZeros().toPlainString();
    }

    private IllegalArgumentException wrong(String found, String expected) {
        return wrong("found " + found + ", expected " + expected);
    }

    /** Says what is wrong with the last line read. */
    protected final IllegalArgumentException wrong(String problem) {
        return new IllegalArgumentException("input line " + lineNumber + ": " + problem);
    }

    /**
     * Reads up to the next line feed. The input may be endless, so a line that is too long is abandoned.
     *
     * @return the line without its line feed, or its first {@code most + 1} characters if it is longer, or {@code null}
     *         at the end of the input
     */
    private static String read(Reader in, int most) throws IOException {
        int character = in.read();
        if (character < 0) {
            return null;
        }
        StringBuilder line = new StringBuilder();
        for (; character >= 0 && character != '\n'; character = in.read()) {
            line.append((char) character);
            if (line.length() > most) {
                break;
            }
        }
        return line.toString();
    }
}

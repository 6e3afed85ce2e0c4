package steward.game.searchrace.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import steward.game.searchrace.CarExpressions;
import steward.game.searchrace.SearchRace;
import steward.text.BoundedLine;
import steward.text.TextFormat;
import tools.jackson.core.io.NumberOutput;

/**
 * The line protocol with which simulators of the search race are checked, in the manner of that of the pod race. The
 * input is a sequence of courses of
 * <pre>
 * checkpointCount
 * x y                               checkpointCount times
 * tests
 * x y vx vy angleDegrees passed     \ tests times
 * X Y THRUST | EXPERT ANGLE THRUST  /
 * </pre>
 * and after each test the new state is printed in the same form, followed by the time of the last checkpoint passed in
 * the turn (2.0 if none was), and flushed. Blank lines are skipped.
 */
final class CarSimulator {

    private static final int MAXIMUM_CHECKPOINTS = 1000;
    private static final int STATE_FIELDS = 6;
    /** Positions and speeds beyond this are input errors; much larger ones would overflow. */
    private static final double MOST = 1e9;
    /** In characters; a line of numbers with all their digits takes a fifth of it. */
    private static final int LONGEST_LINE = 1000;
    private static final String STATE = "x y vx vy angleDegrees passed";

    private final SearchRaceType.SearchRaceSetup setup;
    private final BufferedReader in;
    private final PrintStream out;
    private int lineNumber;

    CarSimulator(SearchRaceType.SearchRaceSetup setup, BufferedReader in, PrintStream out) {
        this.setup = setup;
        this.in = in;
        this.out = out;
    }

    /**
     * Answers every test until the end of the input, or until the output is closed.
     *
     * @return how many tests there were
     * @throws IllegalArgumentException if a line is missing or wrong; the message names it
     */
    long run() throws IOException {
        long answered = 0;
        for (String first = line(); first != null; first = line()) {
            double[][] course = new double[whole(first, "checkpointCount", 2, MAXIMUM_CHECKPOINTS)][];
            for (int k = 0; k < course.length; k++) {
                String[] words = words("checkpoint " + k + ": x y", 2);
                course[k] = new double[] {number(words[0]), number(words[1])};
            }
            int tests = whole(required("the number of tests"), "number of tests", 0, Integer.MAX_VALUE);
            for (int test = 0; test < tests; test++) {
                answer(setup.create(course));
                answered++;
                if (out.checkError()) {
                    return answered;
                }
            }
        }
        return answered;
    }

    private void answer(SearchRace race) throws IOException {
        String[] words = words("state: " + STATE, STATE_FIELDS);
        double[] state = new double[STATE_FIELDS - 1];
        for (int k = 0; k < state.length; k++) {
            state[k] = number(words[k]);
        }
        race.set(state[0], state[1], state[2], state[3], CarExpressions.radians(state[4]),
            whole(words[5], "passed", 0, race.toFinish() - 1), 0, SearchRace.NOT_PASSED);
        byte[] command = required("command: X Y THRUST or EXPERT ANGLE THRUST").getBytes(StandardCharsets.UTF_8);
        String wrong = new SearchRaceText(race).readAnswer(0, command, command.length);
        if (wrong != null) {
            throw new IllegalArgumentException("input line " + lineNumber + ": " + wrong);
        }
        race.play();
        out.println(plain(race.bodies().x[0]) + " " + plain(race.bodies().y[0]) + " " + plain(race.bodies().vx[0]) + " "
            + plain(race.bodies().vy[0]) + " " + CarExpressions.degrees(race.heading()) + " " + race.passed() + " "
            + NumberOutput.toString(race.passTime(), true));
        out.flush();
    }

    /** All digits without an exponent, which not every reader accepts. */
    private static String plain(double value) {
        return value == 0 ? "0" : new BigDecimal(Double.toString(value)).stripTrailingZeros().toPlainString();
    }

    private String[] words(String expected, int count) throws IOException {
        String line = required(expected);
        String[] words = line.split("\\s+");
        if (words.length != count) {
            throw wrong("\"" + TextFormat.beginning(line, 60) + "\"", expected);
        }
        return words;
    }

    private String required(String expected) throws IOException {
        String line = line();
        if (line == null) {
            throw wrong("the end of the input", expected);
        }
        return line;
    }

    /** The next line that is not blank, or {@code null} at the end. */
    private String line() throws IOException {
        for (;;) {
            String line = BoundedLine.read(in, LONGEST_LINE);
            lineNumber++;
            if (line != null && line.length() > LONGEST_LINE) {
                throw wrong("a line of more than " + LONGEST_LINE + " characters", "some numbers");
            }
            if (line == null || !line.isBlank()) {
                return line == null ? null : line.strip();
            }
        }
    }

    private int whole(String word, String what, int low, int high) {
        try {
            int value = Integer.parseInt(word);
            if (value >= low && value <= high) {
                return value;
            }
        } catch (NumberFormatException problem) {
            // reported below, with the range
        }
        throw wrong(what + " \"" + TextFormat.beginning(word, 60) + "\"", "a whole number " + low + ".." + high);
    }

    private double number(String word) {
        double value;
        try {
            value = Double.parseDouble(word);
        } catch (NumberFormatException problem) {
            value = Double.NaN;
        }
        if (!(Math.abs(value) <= MOST)) {
            throw wrong("\"" + TextFormat.beginning(word, 60) + "\"", "a number -1e9..1e9");
        }
        return value;
    }

    private IllegalArgumentException wrong(String found, String expected) {
        return new IllegalArgumentException("input line " + lineNumber + ": found " + found + ", expected " + expected);
    }
}

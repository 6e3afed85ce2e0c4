package steward.game.podrace.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.util.Locale;
import steward.Internal;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.PodState;
import steward.text.BoundedLine;
import steward.text.TextFormat;

/**
 * The line protocol with which the community checks pod-race simulators: input is states and commands, output the
 * states one turn later. The input is a sequence of games of
 * <pre>
 * checkpointCount
 * x y                                                      checkpointCount times
 * tests
 * x y vx vy angleDegrees nextCheckpointId shield boosted   4 times  \ tests times
 * targetX targetY thrust|SHIELD|BOOST                      4 times  /
 * </pre>
 * and after each test the four new states are printed in the same form and flushed. {@code shield} is 3 after the turn
 * a shield was raised and counts down; {@code boosted} is 1 once the boost is used up. Every state is complete:
 * headings are set. Blank lines are skipped.
 */
@Internal
public final class SimulatorProtocol {

    private static final int PODS = 4;
    private static final int STATE_FIELDS = 8;
    private static final int MAXIMUM_CHECKPOINTS = 1000;
    /** In characters; eight numbers with all their digits take a fifth of it. */
    private static final int LONGEST_LINE = 1000;
    /** Positions, speeds and angles beyond this are input errors; much larger ones would overflow. */
    private static final double MOST = 1e9;

    private final PodRaceType.PodRaceSetup setup;
    private final BufferedReader in;
    private final PrintStream out;
    private int lineNumber;

    /**
     * @param setup a race of four pods
     * @throws IllegalArgumentException if the race has another number of pods
     */
    public SimulatorProtocol(PodRaceType.PodRaceSetup setup, BufferedReader in, PrintStream out) {
        if (setup.settings().pods() != PODS) {
            throw new IllegalArgumentException("the scene has " + setup.settings().pods() + " pods, expected " + PODS);
        }
        this.setup = setup;
        this.in = in;
        this.out = out;
    }

    /**
     * Answers every test until the end of the input, or until the output is closed.
     *
     * @return how many tests there were
     * @throws IllegalArgumentException if a line is missing or wrong; the message names it, what was found and what was
     *                                  expected
     */
    public long run() throws IOException {
        long tests = 0;
        for (String[] first = words(); first != null; first = words()) {
            double[][] checkpoints = readCheckpoints(first);
            int count = whole(only(require("the number of tests")), "number of tests", 0, Integer.MAX_VALUE);
            for (int test = 0; test < count; test++) {
                answer(checkpoints);
                tests++;
                if (out.checkError()) {
                    return tests;
                }
            }
        }
        return tests;
    }

    private double[][] readCheckpoints(String[] first) throws IOException {
        double[][] checkpoints = new double[whole(only(first), "checkpointCount", 2, MAXIMUM_CHECKPOINTS)][];
        for (int k = 0; k < checkpoints.length; k++) {
            String[] words = require("checkpoint " + k + ": x y");
            expectWords(words, 2, "x y");
            checkpoints[k] = new double[] {number(words[0], "x"), number(words[1], "y")};
        }
        if (checkpoints[0][0] == checkpoints[1][0] && checkpoints[0][1] == checkpoints[1][1]) {
            throw wrong("checkpoints 0 and 1 in the same place", "two places");
        }
        return checkpoints;
    }

    private void answer(double[][] checkpoints) throws IOException {
        PodRace race = setup.create(checkpoints);
        for (int pod = 0; pod < PODS; pod++) {
            race.setPod(pod, readState(pod, checkpoints.length));
        }
        for (int pod = 0; pod < PODS; pod++) {
            String[] words = require("command of pod " + pod + ": targetX targetY thrust|SHIELD|BOOST");
            expectWords(words, 3, "targetX targetY thrust|SHIELD|BOOST");
            race.command(pod, number(words[0], "targetX"), number(words[1], "targetY"), thrust(words[2]));
        }
        race.play();
        StringBuilder lines = new StringBuilder();
        for (int pod = 0; pod < PODS; pod++) {
            PodState state = race.pod(pod);
            append(lines, state.x()).append(' ');
            append(lines, state.y()).append(' ');
            append(lines, state.vx()).append(' ');
            append(lines, state.vy()).append(' ');
            append(lines, PodJsonCache.degrees(state.heading())).append(' ');
            lines.append(race.nextCheckpoint(pod)).append(' ').append(Math.max(0, state.shieldTimer() - 1)).append(' ')
                .append(state.boostLeft() ? 0 : 1).append('\n');
        }
        out.print(lines);
        out.flush();
    }

    private PodState readState(int pod, int checkpoints) throws IOException {
        String form = "x y vx vy angleDegrees nextCheckpointId shield boosted";
        String[] words = require("state of pod " + pod + ": " + form);
        expectWords(words, STATE_FIELDS, form);
        int next = whole(words[5], "nextCheckpointId", 0, checkpoints - 1);
        int shield = whole(words[6], "shield", 0, PodRaceSettings.SHIELD_TURNS - 1);
        int boosted = whole(words[7], "boosted", 0, 1);
        return new PodState(number(words[0], "x"), number(words[1], "y"), number(words[2], "vx"),
            number(words[3], "vy"), Math.toRadians(number(words[4], "angleDegrees")), shield == 0 ? 0 : shield + 1,
            boosted == 0, (next + checkpoints - 1) % checkpoints);
    }

    private int thrust(String word) {
        return switch (word.toUpperCase(Locale.ROOT)) {
            case "SHIELD" -> PodRace.SHIELD;
            case "BOOST" -> PodRace.BOOST;
            default -> whole(word, "thrust (or SHIELD or BOOST)", 0, setup.settings().maximumThrust());
        };
    }

    /** All digits without an exponent, which not every reader accepts. */
    private static StringBuilder append(StringBuilder lines, double value) {
        return lines.append(value == 0 ? "0" : new BigDecimal(Double.toString(value)).stripTrailingZeros()
            .toPlainString());
    }

    private String only(String[] words) {
        expectWords(words, 1, "one number");
        return words[0];
    }

    private void expectWords(String[] words, int count, String form) {
        if (words.length != count) {
            throw wrong("\"" + shorten(String.join(" ", words)) + "\"", form);
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
        throw wrong(what + " \"" + shorten(word) + "\"", "a whole number " + low + ".." + high);
    }

    private double number(String word, String what) {
        double value;
        try {
            value = Double.parseDouble(word);
        } catch (NumberFormatException problem) {
            value = Double.NaN;
        }
        if (!(Math.abs(value) <= MOST)) {
            throw wrong(what + " \"" + shorten(word) + "\"", "a number -1e9..1e9");
        }
        return value;
    }

    private String[] require(String expected) throws IOException {
        String[] words = words();
        if (words == null) {
            throw wrong("the end of the input", expected);
        }
        return words;
    }

    /** The words of the next line that has any, or {@code null} at the end. */
    private String[] words() throws IOException {
        for (;;) {
            lineNumber++;
            String line = line();
            if (line == null) {
                return null;
            }
            if (!line.isBlank()) {
                return line.strip().split("\\s+");
            }
        }
    }

    /** The next line, or {@code null} at the end; one that goes on and on is refused before it fills the memory. */
    private String line() throws IOException {
        String line = BoundedLine.read(in, LONGEST_LINE);
        if (line != null && line.length() > LONGEST_LINE) {
            throw wrong("a line of more than " + LONGEST_LINE + " characters", "at most " + STATE_FIELDS
                + " words");
        }
        return line;
    }

    private IllegalArgumentException wrong(String found, String expected) {
        return new IllegalArgumentException("input line " + lineNumber + ": found " + found + ", expected " + expected);
    }

    private static String shorten(String text) {
        return TextFormat.beginning(text, 60);
    }
}

package steward.codingame;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.codingame.GameRecording.Counter;
import steward.codingame.GameRecording.Impact;
import steward.codingame.GameRecording.Pod;

/**
 * The text that a frame of CodinGame's JSON has for the site's viewer, line by line:
 * <pre>
 * line 0      the number of the frame, perhaps with words around it
 * frame 0     CodersStrikeBack
 *             width height podRadius checkpointRadius pods turnPerTurn
 *             x y x y ...                                            the checkpoints
 *             player x y player x y ...                              where the pods start
 * a pod       x y vx vy power dead targetX targetY headingRadians|null shield nextCheckpoint rank
 *             "message"
 * then        rank:turnsLeft rank:turnsLeft                          both players on one line
 * per impact  id time podA xA yA podB xB yB impulse vx vy
 * </pre>
 * Places of impacts are rounded; their vx, vy are half the sum of both speeds before the impact, rounded. A view may
 * end before its pods or before its counters. Errors name the frame and the line.
 */
final class FrameView {

    private static final int SIZES_LINE = 2;
    private static final int CHECKPOINT_LINE = 3;
    private static final int FIRST_POD_LINE_OF_START = 5;
    private static final int FIRST_POD_LINE = 1;
    private static final int PODS_WORD = 4;
    private static final int POD_WORDS = 12;
    private static final int IMPACT_WORDS = 11;

    /** A number as JSON and Java write it: no hexadecimal, no suffix, no name. */
    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
    private static final Pattern COUNTER = Pattern.compile("([1-9]):(-?[0-9]{1,6})");
    private static final Pattern FRAME_NUMBER = Pattern.compile("(?:[A-Z_]+)?\\s*([0-9]{1,9})(?:\\s.*)?");

    private final String source;
    private final int frame;
    private final String[] lines;

    /**
     * @param source name of the file, for errors
     * @param frame  its number
     * @param text   of the view, or {@code null} if the frame has none
     */
    FrameView(String source, int frame, String text) {
        this.source = source;
        this.frame = frame;
        lines = text == null || text.isBlank() ? new String[0] : text.stripTrailing().split("\r?\n", -1);
    }

    /** Checks that the view is that of its frame: where frames are missing, the numbers differ. */
    void checkNumber() {
        if (lines.length == 0) {
            return;
        }
        Matcher matcher = FRAME_NUMBER.matcher(lines[0].stripTrailing());
        if (!matcher.matches()) {
            throw wrong(0, "the number of the frame, " + frame);
        }
        if (Integer.parseInt(matcher.group(1)) != frame) {
            throw wrong(0, "the number of the frame, " + frame + ": frames are missing, or more than there were");
        }
    }

    double[][] checkpoints() {
        String[] sizes = words(SIZES_LINE);
        if (sizes.length > PODS_WORD && number(sizes[PODS_WORD], SIZES_LINE) != GameRecording.PODS) {
            throw wrong(SIZES_LINE, GameRecording.PODS + " pods as the fifth number: two players with two each");
        }
        String[] words = words(CHECKPOINT_LINE);
        if (words.length < 4 || words.length % 2 != 0) {
            throw wrong(CHECKPOINT_LINE, "x y of two or more checkpoints");
        }
        double[][] checkpoints = new double[words.length / 2][];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpoints[k] = new double[] {number(words[2 * k], CHECKPOINT_LINE),
                number(words[2 * k + 1], CHECKPOINT_LINE)};
        }
        return checkpoints;
    }

    /** @param checkpoints how many there are */
    GameRecording.State start(int checkpoints) {
        return state(FIRST_POD_LINE_OF_START, checkpoints);
    }

    /** As {@link #start}, of a key frame that ends a turn. */
    GameRecording.State state(int checkpoints) {
        return state(FIRST_POD_LINE, checkpoints);
    }

    private GameRecording.State state(int first, int checkpoints) {
        if (lines.length <= first) {
            return GameRecording.State.UNKNOWN;
        }
        List<Pod> pods = new ArrayList<>();
        for (int pod = 0; pod < GameRecording.PODS; pod++) {
            pods.add(pod(pod, first + 2 * pod, checkpoints));
        }
        return new GameRecording.State(pods, counters(first + 2 * GameRecording.PODS));
    }

    /** A pod and its message; -0 as 0. */
    private Pod pod(int pod, int line, int checkpoints) {
        String[] words = words(line);
        if (words.length != POD_WORDS) {
            throw wrong(line, "pod " + pod
                + ": x y vx vy power dead targetX targetY heading shield nextCheckpoint rank");
        }
        if (line + 1 >= lines.length || !lines[line + 1].strip().startsWith("\"")) {
            throw wrong(line + 1, "the message of pod " + pod + " in quotes");
        }
        double heading = words[8].equals("null") ? Double.NaN : number(words[8], line);
        return new Pod(number(words[0], line) + 0.0, number(words[1], line) + 0.0, number(words[2], line) + 0.0,
            number(words[3], line) + 0.0, heading, whole(words[9], 1, line) == 1,
            whole(words[10], checkpoints - 1, line));
    }

    private List<Counter> counters(int line) {
        if (line >= lines.length) {
            return List.of();
        }
        List<Counter> counters = new ArrayList<>();
        for (String word : words(line)) {
            Matcher matcher = COUNTER.matcher(word);
            if (!matcher.matches() || Integer.parseInt(matcher.group(1)) > GameRecording.PLAYERS) {
                counters.clear();
                break;
            }
            counters.add(new Counter(Integer.parseInt(matcher.group(1)) - 1, Integer.parseInt(matcher.group(2))));
        }
        if (counters.size() != GameRecording.PLAYERS) {
            throw wrong(line, "rank:turnsLeft of both players on one line, such as \"1:99 2:99\"");
        }
        return counters;
    }

    /** The impacts behind the counters of a key frame that ends a turn; {@code null} if it ends before them. */
    List<Impact> impacts() {
        int first = FIRST_POD_LINE + 2 * GameRecording.PODS + 1;
        if (lines.length < first) {
            return null;
        }
        List<Impact> impacts = new ArrayList<>();
        for (int line = first; line < lines.length; line++) {
            String[] words = words(line);
            if (words.length != IMPACT_WORDS) {
                throw wrong(line, "an impact: id time podA xA yA podB xB yB impulse vx vy");
            }
            impacts.add(impact(words, line));
        }
        return impacts;
    }

    private Impact impact(String[] words, int line) {
        Impact impact = new Impact(number(words[1], line), pod(words[2], line), whole(words[3], line),
            whole(words[4], line), pod(words[5], line), whole(words[6], line), whole(words[7], line),
            number(words[8], line), whole(words[9], line), whole(words[10], line));
        if (impact.time() < 0 || impact.time() > 1) {
            throw wrongWord(words[1], line, "a time 0..1 within the turn");
        }
        if (impact.a() == impact.b()) {
            throw wrong(line, "an impact of two different pods");
        }
        return impact;
    }

    private int pod(String word, int line) {
        return whole(word, GameRecording.PODS - 1, line);
    }

    /** A whole number from 0. */
    private int whole(String word, int most, int line) {
        double value = number(word, line);
        if (value != Math.rint(value) || value < 0 || value > most) {
            throw wrongWord(word, line, "a whole number 0.." + most);
        }
        return (int) value;
    }

    private long whole(String word, int line) {
        double value = number(word, line);
        if (value != Math.rint(value) || Math.abs(value) > 1e15) {
            throw wrongWord(word, line, "a whole number");
        }
        return (long) value;
    }

    private double number(String word, int line) {
        double value = NUMBER.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
        if (Double.isFinite(value)) {
            return value;
        }
        throw wrongWord(word, line, "a finite number");
    }

    private String[] words(int line) {
        return line >= lines.length || lines[line].isBlank() ? new String[0] : lines[line].strip().split("\\s+");
    }

    private IllegalArgumentException wrongWord(String word, int line, String expected) {
        return wrong(line, GameRecordingReader.quote(word), expected);
    }

    private IllegalArgumentException wrong(int line, String expected) {
        return wrong(line, line < lines.length ? GameRecordingReader.quote(lines[line]) : "the end of the view",
            expected);
    }

    private IllegalArgumentException wrong(int line, String found, String expected) {
        return new IllegalArgumentException(source + ": frame " + frame + ", view line " + line + ": found " + found
            + ", expected " + expected);
    }
}

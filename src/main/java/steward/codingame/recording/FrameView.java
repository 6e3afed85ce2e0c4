package steward.codingame.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import steward.codingame.recording.GameRecording.Counter;
import steward.codingame.recording.GameRecording.Impact;
import steward.codingame.recording.GameRecording.Pod;
import steward.text.ViewLines;

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
 *
 * @param lines of the view; none if the frame has none
 */
record FrameView(ViewLines lines) {

    private static final int SIZES_LINE = 2;
    private static final int CHECKPOINT_LINE = 3;
    private static final int FIRST_POD_LINE_OF_START = 5;
    private static final int FIRST_POD_LINE = 1;
    private static final int PODS_WORD = 4;
    private static final int POD_WORDS = 12;
    private static final int IMPACT_WORDS = 11;

    private static final Pattern COUNTER = Pattern.compile("([1-9]):(-?[0-9]{1,6})");

    double[][] checkpoints() {
        String[] sizes = lines.words(SIZES_LINE);
        if (sizes.length > PODS_WORD && lines.number(sizes[PODS_WORD], SIZES_LINE) != GameRecording.PODS) {
            throw lines.wrong(SIZES_LINE, GameRecording.PODS + " pods as the fifth number: two players with two each");
        }
        String[] words = lines.words(CHECKPOINT_LINE);
        if (words.length < 4 || words.length % 2 != 0) {
            throw lines.wrong(CHECKPOINT_LINE, "x y of two or more checkpoints");
        }
        double[][] checkpoints = new double[words.length / 2][];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpoints[k] = new double[] {lines.number(words[2 * k], CHECKPOINT_LINE),
                lines.number(words[2 * k + 1], CHECKPOINT_LINE)};
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
        if (lines.count() <= first) {
            return GameRecording.State.UNKNOWN;
        }
        List<Pod> pods = IntStream.range(0, GameRecording.PODS)
            .mapToObj(pod -> pod(pod, first + 2 * pod, checkpoints)).toList();
        return new GameRecording.State(pods, counters(first + 2 * GameRecording.PODS));
    }

    /** A pod and its message; -0 as 0. */
    private Pod pod(int pod, int line, int checkpoints) {
        String[] words = lines.words(line);
        if (words.length != POD_WORDS) {
            throw lines.wrong(line, "pod " + pod
                + ": x y vx vy power dead targetX targetY heading shield nextCheckpoint rank");
        }
        if (line + 1 >= lines.count() || !lines.line(line + 1).strip().startsWith("\"")) {
            throw lines.wrong(line + 1, "the message of pod " + pod + " in quotes");
        }
        double heading = words[8].equals("null") ? Double.NaN : lines.number(words[8], line);
        return new Pod(lines.number(words[0], line) + 0.0, lines.number(words[1], line) + 0.0, lines.number(words[2],
            line) + 0.0,
            lines.number(words[3], line) + 0.0, heading, lines.whole(words[9], 1, line) == 1,
            lines.whole(words[10], checkpoints - 1, line));
    }

    private List<Counter> counters(int line) {
        if (line >= lines.count()) {
            return List.of();
        }
        List<Counter> counters = new ArrayList<>();
        for (String word : lines.words(line)) {
            Matcher matcher = COUNTER.matcher(word);
            if (!matcher.matches() || Integer.parseInt(matcher.group(1)) > GameRecording.PLAYERS) {
                counters.clear();
                break;
            }
            counters.add(new Counter(Integer.parseInt(matcher.group(1)) - 1, Integer.parseInt(matcher.group(2))));
        }
        if (counters.size() != GameRecording.PLAYERS) {
            throw lines.wrong(line, "rank:turnsLeft of both players on one line, such as \"1:99 2:99\"");
        }
        return counters;
    }

    /** The impacts behind the counters of a key frame that ends a turn; {@code null} if it ends before them. */
    List<Impact> impacts() {
        int first = FIRST_POD_LINE + 2 * GameRecording.PODS + 1;
        if (lines.count() < first) {
            return null;
        }
        List<Impact> impacts = new ArrayList<>();
        for (int line = first; line < lines.count(); line++) {
            String[] words = lines.words(line);
            if (words.length != IMPACT_WORDS) {
                throw lines.wrong(line, "an impact: id time podA xA yA podB xB yB impulse vx vy");
            }
            impacts.add(impact(words, line));
        }
        return impacts;
    }

    private Impact impact(String[] words, int line) {
        Impact impact = new Impact(lines.number(words[1], line), pod(words[2], line), lines.whole(words[3], line),
            lines.whole(words[4], line), pod(words[5], line), lines.whole(words[6], line), lines.whole(words[7], line),
            lines.number(words[8], line), lines.whole(words[9], line), lines.whole(words[10], line));
        if (impact.time() < 0 || impact.time() > 1) {
            throw lines.wrongWord(words[1], line, "a time 0..1 within the turn");
        }
        if (impact.a() == impact.b()) {
            throw lines.wrong(line, "an impact of two different pods");
        }
        return impact;
    }

    private int pod(String word, int line) {
        return lines.whole(word, GameRecording.PODS - 1, line);
    }
}

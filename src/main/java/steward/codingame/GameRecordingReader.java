package steward.codingame;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Reads CodinGame's own JSON of a pod-race game: {@code {"success":{"gameResult":{"frames":[...],...}}}} or any of the
 * inner objects. All that is known of that format stands in this file.
 *
 * <p>Frame 0 is the start; from then on, each frame is one player's answer, player 0 and 1 in turn, and the key frame
 * ends the turn. A view is text of several lines:
 * <pre>
 * frame 0, line 3      checkpoints: x y x y ...
 * frame 0, line 5 on   the pods; in a later key frame: line 1 on
 * a pod                x y vx vy power dead targetX targetY headingRadians|null shield nextCheckpoint rank
 *                      "message"
 * then per player      rank:turnsLeft
 * then per impact      id time podA xA yA podB xB yB impulse vx vy
 * </pre>
 * Missing parts are left out where the rest makes sense without them. Errors name the frame and the line.
 */
final class GameRecordingReader {

    private static final int CHECKPOINT_LINE = 3;
    private static final int FIRST_POD_LINE_OF_START = 5;
    private static final int FIRST_POD_LINE = 1;
    private static final int POD_WORDS = 11;
    private static final int IMPACT_WORDS = 9;

    /** A number as JSON and Java write it: no hexadecimal, no suffix, no name. */
    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");

    private final String source;
    private int checkpointCount;

    private GameRecordingReader(String source) {
        this.source = source;
    }

    /**
     * Reads a recording.
     *
     * @param json   the text of the file
     * @param source its name, for errors
     * @throws IllegalArgumentException if it is not a recording of a pod race
     */
    static GameRecording read(String json, String source) {
        return new GameRecordingReader(source).read(json);
    }

    private GameRecording read(String json) {
        JsonNode root;
        try {
            root = JsonMapper.shared().readTree(json);
        } catch (JacksonException problem) {
            String place = problem.getLocation() == null ? ""
                : ":" + problem.getLocation().getLineNr() + ":" + problem.getLocation().getColumnNr();
            throw new IllegalArgumentException(source + place + ": not JSON: " + problem.getOriginalMessage());
        }
        JsonNode result = root.has("success") ? root.get("success") : root;
        result = result.has("gameResult") ? result.get("gameResult") : result;
        JsonNode frames = result.get("frames");
        if (frames == null || !frames.isArray() || frames.isEmpty()) {
            throw new IllegalArgumentException(source + ": found no frames, expected CodinGame's game result with an"
                + " array \"frames\"");
        }
        String[] view = view(frames.get(0), 0);
        double[][] checkpoints = checkpoints(view);
        checkpointCount = checkpoints.length;
        List<GameRecording.Pod> start = pods(view, FIRST_POD_LINE_OF_START, 0);
        List<Integer> ranks = ranks(result.get("ranks"));
        return new GameRecording(checkpoints, start, turns(frames, !ranks.isEmpty()), ranks);
    }

    /** The lines of a frame's view; none if it has no view. */
    private String[] view(JsonNode frame, int number) {
        JsonNode view = frame.get("view");
        if (view == null || view.isNull()) {
            return new String[0];
        }
        if (!view.isString()) {
            throw wrong(number, "view", view.toString(), "a text");
        }
        return view.stringValue().stripTrailing().split("\n", -1);
    }

    private double[][] checkpoints(String[] view) {
        if (view.length <= CHECKPOINT_LINE) {
            throw wrong(0, "view", view.length + " lines", "the checkpoints in line " + CHECKPOINT_LINE);
        }
        String[] words = words(view[CHECKPOINT_LINE]);
        if (words.length < 4 || words.length % 2 != 0) {
            throw wrong(0, "view line " + CHECKPOINT_LINE, quote(view[CHECKPOINT_LINE]),
                "x y of two or more checkpoints");
        }
        double[][] checkpoints = new double[words.length / 2][];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpoints[k] = new double[] {number(words[2 * k], 0, CHECKPOINT_LINE),
                number(words[2 * k + 1], 0, CHECKPOINT_LINE)};
        }
        return checkpoints;
    }

    /** The four pods from a line of a view on, -0 as 0; none if the view ends before them. */
    private List<GameRecording.Pod> pods(String[] view, int firstLine, int frame) {
        if (view.length <= firstLine) {
            return List.of();
        }
        List<GameRecording.Pod> pods = new ArrayList<>();
        for (int pod = 0; pod < GameRecording.PODS; pod++) {
            int line = firstLine + 2 * pod;
            String[] words = line < view.length ? words(view[line]) : new String[0];
            if (words.length < POD_WORDS) {
                throw wrong(frame, "view line " + line, line < view.length ? quote(view[line]) : "the end of the view",
                    "pod " + pod + ": x y vx vy power dead targetX targetY heading shield nextCheckpoint");
            }
            double heading = words[8].equals("null") ? Double.NaN : number(words[8], frame, line);
            pods.add(new GameRecording.Pod(number(words[0], frame, line) + 0.0, number(words[1], frame, line) + 0.0,
                number(words[2], frame, line) + 0.0, number(words[3], frame, line) + 0.0, heading,
                whole(words[9], 1, frame, line) == 1, whole(words[10], checkpointCount - 1, frame, line)));
        }
        return pods;
    }

    private List<GameRecording.Turn> turns(JsonNode frames, boolean over) {
        List<GameRecording.Turn> turns = new ArrayList<>();
        List<List<String>> commands = new ArrayList<>();
        for (int k = 1; k < frames.size(); k++) {
            JsonNode frame = frames.get(k);
            if (!frame.isObject()) {
                throw new IllegalArgumentException(source + ": frame " + k + ": found " + frame
                    + ", expected an object");
            }
            if (frame.path("agentId").asInt(0) < 0) {
                continue;                             // the referee speaks
            }
            commands.add(said(frame, k));
            if (endsTurn(frame, k, commands.size())) {
                boolean last = k == frames.size() - 1;
                if (!last && commands.size() < GameRecording.PLAYERS && !fails(commands.get(0))) {
                    throw wrong(k, "keyframe", "true", "false, because player 1 has not answered");
                }
                turns.add(turn(frame, k, complete(commands, last)));
                commands.clear();
            }
        }
        if (!commands.isEmpty() && (over || fails(commands.get(0)))) {
            turns.add(turn(JsonMapper.shared().createObjectNode(), frames.size() - 1, complete(commands, true)));
        }
        return withoutImpactsIfThereAreNone(turns);
    }

    private List<String> said(JsonNode frame, int number) {
        JsonNode stdout = frame.get("stdout");
        if (stdout == null || stdout.isNull()) {
            return List.of();
        }
        if (!stdout.isString()) {
            throw wrong(number, "stdout", stdout.toString(), "a text");
        }
        return stdout.stringValue().strip().lines().toList();
    }

    private boolean endsTurn(JsonNode frame, int number, int players) {
        JsonNode key = frame.get("keyframe");
        if (key != null && !key.isBoolean()) {
            throw wrong(number, "keyframe", key.toString(), "true or false");
        }
        boolean ends = key == null ? players == GameRecording.PLAYERS : key.booleanValue();
        if (!ends && players == GameRecording.PLAYERS) {
            throw wrong(number, "keyframe", "false", "true, because both players have answered");
        }
        return ends;
    }

    /** Whoever is missing was not asked any more because the one before had failed, or is the one that failed. */
    private static List<List<String>> complete(List<List<String>> commands, boolean last) {
        List<List<String>> all = new ArrayList<>(commands);
        while (all.size() < GameRecording.PLAYERS) {
            all.add(last && !fails(all.get(0)) ? List.of() : null);
        }
        return all;
    }

    private static boolean fails(List<String> lines) {
        return lines.size() < GameRecording.PODS_PER_PLAYER;
    }

    /** A recording without a single impact may come from a source that tells of none. */
    private static List<GameRecording.Turn> withoutImpactsIfThereAreNone(List<GameRecording.Turn> turns) {
        boolean any = turns.stream().anyMatch(turn -> turn.impacts() != null && !turn.impacts().isEmpty());
        return any ? turns : turns.stream()
            .map(turn -> new GameRecording.Turn(turn.frame(), turn.commands(), turn.after(), null)).toList();
    }

    private GameRecording.Turn turn(JsonNode frame, int number, List<List<String>> commands) {
        String[] view = view(frame, number);
        List<GameRecording.Pod> after = pods(view, FIRST_POD_LINE, number);
        return new GameRecording.Turn(number, commands, after, after.isEmpty() ? null : impacts(view, number));
    }

    /** The impacts behind the players' lines, or {@code null} if the view ends with the pods. */
    private List<GameRecording.Impact> impacts(String[] view, int frame) {
        int line = FIRST_POD_LINE + 2 * GameRecording.PODS;
        int players = 0;
        while (line < view.length && words(view[line]).length == 1 && view[line].contains(":")) {
            line++;
            players++;
        }
        if (players == 0 && line >= view.length) {
            return null;
        }
        List<GameRecording.Impact> impacts = new ArrayList<>();
        for (; line < view.length; line++) {
            String[] words = words(view[line]);
            if (words.length == 0) {
                continue;
            }
            if (words.length < IMPACT_WORDS) {
                throw wrong(frame, "view line " + line, quote(view[line]),
                    "an impact: id time podA xA yA podB xB yB impulse");
            }
            impacts.add(new GameRecording.Impact(number(words[1], frame, line),
                whole(words[2], GameRecording.PODS - 1, frame, line),
                whole(words[5], GameRecording.PODS - 1, frame, line), number(words[8], frame, line)));
        }
        return impacts;
    }

    private List<Integer> ranks(JsonNode node) {
        List<Integer> ranks = new ArrayList<>();
        if (node == null || node.isNull()) {
            return ranks;
        }
        for (JsonNode rank : node) {
            if (rank.isInt() && rank.intValue() >= 0 && rank.intValue() < GameRecording.PLAYERS) {
                ranks.add(rank.intValue());
            }
        }
        if (!node.isArray() || ranks.size() != node.size() || ranks.size() != GameRecording.PLAYERS) {
            throw new IllegalArgumentException(source + ": ranks: found " + quote(node.toString())
                + ", expected an array of " + GameRecording.PLAYERS + " whole numbers 0.."
                + (GameRecording.PLAYERS - 1));
        }
        return ranks;
    }

    /** A whole number from 0. */
    private int whole(String word, int most, int frame, int line) {
        double value = number(word, frame, line);
        if (value != Math.rint(value) || value < 0 || value > most) {
            throw wrong(frame, "view line " + line, quote(word), "a whole number 0.." + most);
        }
        return (int) value;
    }

    private double number(String word, int frame, int line) {
        double value = NUMBER.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
        if (Double.isFinite(value)) {
            return value;
        }
        throw wrong(frame, "view line " + line, quote(word), "a finite number");
    }

    private static String[] words(String line) {
        return line.isBlank() ? new String[0] : line.strip().split("\\s+");
    }

    private static String quote(String text) {
        return "\"" + TextFormat.beginning(text, 60) + "\"";
    }

    private IllegalArgumentException wrong(int frame, String where, String found, String expected) {
        return new IllegalArgumentException(source + ": frame " + frame + ", " + where + ": found " + found
            + ", expected " + expected);
    }
}

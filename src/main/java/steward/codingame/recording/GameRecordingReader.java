package steward.codingame.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.text.ViewLines;
import tools.jackson.databind.JsonNode;

/**
 * Reads CodinGame's own JSON of a pod-race game. Frame 0 is the start; from then on, each frame is one player's answer,
 * player 0 and 1 in turn, and the key frame ends the turn. The game as a frame shows it stands in its {@link
 * FrameView}. Missing parts are left out where the rest makes sense without them. Errors name the frame.
 */
final class GameRecordingReader {

    private static final Pattern MAP = Pattern.compile("(?m)^map=(.*)$");

    private final String source;
    private ServerFrames server;
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
        JsonNode result = GameRecordingFile.gameResult(json, source);
        server = new ServerFrames(result, source);
        requireStart();
        FrameView first = new FrameView(server.view(0));
        double[][] checkpoints = first.checkpoints();
        checkpointCount = checkpoints.length;
        requireMap(server.input(), checkpoints);
        GameRecording.State start = first.start(checkpointCount);
        List<Integer> ranks = ranks(result.get("ranks"));
        return new GameRecording(checkpoints, start, server.firstShown(),
            turns(result.get("frames").size(), !ranks.isEmpty()), ranks, server.facts(GameRecording.PLAYERS));
    }

    /** Frame 0 must have a view: without the checkpoints nothing makes sense. */
    private void requireStart() {
        JsonNode frame = server.frame(0);
        JsonNode view = frame.get("view");
        if (view == null || view.isNull()) {
            throw server.wrong(0, "view", view == null ? "nothing" : "null", "a text");
        }
        JsonNode agent = frame.get("agentId");
        if (agent != null && !(agent.isInt() && agent.intValue() == -1)) {
            throw server.wrong(0, "agentId", agent.toString(), "-1: the first frame is the referee's");
        }
        JsonNode key = frame.get("keyframe");
        if (key != null && !(key.isBoolean() && key.booleanValue())) {
            throw server.wrong(0, "keyframe", key.toString(), "true: the first frame shows the start");
        }
    }

    /** Checks the map against the input of the server's referee, which names the map too. */
    private void requireMap(String input, double[]... checkpoints) {
        Matcher map = MAP.matcher(input);
        if (!map.find()) {
            return;
        }
        String[] words = map.group(1).strip().split("\\s+");
        boolean same = words.length == 2 * checkpoints.length;
        for (int k = 0; same && k < words.length; k++) {
            same = words[k].matches("-?[0-9]{1,9}") && Integer.parseInt(words[k]) == checkpoints[k / 2][k % 2];
        }
        if (!same) {
            throw new IllegalArgumentException(source + ": refereeInput: found "
                + ViewLines.quote(map.group().strip()) + ", expected the checkpoints of frame 0");
        }
    }

    private List<GameRecording.Turn> turns(int frames, boolean over) {
        List<GameRecording.Turn> turns = new ArrayList<>();
        List<List<String>> commands = new ArrayList<>();
        List<ShownFrame> shown = new ArrayList<>();
        for (int k = 1; k < frames; k++) {
            JsonNode frame = server.frame(k);
            ViewLines view = server.view(k);          // the number of every frame is checked, not only of key frames
            if (isReferee(frame, k, commands.size())) {
                continue;
            }
            commands.add(server.said(k));
            shown.add(ShownFrame.of(frame));
            if (endsTurn(frame, k, commands.size())) {
                boolean last = k == frames - 1;
                if (!last && commands.size() < GameRecording.PLAYERS && !fails(commands.get(0))) {
                    throw server.wrong(k, "keyframe", "true", "false, because player 1 has not answered");
                }
                turns.add(turn(view, k, complete(commands, last), shown));
                commands.clear();
                shown.clear();
            }
        }
        if (!commands.isEmpty() && (over || fails(commands.get(0)))) {
            turns.add(turn(new ViewLines(source, frames - 1, null), frames - 1, complete(commands, true), List.of()));
        }
        return turns;
    }

    /** True if the frame is the referee's alone; otherwise it must be that of the player whose turn it is. */
    private boolean isReferee(JsonNode frame, int number, int player) {
        JsonNode agent = frame.get("agentId");
        if (agent == null || agent.isNull()) {
            return false;
        }
        boolean referee = agent.isInt() && agent.intValue() == -1 && server.said(number).isEmpty();
        if (!referee && !(agent.isInt() && agent.intValue() == player)) {
            throw server.wrong(number, "agentId", agent.toString(), player + ", because " + (player == 0
                ? "a turn begins with player 0" : "player 0 has answered"));
        }
        return referee;
    }

    private boolean endsTurn(JsonNode frame, int number, int players) {
        JsonNode key = frame.get("keyframe");
        if (key != null && !key.isBoolean()) {
            throw server.wrong(number, "keyframe", key.toString(), "true or false");
        }
        boolean ends = key == null ? players == GameRecording.PLAYERS : key.booleanValue();
        if (!ends && players == GameRecording.PLAYERS) {
            throw server.wrong(number, "keyframe", "false", "true, because both players have answered");
        }
        return ends;
    }

    /** A player without a frame was not asked any more because the one before it had failed, or has failed itself. */
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

    private GameRecording.Turn turn(ViewLines lines, int number, List<List<String>> commands,
                                    List<ShownFrame> shown) {
        FrameView view = new FrameView(lines);
        return new GameRecording.Turn(number, commands, view.state(checkpointCount), view.impacts(),
            List.copyOf(shown));
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
            throw new IllegalArgumentException(source + ": ranks: found " + ViewLines.quote(node.toString())
                + ", expected an array of " + GameRecording.PLAYERS + " whole numbers 0.."
                + (GameRecording.PLAYERS - 1));
        }
        return ranks;
    }
}

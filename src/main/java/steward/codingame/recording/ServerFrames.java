package steward.codingame.recording;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import steward.replay.ServerRecording;
import steward.text.TextFormat;
import steward.text.ViewLines;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Reader of the frames in CodinGame's JSON, which all games share. Frame 0 is the start; from then on, each frame is
 * one player's answer, in the order of their numbers, and the key frame ends the turn. A player without a frame was not
 * asked. A frame of the referee that ends no turn is skipped. If a source does not tell whose frame it is, or whether
 * it ends the turn, all players answer in each turn. Errors name the frame.
 */
final class ServerFrames {

    /** The most players of any game of the site. */
    private static final int MOST_PLAYERS = 8;
    private static final int SHOWN = 60;

    private final String source;
    private final JsonNode result;
    private final JsonNode frames;
    /** Tooltips of each frame, a line for each; {@code null} if they are not recorded. */
    private final Map<Integer, String> tooltips;

    /**
     * One turn.
     *
     * @param said   per player its lines, possibly none; {@code null} for a player that was not asked
     * @param frames the texts of all its frames
     */
    record Turn(List<List<String>> said, List<ServerRecording.Frame> frames) {

        boolean isSilent() {
            return said.stream().allMatch(lines -> lines == null || lines.isEmpty());
        }
    }

    /** @param result the object with the array {@code frames}, which is not empty */
    ServerFrames(JsonNode result, String source) {
        this.source = source;
        this.result = result;
        frames = result.get("frames");
        tooltips = result.path("tooltips").isArray() ? tooltips(result.get("tooltips")) : null;
    }

    /** Reads tooltips, each an object or the text of one, in which the turn is the number of a frame. */
    private static Map<Integer, String> tooltips(JsonNode all) {
        Map<Integer, String> tooltips = new HashMap<>();
        for (JsonNode each : all) {
            JsonNode tooltip = each;
            try {
                tooltip = each.isString() ? JsonMapper.shared().readTree(each.stringValue()) : each;
            } catch (JacksonException textual) {
                // No tooltip then: the text has no turn.
            }
            if (tooltip.path("turn").isInt()) {
                tooltips.merge(tooltip.get("turn").intValue(), tooltip.path("event").asString("") + " "
                    + tooltip.path("text").asString(""), (before, more) -> before + "\n" + more);
            }
        }
        return tooltips;
    }

    int size() {
        return frames.size();
    }

    /** The view of frame 0. */
    ViewLines first() {
        JsonNode view = frame(0).get("view");
        if (view == null || view.isNull()) {
            throw wrong(0, "view", view == null ? "nothing" : "null", "a text");
        }
        return view(0);
    }

    /** Checks that frame 0 is the referee's, and shows the start. */
    void requireStart() {
        if (agent(0, -1) != -1) {
            throw wrong(0, "agentId", Integer.toString(agent(0, -1)), "-1: the first frame is the referee's");
        }
        if (!endsTurn(0, true)) {
            throw wrong(0, "keyframe", "false", "true: the first frame shows the start");
        }
    }

    /**
     * The texts of a frame; anything but a text counts as none.
     *
     * @param aside true if it is the referee's and ends no turn
     */
    ServerRecording.Frame shown(int frame, boolean aside) {
        return new ServerRecording.Frame(frame(frame).path("view").asString(null),
            frame(frame).path("summary").asString(null), frame(frame).path("gameInformation").asString(null),
            tooltips == null ? null : tooltips.getOrDefault(frame, ""), aside);
    }

    RecordingFacts facts(int players) {
        return RecordingFacts.of(result, players);
    }

    /** Returns the input of the server's referee, or "". */
    String input() {
        JsonNode input = result.get("refereeInput");
        return input != null && input.isString() ? input.stringValue() : "";
    }

    /** As many as have answered in any frame that says whose it is. */
    int players() {
        return IntStream.range(0, frames.size()).map(frame -> agent(frame, -1)).max().orElse(-1) + 1;
    }

    /**
     * All turns. Answers behind the last key frame are a turn if the game ended in it, by a fault or as the server
     * says.
     *
     * @param over true if the server has ended the game
     */
    List<Turn> turns(int players, boolean over) {
        List<Turn> turns = new ArrayList<>();
        List<String>[] said = none(players);
        List<ServerRecording.Frame> shown = new ArrayList<>();
        int next = 0;
        for (int k = 1; k < frames.size(); k++) {
            int agent = agent(k, next);
            view(k);                              // its number is checked
            if (agent < 0 && !said(k).isEmpty()) {
                throw wrong(k, "agentId", "-1", "the number of the player whose answer the frame has");
            }
            if (agent >= 0) {
                if (agent < next) {
                    throw wrong(k, "agentId", Integer.toString(agent),
                        "a player behind " + (next - 1) + ", or a key frame before, which ends the turn");
                }
                said[agent] = said(k);
                next = agent + 1;
            }
            boolean ends = endsTurn(k, next == players);
            if (!ends && agent == players - 1) {
                throw wrong(k, "keyframe", "false", "true, because all players have answered");
            }
            boolean aside = !ends && agent < 0;
            (aside && next == 0 && !turns.isEmpty() ? turns.get(turns.size() - 1).frames() : shown)
                .add(shown(k, aside));
            if (ends) {
                turns.add(new Turn(Arrays.asList(said), shown));
                shown = new ArrayList<>();
                said = none(players);
                next = 0;
            }
        }
        if (next > 0 && (over || said[next - 1].isEmpty())) {
            shown.add(ServerRecording.Frame.LACKING);
            turns.add(new Turn(Arrays.asList(said), shown));
        }
        return turns;
    }

    @SuppressWarnings("unchecked")
    private static List<String>[] none(int players) {
        return (List<String>[]) new List<?>[players];
    }

    /** The final scores; empty if not recorded. */
    double[] scores(int players) {
        return numbers("scores", players, "numbers");
    }

    /**
     * The rank per player, 0 for the best; empty if not recorded. The server lists the players from the best to the
     * worst, and does not say who has tied: equal scores have. Two zeros are the ranks of two who have tied.
     */
    int[] ranks(int players) {
        double[] order = numbers("ranks", players, "the numbers of the players, from the best to the worst");
        double[] scores = scores(players);
        int[] ranks = new int[order.length];
        if (order.length == 2 && order[0] == 0 && order[1] == 0) {
            return ranks;
        }
        Arrays.fill(ranks, -1);
        for (int place = 0; place < order.length; place++) {
            int player = (int) order[place];
            if (player != order[place] || player < 0 || player >= players || ranks[player] >= 0) {
                throw new IllegalArgumentException(source + ": ranks[" + place + "]: found " + result.get("ranks")
                    .get(place) + ", expected the number of a player 0.." + (players - 1) + ", each once");
            }
            int before = place == 0 ? -1 : (int) order[place - 1];
            boolean ties = before >= 0 && scores.length > 0 && scores[before] == scores[player];
            ranks[player] = ties ? ranks[before] : place;
        }
        return ranks;
    }

    private double[] numbers(String name, int players, String expected) {
        JsonNode node = result.get(name);
        if (node == null || node.isNull()) {
            return new double[0];
        }
        double[] numbers = new double[node.isArray() ? node.size() : 0];
        boolean all = numbers.length == players;
        for (int k = 0; all && k < numbers.length; k++) {
            all = node.get(k).isNumber();
            numbers[k] = all ? node.get(k).asDouble() : 0;
        }
        if (!all) {
            throw new IllegalArgumentException(source + ": " + name + ": found " + ViewLines.quote(node.toString())
                + ", expected an array of " + players + ": " + expected);
        }
        return numbers;
    }

    /** The player of a frame, or -1 for the referee. @param silent where the frame does not say it */
    int agent(int frame, int silent) {
        JsonNode agent = frame(frame).get("agentId");
        if (agent == null || agent.isNull()) {
            return silent;
        }
        if (!agent.isInt() || agent.intValue() < -1 || agent.intValue() >= MOST_PLAYERS) {
            throw wrong(frame, "agentId", agent.toString(), "the number of a player 0.." + (MOST_PLAYERS - 1)
                + ", or -1");
        }
        return agent.intValue();
    }

    /** @param silent where the frame does not say it */
    boolean endsTurn(int frame, boolean silent) {
        JsonNode key = frame(frame).get("keyframe");
        if (key != null && !key.isBoolean()) {
            throw wrong(frame, "keyframe", key.toString(), "true or false");
        }
        return key == null ? silent : key.booleanValue();
    }

    List<String> said(int frame) {
        String stdout = text(frame, "stdout");
        return stdout == null ? List.of() : stdout.strip().lines().toList();
    }

    /** The view of a frame, with its number checked; without lines if it has none. */
    ViewLines view(int frame) {
        ViewLines view = new ViewLines(source, frame, text(frame, "view"));
        view.checkNumber();
        return view;
    }

    String text(int frame, String name) {
        JsonNode text = frame(frame).get(name);
        if (text == null || text.isNull()) {
            return null;
        }
        if (!text.isString()) {
            throw wrong(frame, name, text.toString(), "a text");
        }
        return text.stringValue();
    }

    JsonNode frame(int frame) {
        JsonNode node = frames.get(frame);
        if (!node.isObject()) {
            throw new IllegalArgumentException(source + ": frame " + frame + ": found "
                + TextFormat.beginning(node.toString(), SHOWN) + ", expected an object");
        }
        return node;
    }

    IllegalArgumentException wrong(int frame, String where, String found, String expected) {
        return new IllegalArgumentException(source + ": frame " + frame + ", " + where + ": found "
            + TextFormat.beginning(found, SHOWN) + ", expected " + expected);
    }
}

package steward.codingame.recording;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.game.GameSetup;
import steward.game.TextCodec;
import steward.game.ViewWriter;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.Sinking;
import steward.match.TestScenes;
import steward.physics.Bodies;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes a game of Mean Max played here in the form of CodinGame's own JSON. Only games of the server can tell the
 * worth of its views.
 */
public final class ServerMeanMax {

    private static final int SKILL_EVERY = 7;

    private final ObjectNode result = JsonMapper.shared().createObjectNode();
    private final ArrayNode frames = result.putArray("frames");
    private final ViewWriter views = TestScenes.TYPES.viewWriter("mean-max").orElseThrow();
    private final MeanMax game;
    private final TextCodec codec;
    private int impacts;
    private int sunk;

    private ServerMeanMax(long seed) {
        GameSetup setup = TestScenes.TYPES.open(views.observed(SceneReader.read(SceneFiles.load("mean-max"), null)));
        game = (MeanMax) setup.create(seed);
        codec = setup.textCodec(game).orElseThrow();
        views.begin(game);
        result.put("refereeInput", "seed=" + seed + "\n");
        frames.addObject().put("view", text(views.start(), 0)).put("keyframe", true).put("agentId", -1);
    }

    /** So many turns, or fewer if the game is over before: reapers to the centre, the others to tankers, and tar. */
    public static ServerMeanMax play(long seed, int turns) {
        ServerMeanMax of = new ServerMeanMax(seed);
        for (int turn = 0; turn < turns && !of.game.isOver(); turn++) {
            of.turn();
        }
        if (of.game.isOver()) {
            of.finish();
        }
        return of;
    }

    private void finish() {
        ArrayNode scores = result.putArray("scores");
        List<Integer> order = new ArrayList<>();
        for (int player = 0; player < game.players(); player++) {
            scores.add((double) game.score(player));
            order.add(player);
        }
        order.sort((one, other) -> game.score(other) - game.score(one));
        order.forEach(result.putArray("ranks")::add);
    }

    /** A copy that tests may change. */
    ObjectNode gameResult() {
        return result.deepCopy();
    }

    /** As it is downloaded. */
    public String json() {
        ObjectNode whole = JsonMapper.shared().createObjectNode();
        whole.set("success", result);
        return whole.toString();
    }

    int impacts() {
        return impacts;
    }

    int sunk() {
        return sunk;
    }

    int turns() {
        return game.turn();
    }

    private String answer(int player) {
        Bodies bodies = game.bodies();
        int tanker = Math.min(bodies.size() - 1, game.world().looter(2, 2) + 1 + player);
        String there = (long) bodies.x[tanker] + " " + (long) bodies.y[tanker] + " 300";
        boolean skill = game.turn() % SKILL_EVERY == player && game.rage(player) >= 30;
        int reaper = game.world().looter(player, 0);
        return (skill ? "SKILL " + (long) bodies.x[reaper] + " " + (long) bodies.y[reaper] : "0 0 300") + "\n" + there
            + "\n" + there + " hello";
    }

    private void turn() {
        String[] messages = new String[game.players()];
        for (int player = 0; player < game.players(); player++) {
            String answer = answer(player);
            byte[] bytes = answer.getBytes(StandardCharsets.UTF_8);
            String wrong = codec.readAnswer(player, bytes, bytes.length);
            if (wrong != null) {
                throw new AssertionError(wrong);
            }
            messages[player] = codec.message(player);
            frames.addObject().put("stdout", answer + "\n").put("keyframe", player == game.players() - 1)
                .put("agentId", player).put("view", " " + (frames.size() - 1) + "\n");
        }
        views.before();
        game.play();
        impacts += game.log().impacts();
        for (int k = 0; k < game.log().facts(); k++) {
            sunk += game.log().factKind(k) == Sinking.SUNK ? 1 : 0;
        }
        ((ObjectNode) frames.get(frames.size() - 1)).put("view", text(views.after(messages, List.of()),
            frames.size() - 1));
    }

    private static String text(ViewWriter.Frame frame, int number) {
        return String.join("\n", frame.view()).replaceFirst("\\*", " " + number) + "\n";
    }
}

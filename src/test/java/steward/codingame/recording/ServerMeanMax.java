package steward.codingame.recording;

import java.util.ArrayList;
import java.util.List;
import steward.game.Game;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.Sinking;
import steward.physics.Bodies;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** A {@link ServerGame} of Mean Max: reapers go to the centre, the others to tankers, and some throw tar. */
public final class ServerMeanMax {

    private static final int SKILL_EVERY = 7;

    private final ObjectNode result;
    private MeanMax game;
    private int impacts;
    private int sunk;

    private ServerMeanMax(long seed, int turns) {
        result = ServerGame.play("mean-max", seed, turns, this::answer, lines -> String.join("\n", lines) + "\n")
            .put("refereeInput", "seed=" + seed + "\n");
        count();
        if (game.isOver()) {
            ArrayNode scores = result.putArray("scores");
            List<Integer> order = new ArrayList<>();
            for (int player = 0; player < game.players(); player++) {
                scores.add((double) game.score(player));
                order.add(player);
            }
            order.sort((one, other) -> game.score(other) - game.score(one));
            order.forEach(result.putArray("ranks")::add);
        }
    }

    /** So many turns, or fewer if the game is over before. */
    public static ServerMeanMax play(long seed, int turns) {
        return new ServerMeanMax(seed, turns);
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

    private String answer(Game played, int player) {
        game = (MeanMax) played;
        if (player == 0) {
            count();
        }
        Bodies bodies = game.bodies();
        int tanker = Math.min(bodies.size() - 1, game.world().looter(2, 2) + 1 + player);
        String there = (long) bodies.x[tanker] + " " + (long) bodies.y[tanker] + " 300";
        boolean skill = game.turn() % SKILL_EVERY == player && game.rage(player) >= 30;
        int reaper = game.world().looter(player, 0);
        return (skill ? "SKILL " + (long) bodies.x[reaper] + " " + (long) bodies.y[reaper] : "0 0 300") + "\n" + there
            + "\n" + there + " hello";
    }

    /** Counts what the last turn had. */
    private void count() {
        impacts += game.log().impacts();
        for (int k = 0; k < game.log().facts(); k++) {
            sunk += game.log().factKind(k) == Sinking.SUNK ? 1 : 0;
        }
    }
}

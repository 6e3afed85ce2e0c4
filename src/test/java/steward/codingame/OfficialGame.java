package steward.codingame;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import steward.bot.InProcessPlayer;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.JsonNumbers;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.physics.Impact;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes a match played here in the form of CodinGame's own JSON, as its server does: a frame per player, the pods in
 * the view of the key frame, the impacts behind them. The pod that wins keeps its old next checkpoint.
 */
public final class OfficialGame implements MatchListener {

    private static final int PODS = 4;
    private final ObjectNode result = JsonMapper.shared().createObjectNode();
    private final ArrayNode frames = result.putArray("frames");
    private final List<Integer> impactTurns = new ArrayList<>();
    private PodRace race;
    private FrameCodec codec;
    private final List<String> said = new ArrayList<>();
    private final boolean[] shield = new boolean[PODS];
    private int turns;

    private OfficialGame() {
    }

    /** A whole game between bots drawn by lot that ram each other now and then. */
    public static OfficialGame play(long seed) {
        GameSetup setup = TestScenes.open("mad-pod-racing");
        OfficialGame game = new OfficialGame();
        List<InProcessPlayer> players = List.of(new InProcessPlayer("a", new SeededBot(seed, 0.2)),
            new InProcessPlayer("b", new SeededBot(seed + 1, 0.2)));
        try {
            MatchResult end = new Referee(setup, seed, players, TimeControl.UNLIMITED, game).play();
            ArrayNode ranks = game.result.putArray("ranks");
            end.players().forEach(player -> ranks.add(player.rank()));
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
        return game;
    }

    /** The inner object; a copy that tests may change. */
    ObjectNode gameResult() {
        return result.deepCopy();
    }

    /** As it is downloaded. */
    public String json() {
        ObjectNode whole = JsonMapper.shared().createObjectNode();
        whole.putObject("success").set("gameResult", result);
        return whole.toString();
    }

    /**
     * As older sources tell it: without impacts, and of every fifth turn nothing but the commands; then the second
     * player stops answering.
     *
     * @param turns how many are kept
     */
    public String sketch(int turns) {
        ObjectNode sketch = gameResult();
        ArrayNode all = (ArrayNode) sketch.get("frames");
        while (all.size() > 1 + keyFrame(turns)) {
            all.remove(all.size() - 1);
        }
        for (int turn = 1; turn <= turns; turn++) {
            ObjectNode frame = (ObjectNode) all.get(keyFrame(turn));
            frame.put("view", String.join("\n", frame.get("view").stringValue().lines().limit(1 + 2 * PODS).toList()));
            if (turn % 5 == 0) {
                frame.remove("view");
            }
        }
        ((ObjectNode) all.get(keyFrame(turns))).remove("stdout");
        sketch.putArray("ranks").add(0).add(1);
        return sketch.toString();
    }

    public int turns() {
        return turns;
    }

    /** Turns with impacts, ascending. */
    List<Integer> impactTurns() {
        return impactTurns;
    }

    /** The number of the key frame of a turn. */
    static int keyFrame(int turn) {
        return 2 * turn;
    }

    @Override
    public void start(Game game, FrameCodec gameCodec) {
        race = (PodRace) game;
        codec = gameCodec;
        StringBuilder view = new StringBuilder(" 0\nCodersStrikeBack\n16000 9000 400 600 4 0.3141592653589793\n");
        for (double[] checkpoint : race.checkpoints()) {
            view.append(view.charAt(view.length() - 1) == '\n' ? "" : " ").append(word(checkpoint[0])).append(' ')
                .append(word(checkpoint[1]));
        }
        for (int k = 0; k < PODS; k++) {
            view.append(k == 0 ? "\n" : " ").append(k / 2).append(' ').append(race.pod(k).x()).append(' ')
                .append(race.pod(k).y());
        }
        view.append('\n');
        pods(view);
        frames.addObject().put("view", view.toString()).put("keyframe", true).put("agentId", -1);
    }

    @Override
    public void commands(Turn turn) {
        said.clear();
        for (int player = 0; player < 2; player++) {
            StringWriter json = new StringWriter();
            try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), json)) {
                codec.state().writeCommand(out, player);
            }
            StringBuilder lines = new StringBuilder();
            for (JsonNode pod : JsonMapper.shared().readTree(json.toString())) {
                shield[2 * player + lines.toString().lines().mapToInt(line -> 1).sum()] = pod.has("shield");
                lines.append(pod.get("x")).append(' ').append(pod.get("y")).append(' ').append(
                    pod.has("shield") ? "SHIELD" : pod.has("boost") ? "BOOST" : pod.get("thrust")).append(" go\n");
            }
            said.add(lines.toString());
        }
    }

    @Override
    public void played(Turn turn) {
        turns = turn.number();
        frames.addObject().put("stdout", said.get(0)).put("keyframe", false).put("agentId", 0)
            .put("view", " " + (2 * turns - 1) + "\n");
        StringBuilder view = new StringBuilder(" " + 2 * turns + (race.isOver() ? " endReached\n" : "\n"));
        pods(view);
        if (race.log().impacts() > 0) {
            impactTurns.add(turns);
        }
        for (int k = 0; k < race.log().impacts(); k++) {
            Impact impact = race.log().impact(k);
            view.append(k).append(' ').append(impact.time()).append(' ').append(impact.a()).append(' ')
                .append(Math.round(impact.ax())).append(' ').append(Math.round(impact.ay())).append(' ')
                .append(impact.b()).append(' ').append(Math.round(impact.bx())).append(' ')
                .append(Math.round(impact.by())).append(' ').append(impact.impulse()).append(' ')
                .append(Math.round((impact.vaxBefore() + impact.vbxBefore()) / 2)).append(' ')
                .append(Math.round((impact.vayBefore() + impact.vbyBefore()) / 2)).append('\n');
        }
        frames.addObject().put("stdout", said.get(1)).put("keyframe", true).put("agentId", 1)
            .put("view", view.toString());
    }

    /** Two lines a pod, then one for both players: of the first and the last turn as the server, as far as is known. */
    private void pods(StringBuilder view) {
        int count = race.checkpoints().length;
        int all = race.settings().laps() * count;
        for (int k = 0; k < PODS; k++) {
            PodState pod = race.pod(k);
            int next = (pod.passed() < all ? pod.passed() + 1 : all) % count;
            view.append(word(pod.x())).append(' ').append(word(pod.y())).append(' ').append(word(pod.vx())).append(' ')
                .append(word(pod.vy())).append(" 100 0 0 0 ")
                .append(Double.isNaN(pod.heading()) ? "null" : Double.toString(pod.heading())).append(' ')
                .append(shield[k] ? 1 : 0).append(' ').append(next).append(' ').append(0).append('\n')
                .append("\"go: ").append(k).append("\"\n");
        }
        int[] ranks = race.turn() == 0 ? new int[2] : race.ranks();
        view.append(ranks[0] + 1).append(':').append(race.isOver() ? -1 : race.turnsLeft(0)).append(' ')
            .append(ranks[1] + 1).append(':').append(race.isOver() ? -1 : race.turnsLeft(1)).append('\n');
    }

    private static String word(double value) {
        return Long.toString((long) value);
    }
}

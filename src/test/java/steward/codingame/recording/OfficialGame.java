package steward.codingame.recording;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.json.JsonNumbers;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TimeControl;
import steward.match.Turn;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes a match played here in the form of CodinGame's own JSON, as its server does: a frame per player, the pods in
 * the view of the key frame, the impacts behind them.
 */
public final class OfficialGame implements MatchListener {

    private static final int PODS = 4;
    private final ObjectNode result = JsonMapper.shared().createObjectNode();
    private final ArrayNode frames = result.putArray("frames");
    private final List<Integer> impactTurns = new ArrayList<>();
    private PodRace race;
    private GameJson codec;
    private final List<String> said = new ArrayList<>();
    private SiteViews views;
    private int turns;

    private OfficialGame() {
    }

    /** A whole game between bots drawn by lot that ram each other now and then. */
    public static OfficialGame play(long seed) {
        return play(TestScenes.open("mad-pod-racing"), seed, new SeededBot(seed, 0.2), new SeededBot(seed + 1, 0.2));
    }

    /** A whole game between two bots. */
    static OfficialGame play(GameSetup setup, long seed, Bot one, Bot two) {
        OfficialGame game = new OfficialGame();
        List<InProcessPlayer> players = List.of(new InProcessPlayer("a", one), new InProcessPlayer("b", two));
        try {
            MatchResult end = new Referee(setup, seed, players, TimeControl.UNLIMITED, game).play();
            ArrayNode ranks = game.result.putArray("ranks");
            end.players().forEach(player -> ranks.add(player.rank()));
            ArrayNode scores = game.result.putArray("scores");
            Arrays.stream(game.views.scores()).forEach(scores::add);
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
                frame.remove(List.of("view", "summary"));
            }
        }
        ((ObjectNode) all.get(keyFrame(turns))).remove(List.of("stdout", "view", "summary"));
        sketch.remove("scores");
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
    public void start(Game game, GameJson gameCodec) {
        race = (PodRace) game;
        codec = gameCodec;
        views = new SiteViews(race);
        frames.addObject().put("view", views.first(List.of())).put("summary", views.summary()).put("keyframe", true)
            .put("agentId", -1);
    }

    @Override
    public void commands(Turn turn) {
        said.clear();
        for (int player = 0; player < 2; player++) {
            StringWriter json = new StringWriter();
            try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), json)) {
                codec.writeCommand(out, player);
            }
            StringBuilder lines = new StringBuilder();
            for (JsonNode pod : JsonMapper.shared().readTree(json.toString())) {
                lines.append(pod.get("x")).append(' ').append(pod.get("y")).append(' ').append(
                    pod.has("shield") ? "SHIELD" : pod.has("boost") ? "BOOST" : pod.get("thrust")).append(" go\n");
            }
            said.add(lines.toString());
        }
        views.before();
    }

    @Override
    public void played(Turn turn) {
        turns = turn.number();
        frames.addObject().put("stdout", said.get(0)).put("keyframe", false).put("agentId", 0)
            .put("view", " " + (2 * turns - 1) + "\n");
        if (race.log().impacts() > 0) {
            impactTurns.add(turns);
        }
        frames.addObject().put("stdout", said.get(1)).put("keyframe", true).put("agentId", 1)
            .put("view", views.after(2 * turns, List.of(), "go") + views.impacts()).put("summary", views.summary());
    }
}

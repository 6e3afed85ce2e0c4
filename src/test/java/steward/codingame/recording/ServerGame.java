package steward.codingame.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;
import java.util.function.BiFunction;
import java.util.function.Function;
import steward.game.CodecText;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.TextCodec;
import steward.game.ViewWriter;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.searchrace.SearchRace;
import steward.match.TestScenes;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes the first turns of a game played here in the form of CodinGame's own JSON. Only the server, or a published
 * referee, can tell the worth of its views.
 */
final class ServerGame {

    private final ObjectNode result = JsonMapper.shared().createObjectNode();
    private final ArrayNode frames = result.putArray("frames");
    private final ViewWriter views;
    private final Game game;
    private final TextCodec codec;
    private final Function<List<String>, String> text;

    private ServerGame(String id, long seed, Function<List<String>, String> text) {
        this.text = text;
        views = TestScenes.TYPES.viewWriter(id).orElseThrow();
        GameSetup setup = TestScenes.TYPES.open(views.observed(SceneReader.read(SceneFiles.load(id), null)));
        game = setup.create(seed);
        codec = setup.textCodec(game).orElseThrow();
        views.begin(game);
        show(frames.addObject().put("keyframe", true).put("agentId", -1), views.start());
    }

    /**
     * Plays.
     *
     * @param turns   fewer if the game is over before
     * @param answers of a player in a game, by its number
     * @param text    of a view from its lines
     */
    static ObjectNode play(String id, long seed, int turns, BiFunction<Game, Integer, String> answers,
                           Function<List<String>, String> text) {
        ServerGame of = new ServerGame(id, seed, text);
        for (int turn = 0; turn < turns && !of.game.isOver(); turn++) {
            of.turn(answers);
        }
        return of.result;
    }

    /** A whole search race, up to the finish. */
    static ObjectNode searchRace() {
        return play("search-race", 1, 600, (race, player) -> {
            SearchRace of = (SearchRace) race;
            double[] next = of.checkpoints()[of.nextCheckpoint()];
            double wanted = Math.atan2(next[1] - of.bodies().y[0] - 3 * of.bodies().vy[0],
                next[0] - of.bodies().x[0] - 3 * of.bodies().vx[0]) - of.heading();
            return "EXPERT " + Math.round(Math.max(-18, Math.min(18, Math.toDegrees(
                Math.IEEEremainder(wanted, 2 * Math.PI))))) + (of.turn() % 2 == 0 ? " 180 even" : " 190 odd one");
        }, ServerGame::graphics);
    }

    /** Some turns of wizards who carry, throw and cast. */
    static ObjectNode fantasticBits() {
        return play("fantastic-bits", 3, 14, (bits, player) -> {
            FantasticBits of = (FantasticBits) bits;
            StringJoiner lines = new StringJoiner("\n");
            for (int k = 0; k < Pitch.WIZARDS_PER_PLAYER; k++) {
                int wizard = player * Pitch.WIZARDS_PER_PLAYER + k;
                int snaffle = Pitch.WIZARDS + wizard;
                lines.add(of.pitch().held(wizard) >= 0 ? "THROW 9000 4000 500 go"
                    : of.turn() % 13 == 0 && k == 0 ? "FLIPENDO " + of.bodies().id(snaffle)
                    : "MOVE " + (long) of.bodies().x[snaffle] + " " + (long) of.bodies().y[snaffle] + " 140 on");
            }
            return lines.toString();
        }, lines -> String.join("\n", lines) + "\n").put("refereeInput", "seed=3\n");
    }

    private void turn(BiFunction<Game, Integer, String> answers) {
        String[] messages = new String[game.players()];
        for (int player = 0; player < game.players(); player++) {
            String answer = answers.apply(game, player);
            String wrong = CodecText.read(codec, player, answer);
            if (wrong != null) {
                throw new AssertionError(wrong);
            }
            messages[player] = codec.message(player);
            boolean last = player == game.players() - 1;
            frames.addObject().put("stdout", answer + "\n").put("keyframe", last).put("agentId", player)
                .put("view", " " + (frames.size() - 1) + "\n");
        }
        views.before();
        game.play();
        show((ObjectNode) frames.get(frames.size() - 1), views.after(messages, List.of()));
    }

    private void show(ObjectNode frame, ViewWriter.Frame shown) {
        List<String> lines = new ArrayList<>(shown.view());
        lines.set(0, lines.get(0).replaceFirst("^\\*", " " + (frames.size() - 1)));
        frame.put("view", text.apply(lines));
        frame.put("summary", String.join("\n", shown.summary()));
    }

    /** A view of the toolkit's form from the lines in which it is compared. */
    static String graphics(List<String> lines) {
        ObjectNode frame = JsonMapper.shared().createObjectNode();
        List<String> updates = new ArrayList<>();
        ObjectNode tips = JsonMapper.shared().createObjectNode();
        for (String line : lines.subList(1, lines.size())) {
            String[] words = line.split(" ");
            if (words[0].equals("update")) {
                updates.add(line.substring(words[0].length() + 1));
            } else if (words[0].equals("endScreen")) {
                ArrayNode end = frame.putArray("endScreen");
                end.addArray().add(Integer.parseInt(words[1]));
                end.add("image").addArray().add(words[2]);
            } else {
                tips.put(words[1], line.split(" ", 3)[2].replace(" x", "\nx").replace(" y", "\ny"));
            }
        }
        frame.put("entitymodule", "U" + String.join(";", updates));
        frame.putArray("tooltips").add(tips);
        ObjectNode start = JsonMapper.shared().createObjectNode();
        return lines.get(0) + "\n" + (lines.get(0).equals(" 0") ? start.set("frame", frame) : frame) + "\n";
    }
}

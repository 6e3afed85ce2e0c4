package steward.codingame.recording;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.RulesEdition;
import steward.scene.SceneFiles;
import steward.scene.SceneText;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Makes a replay of ours from an official recording of a pod race. */
public final class GameRecordingImport implements RecordingImport {

    private static final String SCENE = "mad-pod-racing";

    private final GameRecording recording;
    private final GameSetup setup;

    private GameRecordingImport(GameRecording recording, GameSetup setup) {
        this.recording = recording;
        this.setup = setup;
    }

    /**
     * Reads a recording.
     *
     * @param json   the text of CodinGame's JSON
     * @param source its name, for errors
     * @param types  must know the pod race
     * @param rules  edition of the rules by which it was played
     * @throws IllegalArgumentException     if it is no recording of a pod race; says in which frame and line
     * @throws steward.scene.json.SceneException if no race is possible on its map
     */
    static GameRecordingImport of(String json, String source, GameTypes types, RulesEdition rules) {
        GameRecording recording = GameRecordingReader.read(json, source);
        return new GameRecordingImport(recording, types.open(scene(recording, rules), source + " (scene)"));
    }

    /** Reads a recording of a race by today's rules, as above. */
    public static GameRecordingImport of(String json, String source, GameTypes types) {
        return of(json, source, types, RulesEdition.LIVE);
    }

    /** The official scene on the recorded map. */
    private static String scene(GameRecording recording, RulesEdition rules) {
        SceneText official = SceneFiles.load(SCENE);
        ObjectNode scene = (ObjectNode) JsonMapper.shared().readTree(official.text());
        ObjectNode race = (ObjectNode) scene.get("race");
        race.put("rules", rules.word());
        race.put("shift", false);
        race.put("jitter", 0);
        ArrayNode checkpoints = race.putArray("maps").addObject().putArray("checkpoints");
        for (double[] checkpoint : recording.checkpoints()) {
            checkpoints.addObject().put("x", checkpoint[0]).put("y", checkpoint[1]);
        }
        return scene.toString();
    }

    @Override
    public Imported write(OutputStream out) throws InterruptedException {
        List<RecordedPlayer> players = IntStream.range(0, GameRecording.PLAYERS).mapToObj(player ->
            new RecordedPlayer(recording.facts().names().get(player), recording.turns().stream()
                .map(turn -> turn.commands().get(player)).toList(), GameRecordingImport::idle)).toList();
        return new ImportedMatch(setup, recording.facts().seed(), new ObservedGame(recording), recording.facts(),
            players).write(out);
    }

    /** The answer where none is recorded: every pod aims at its own position, which has no effect. */
    private static List<String> idle(String frame, int pods) {
        List<String> lines = new ArrayList<>();
        for (String line : frame.split("\n")) {
            String[] words = line.split(" ");
            if (lines.size() < pods) {
                lines.add(words[0] + " " + words[1] + " 0 not asked any more");
            }
        }
        return lines;
    }
}

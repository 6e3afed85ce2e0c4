package steward.codingame;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.PodRace;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.SceneFiles;
import steward.scene.SceneText;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Makes a replay of ours from an official recording: the recorded lines are played by our referee as if bots had just
 * said them, and what the server saw is kept in place of our own outcomes, so that verifying the replay compares our
 * physics with the server's.
 */
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
     * @throws IllegalArgumentException     if it is no recording of a pod race; says in which frame and line
     * @throws steward.scene.json.SceneException if no race is possible on its map
     */
    public static GameRecordingImport of(String json, String source, GameTypes types) {
        GameRecording recording = GameRecordingReader.read(json, source);
        return new GameRecordingImport(recording, types.open(scene(recording), source + " (scene)"));
    }

    /** The official scene on the recorded map. */
    private static String scene(GameRecording recording) {
        SceneText official = SceneFiles.load(SCENE);
        ObjectNode scene = (ObjectNode) JsonMapper.shared().readTree(official.text());
        ObjectNode race = (ObjectNode) scene.get("race");
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
        List<Seat> seats = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (int player = 0; player < GameRecording.PLAYERS; player++) {
            RecordedPlayer recorded = new RecordedPlayer(recording, player);
            seats.add(new Seat(recorded, Protocol.CODINGAME));
            names.add(recorded.name());
        }
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), 0, names,
            List.of("recorded", "recorded"), List.of(Protocol.CODINGAME, Protocol.CODINGAME),
            Double.POSITIVE_INFINITY);
        ObservedGame observed = new ObservedGame(recording);
        ReplayWriter writer = new ReplayWriter(out, header, observed);
        Recorder recorder = new Recorder(recording, observed, writer);
        try {
            MatchResult result = Referee.of(setup, 0, seats, TimeControl.UNLIMITED, recorder).play();
            return new Imported(recorder.turns, result.ending());
        } catch (RecordingEnds end) {
            if (!recording.ranks().isEmpty()) {
                writer.end(over(names));
            }
            return new Imported(recorder.turns, null);
        }
    }

    /** The result of a game that the server has ended, but our rules have not: verification will say so. */
    private MatchResult over(List<String> names) {
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (int player = 0; player < names.size(); player++) {
            players.add(new MatchResult.PlayerResult(names.get(player), recording.ranks().get(player), 0, null, null,
                0, 0, 0, 0, 0));
        }
        return new MatchResult(recording.turns().size(), "the recording ends", players);
    }

    /** The recording has no more turns, but by our rules the game goes on. */
    private static final class RecordingEnds extends RuntimeException {

        private static final long serialVersionUID = 1L;

        RecordingEnds() {
            super("the recording ends", null, false, false);
        }
    }

    /** Passes a match on to a writer as far as it was recorded. */
    private static final class Recorder implements MatchListener {

        private final GameRecording recording;
        private final ObservedGame observed;
        private final ReplayWriter writer;
        private int turns;

        Recorder(GameRecording recording, ObservedGame observed, ReplayWriter writer) {
            this.recording = recording;
            this.observed = observed;
            this.writer = writer;
        }

        @Override
        public void start(Game game, FrameCodec codec) {
            observed.start((PodRace) game);
            writer.start(game, codec);
        }

        @Override
        public void commands(Turn turn) {
            if (turn.number() > recording.turns().size()) {
                throw new RecordingEnds();
            }
            boolean anyFault = false;
            for (int player = 0; player < turn.players(); player++) {
                anyFault |= turn.fault(player) != null;
            }
            observed.failed(anyFault);
            writer.commands(turn);
        }

        @Override
        public void played(Turn turn) {
            writer.played(turn);
            turns++;
        }

        /** The result counts the turns that the server played after the end by our rules. */
        @Override
        public void end(MatchResult result) {
            int all = recording.turns().size();
            while (all > turns && recording.turns().get(all - 1).isSilent()) {
                all--;
            }
            writer.end(new MatchResult(all, result.ending(), result.players(), result.data()));
        }
    }
}

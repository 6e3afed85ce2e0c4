package steward.codingame;

import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.Player;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.JsonNumbers;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.replay.Observations;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.SceneFiles;
import steward.scene.SceneText;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Makes a replay of ours from an official recording: the recorded lines are played by our referee as if bots had just
 * said them, and what the server saw is kept in place of our own outcomes, so that verifying the replay compares our
 * physics with the server's.
 */
public final class GameRecordingImport {

    private static final String SCENE = "mad-pod-racing";
    private static final int SHIELD_TIMER = 4;

    private GameRecordingImport() {
    }

    /**
     * What was imported.
     *
     * @param turns  how many turns the replay has
     * @param ending how the game ended by our rules, or {@code null} if the recording ends before
     */
    public record Imported(int turns, String ending) {
    }

    /**
     * Reads a recording and writes the replay.
     *
     * @param json   the text of CodinGame's JSON
     * @param source its name, for errors
     * @param types  must know the pod race
     * @param out    closed at the end
     * @throws IllegalArgumentException if it is no recording of a pod race
     */
    public static Imported run(String json, String source, GameTypes types, OutputStream out)
            throws InterruptedException {
        GameRecording recording = GameRecordingReader.read(json, source);
        GameSetup setup = types.open(scene(recording), source + " (scene)");
        List<Seat> seats = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (int player = 0; player < GameRecording.PLAYERS; player++) {
            seats.add(new Seat(new RecordedPlayer(recording, player), Protocol.CODINGAME));
            names.add("player " + player);
        }
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), 0, names,
            List.of("recorded", "recorded"), List.of(Protocol.CODINGAME, Protocol.CODINGAME),
            Double.POSITIVE_INFINITY);
        try (ReplayWriter writer = new ReplayWriter(out, header, new Observed(recording))) {
            UpToTheEnd listener = new UpToTheEnd(writer, recording.turns().size());
            try {
                MatchResult result = Referee.of(setup, 0, seats, TimeControl.UNLIMITED, listener).play();
                return new Imported(listener.turns, result.ending());
            } catch (RecordingEnds end) {
                return new Imported(listener.turns, null);
            }
        }
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

    /** Says what was recorded. */
    private static final class RecordedPlayer implements Player {

        private final GameRecording recording;
        private final int number;
        private int turn;

        RecordedPlayer(GameRecording recording, int number) {
            this.recording = recording;
            this.number = number;
        }

        @Override
        public String name() {
            return "player " + number;
        }

        @Override
        public void tell(byte[] lines, int length) {
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            answer.clear();
            String commands = turn < recording.turns().size()
                ? recording.turns().get(turn).commands().get(number) : null;
            turn++;
            if (commands == null) {
                answer.setFault("no answer in the recording");
                return Ending.FAULT;
            }
            byte[] bytes = commands.getBytes(StandardCharsets.UTF_8);
            answer.append(bytes, 0, bytes.length);
            return Ending.ANSWERED;
        }

        @Override
        public void onAbandoned(Consumer<Answer> continuation) {
        }

        @Override
        public void finish(byte[] lines, int length) {
        }
    }

    /** The recording has no more turns, but by our rules the game goes on. */
    private static final class RecordingEnds extends RuntimeException {

        private static final long serialVersionUID = 1L;

        RecordingEnds() {
            super("the recording ends", null, false, false);
        }
    }

    /** Passes a match on to a writer as far as it was recorded. */
    private static final class UpToTheEnd implements MatchListener {

        private final ReplayWriter writer;
        private final int recorded;
        private int turns;

        UpToTheEnd(ReplayWriter writer, int recorded) {
            this.writer = writer;
            this.recorded = recorded;
        }

        @Override
        public void start(Game game, FrameCodec codec) {
            writer.start(game, codec);
        }

        @Override
        public void commands(Turn turn) {
            if (turn.number() > recorded) {
                throw new RecordingEnds();
            }
            writer.commands(turn);
        }

        @Override
        public void played(Turn turn) {
            writer.played(turn);
            turns++;
        }

        @Override
        public void end(MatchResult result) {
            writer.end(result);
        }
    }

    /** What the server saw, in the form of a replay. */
    private static final class Observed implements Observations {

        private final GameRecording recording;
        private final int[] passed = new int[GameRecording.PODS];
        private final int[] next = new int[GameRecording.PODS];

        Observed(GameRecording recording) {
            this.recording = recording;
        }

        @Override
        public void writeStart(JsonGenerator out) {
            for (int pod = 0; pod < recording.start().size(); pod++) {
                next[pod] = recording.start().get(pod).nextCheckpoint();
            }
            writePods(out, recording.start(), true);
        }

        @Override
        public void writeOutcome(JsonGenerator out, int number) {
            GameRecording.Turn turn = recording.turns().get(number - 1);
            if (turn.commands().contains(null)) {
                return;                              // the game ends here: the server played no further
            }
            if (turn.impacts() != null) {
                out.writeArrayPropertyStart("impacts");
                for (GameRecording.Impact impact : turn.impacts()) {
                    out.writeStartObject();
                    JsonNumbers.write(out, "time", impact.time());
                    out.writeNumberProperty("a", impact.a());
                    out.writeNumberProperty("b", impact.b());
                    JsonNumbers.write(out, "impulse", impact.impulse());
                    out.writeEndObject();
                }
                out.writeEndArray();
            }
            if (!turn.after().isEmpty()) {
                count(turn.after());
                out.writeObjectPropertyStart("state");
                writePods(out, turn.after(), number < recording.turns().size());
                out.writeEndObject();
            }
        }

        /** A pod whose next checkpoint has moved on has passed as many. */
        private void count(List<GameRecording.Pod> pods) {
            int count = recording.checkpoints().length;
            for (int pod = 0; pod < pods.size(); pod++) {
                int now = pods.get(pod).nextCheckpoint();
                passed[pod] += Math.floorMod(now - next[pod], count);
                next[pod] = now;
            }
        }

        /** On the last turn, the server's next checkpoint of the pod that has won is the one it has just passed. */
        private void writePods(JsonGenerator out, List<GameRecording.Pod> pods, boolean withPassed) {
            if (pods.isEmpty()) {
                return;
            }
            out.writeArrayPropertyStart("bodies");
            for (int k = 0; k < pods.size(); k++) {
                GameRecording.Pod pod = pods.get(k);
                out.writeStartObject();
                out.writeNumberProperty("id", k);
                out.writeNumberProperty("player", 2 * k / GameRecording.PODS);
                JsonNumbers.write(out, "x", pod.x());
                JsonNumbers.write(out, "y", pod.y());
                JsonNumbers.write(out, "vx", pod.vx());
                JsonNumbers.write(out, "vy", pod.vy());
                JsonNumbers.writeOrNull(out, "heading", pod.heading());
                if (pod.shield()) {
                    out.writeNumberProperty("shieldTimer", SHIELD_TIMER);
                }
                if (withPassed) {
                    out.writeNumberProperty("passed", passed[k]);
                }
                out.writeEndObject();
            }
            out.writeEndArray();
        }

        @Override
        public int rank(int player) {
            return player < recording.ranks().size() ? recording.ranks().get(player) : -1;
        }
    }
}

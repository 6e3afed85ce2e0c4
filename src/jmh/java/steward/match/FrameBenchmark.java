package steward.match;

import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import steward.bot.LineBuffer;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.SceneFiles;
import steward.scene.SceneText;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The cost of one line on the official scene: a player's turn frame, an answer, both by trees of JSON nodes too, a turn
 * of the replay without impacts.
 * All pods move before every frame and turn, because unchanged values are not written again:
 * {@code ./gradlew jmh -Pbench=Frame}; add {@code -prof gc} to the options to see what is allocated.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class FrameBenchmark {

    private static final byte[] ANSWER =
        "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50},{\"x\":1200,\"y\":450,\"thrust\":200}]}"
            .getBytes(StandardCharsets.UTF_8);

    private Dialogue dialogue;
    private ReplayWriter replay;
    private Turn turn;
    private JsonNode tree;
    private PodRace race;
    private final PodState[][] states = new PodState[256][];
    private int next;

    /** Some turns into a race, so that headings are not whole numbers. */
    @Setup
    public void play() {
        SceneText scene = SceneFiles.load("mad-pod-racing");
        GameSetup setup = new GameTypes(List.of(new PodRaceType())).open(scene.text(), scene.source());
        race = (PodRace) setup.create(1);
        dialogue = Dialogue.of(Protocol.JSON, setup, race, setup.codec(race), Map.of());
        replay = new ReplayWriter(OutputStream.nullOutputStream(), new ReplayHeader(setup.scene().gameId(),
            setup.scene().json(), 1, List.of("a", "b"), List.of("a", "b"), 1));
        replay.start(race, setup.codec(race));
        for (int k = 0; k < 10; k++) {
            answer();
            dialogue.readAnswer(1, ANSWER, ANSWER.length);
            race.play();
        }
        answer();
        dialogue.readAnswer(1, ANSWER, ANSWER.length);
        LineBuffer line = dialogue.turn(0);
        tree = JsonMapper.shared().readTree(Arrays.copyOf(line.bytes(), line.size()));
        for (int k = 0; k < states.length; k++) {
            states[k] = new PodState[race.settings().pods()];
            for (int pod = 0; pod < states[k].length; pod++) {
                PodState now = race.pod(pod);
                states[k][pod] = new PodState(now.x() + 3 * k, now.y() - 2 * k, now.vx() + k, now.vy() - k,
                    now.heading() + k, 0, true, now.passed());
            }
        }
        turn = Turn.of(11, 2);
        turn.answer(0, null, null, 1000);
        turn.answer(1, null, null, 1000);
    }

    /** Moves all pods. */
    private void move() {
        PodState[] pods = states[next++ & states.length - 1];
        for (int pod = 0; pod < pods.length; pod++) {
            race.setPod(pod, pods[pod]);
        }
    }

    @Benchmark
    @OperationsPerInvocation(2)
    public int frame() {
        move();
        return dialogue.turn(0).size() + dialogue.turn(1).size();
    }

    /** A frame by the textbook: from a tree of JSON nodes, which is there already. */
    @Benchmark
    public byte[] frameOfTree() {
        return JsonMapper.shared().writeValueAsBytes(tree);
    }

    /** An answer by the textbook: to a tree of JSON nodes. */
    @Benchmark
    public JsonNode answerToTree() {
        return JsonMapper.shared().readTree(ANSWER);
    }

    @Benchmark
    public String answer() {
        return dialogue.readAnswer(0, ANSWER, ANSWER.length);
    }

    @Benchmark
    public ReplayWriter replayTurn() {
        move();
        replay.commands(turn);
        replay.played(turn);
        return replay;
    }
}

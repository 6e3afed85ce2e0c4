package steward.match;

import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.PodRaceType;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/**
 * What one line costs on the official scene: a player's turn frame, an answer, a turn of the replay without impacts:
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

    /** Some turns into a race, so that headings are no whole numbers. */
    @Setup
    public void play() {
        SceneText scene = SceneFiles.load("mad-pod-racing");
        GameSetup setup = new GameTypes(List.of(new PodRaceType())).open(scene.text(), scene.source());
        Game game = setup.create(1);
        dialogue = Dialogue.of(Protocol.JSON, setup, game, setup.codec(game));
        replay = new ReplayWriter(OutputStream.nullOutputStream(), new ReplayHeader(setup.scene().gameId(),
            setup.scene().json(), 1, List.of("a", "b"), List.of("a", "b"), 1));
        replay.start(game, setup.codec(game));
        for (int k = 0; k < 10; k++) {
            answer();
            dialogue.readAnswer(1, ANSWER, ANSWER.length);
            game.play();
        }
        answer();
        dialogue.readAnswer(1, ANSWER, ANSWER.length);
        turn = Turn.of(11, 2);
        turn.answer(0, null, null, 1000);
        turn.answer(1, null, null, 1000);
    }

    @Benchmark
    public int frame() {
        return dialogue.turn(0).size();
    }

    @Benchmark
    public String answer() {
        return dialogue.readAnswer(0, ANSWER, ANSWER.length);
    }

    @Benchmark
    public ReplayWriter replayTurn() {
        replay.commands(turn);
        replay.played(turn);
        return replay;
    }
}

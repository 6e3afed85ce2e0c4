import java.nio.file.Path;
import steward.game.podrace.protocol.PodRaceJson;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;

public class ReplayStates {
    public static void main(String[] files) throws Exception {
        try (ReplayReader replay = ReplayReader.open(Path.of(files[0]))) {
            for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next())
                for (PodRaceJson.Pod pod : turn.state(PodRaceJson.State.class).bodies())
                    System.out.println(turn.number() + " " + pod.id() + " " + pod.x() + " " + pod.y() + " " + pod.passed());
        }
    }
}

import java.util.List;
import steward.contest.Contest;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

public class OneMatch {
    public static void main(String[] bots) throws InterruptedException {
        GameSetup setup = GameTypes.installed().open(SceneReader.read(SceneFiles.load("mad-pod-racing"), null));
        Contest contest = Contest.of(setup, List.of(bots), Protocol.JSON, 1);
        MatchResult result = contest.play(7, 0, null, new MatchListener() { });
        result.players().forEach(player -> System.out.println(player.name() + ": rank " + (1 + player.rank())));
    }
}

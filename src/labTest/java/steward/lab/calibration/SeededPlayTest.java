package steward.lab.calibration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.Pilot;
import steward.game.podrace.protocol.PodRaceType;
import steward.lab.trial.Probe;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnLog;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** States of a game as they stood when the flight of a turn began. */
class SeededPlayTest {

    private static final Pilot CROWD = (game, player, random) -> "{\"pods\":[" + pod(random.nextInt(200))
        + "," + (random.nextInt(9) == 0 ? "{\"x\":8000,\"y\":4500,\"shield\":true}" : pod(100)) + "]}";

    private static String pod(int thrust) {
        return "{\"x\":8000,\"y\":4500,\"thrust\":" + thrust + "}";
    }

    private static GameSetup setup() {
        SceneText text = SceneFiles.load("mad-pod-racing");
        return new GameTypes(List.of(new PodRaceType())).open(text.text(), text.source());
    }

    /** Flown from there with the scene's own physics, the bodies end where the next turn begins. */
    @Test
    void aTurnThatIsFlownAgainEndsWhereTheGameWent() {
        GameSetup setup = setup();
        SeededPlay play = new SeededPlay(setup, CROWD, 5);
        Motion motion = setup.plan().motion();
        Bodies begun = play.next();
        int impacts = 0;
        for (int turn = 1; turn < 90; turn++) {
            TurnLog log = new TurnLog();
            setup.plan().advance(null).turn(begun, log);
            motion.endTurn(begun);
            impacts += log.impacts();
            Bodies next = play.next();
            for (int k = 0; k < 4; k++) {
                assertEquals(next.x[k], begun.x[k], 1, "turn " + turn);
                assertEquals(next.y[k], begun.y[k], 1, "turn " + turn);
            }
            begun = next;
        }
        assertTrue(impacts > 20, "impacts " + impacts);
    }

    @Test
    void theSameSeedGivesTheSameStates() {
        SeededPlay one = new SeededPlay(setup(), CROWD, 3);
        SeededPlay other = new SeededPlay(setup(), CROWD, 3);
        for (int turn = 0; turn < 300; turn++) {
            assertTrue(Probe.same(one.next(), turn % 4, other.next(), turn % 4), "turn " + turn);
        }
    }

    @Test
    void anAnswerThatIsRefusedIsNamed() {
        SeededPlay play = new SeededPlay(setup(), (game, player, random) -> "hello", 1);
        assertTrue(assertThrows(IllegalArgumentException.class, play::next).getMessage()
            .startsWith("seeded play of mad-pod-racing, player 0: "));
    }
}

package steward.game;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.scene.SceneFiles;
import steward.scene.json.SceneException;

/** Rules of every game with an official arithmetic: other rungs, scenes refused. */
public abstract class GameRules<G extends Game> {

    private final String scene;
    private final GameSetup official;

    /** @param scene the name of a shipped scene */
    protected GameRules(String scene) {
        this.scene = scene;
        official = TestScenes.open(scene);
    }

    /** Returns a game of another setup in the state of one that is played. */
    protected abstract G twin(GameSetup other, G game);

    /** Returns the share of turns at the least that other rungs end alike. */
    protected abstract double alike();

    /** Returns by how much places, speeds and radii that count as alike may differ. */
    protected double tolerance() {
        return 0;
    }

    private boolean isAlike(G game, G twin) {
        Bodies one = game.bodies();
        Bodies other = twin.bodies();
        boolean same = one.size() == other.size() && Arrays.equals(game.scores(), twin.scores());
        for (int k = 0; same && k < one.size(); k++) {
            same = one.id(k) == other.id(k) && one.kind[k] == other.kind[k] && isNear(one.x[k], other.x[k])
                && isNear(one.y[k], other.y[k]) && isNear(one.vx[k], other.vx[k]) && isNear(one.vy[k], other.vy[k])
                && isNear(one.radius[k], other.radius[k]);
            for (int column = 0; same && column < one.columns.length; column++) {
                same = one.columns[column][k] == other.columns[column][k];
            }
        }
        return same;
    }

    private boolean isNear(double one, double other) {
        return Math.abs(one - other) <= tolerance();
    }

    @SuppressWarnings("unchecked")
    private G create(long seed) {
        return (G) official.create(seed);
    }

    /** From the same states the rungs that compute the common law end nearly every turn alike. */
    @ParameterizedTest
    @ValueSource(strings = {"double", "compensated", "exact"})
    void otherRungsPlayTheSameGame(String arithmetic) {
        GameSetup other = TestScenes.changed(scene, "\"official\"", "\"" + arithmetic + "\"");
        SplitMix64 random = new SplitMix64(2);
        G game = create(8);
        int same = 0;
        int turns = 200;
        for (int turn = 0; turn < turns; turn++) {
            game = game.isOver() ? create(8 + turn) : game;
            G twin = twin(other, game);
            for (int player = 0; player < game.players(); player++) {
                String answer = official.pilot(Pilot.Aim.WIN).answer(game, player, random);
                assertNull(CodecText.read(official.codec(game), player, answer));
                assertNull(CodecText.read(other.codec(twin), player, answer));
            }
            game.play();
            twin.play();
            same += isAlike(game, twin) ? 1 : 0;
        }
        assertTrue(same >= turns * alike(), same + " of " + turns + " turns");
    }

    /** Refuses the scene with a text replaced, which must be there. */
    protected final void assertRefused(String part, String instead, String expected) {
        String text = SceneFiles.load(scene).text();
        assertTrue(text.contains(part), part);
        String message = assertThrows(SceneException.class, () -> TestScenes.changed(scene, part, instead))
            .getMessage();
        assertTrue(message.contains(expected), message);
    }
}

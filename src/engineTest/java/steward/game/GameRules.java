package steward.game;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;
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

    /** Gives the commands of a game to its twin. */
    protected abstract void repeatCommands(G game, G twin);

    /** True if both games stand alike after a turn. */
    protected abstract boolean isAlike(G one, G other);

    /** Returns the share of turns at the least that other rungs end alike. */
    protected abstract double alike();

    @SuppressWarnings("unchecked")
    private G create(long seed) {
        return (G) official.create(seed);
    }

    private void command(G game, Pilot.Aim aim, SplitMix64 random) {
        for (int player = 0; player < game.players(); player++) {
            assertNull(CodecText.read(official.codec(game), player, official.pilot(aim).answer(game, player, random)));
        }
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
            command(game, Pilot.Aim.WIN, random);
            repeatCommands(game, twin);
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

package steward.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;
import steward.scene.SceneFiles;
import steward.scene.json.SceneException;

/** Rules of every game with an official arithmetic: copies, other rungs, turns without garbage, scenes refused. */
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

    /** Returns the number of things other than events that a turn may add, for which it allocates. */
    protected int additions(G game) {
        return 0;
    }

    @SuppressWarnings("unchecked")
    private G create(long seed) {
        return (G) official.create(seed);
    }

    private void command(G game, Pilot.Aim aim, SplitMix64 random) {
        for (int player = 0; player < game.players(); player++) {
            byte[] line = official.pilot(aim).answer(game, player, random).getBytes(StandardCharsets.UTF_8);
            assertNull(official.codec(game).readAnswer(player, line, line.length));
        }
    }

    @Test
    @SuppressWarnings("unchecked")
    void aCopyGoesOnAlikeAndIndependently() {
        G game = create(5);
        for (int turn = 0; turn < 10; turn++) {
            command(game, Pilot.Aim.MINGLE, new SplitMix64(turn));
            game.play();
        }
        G copy = (G) game.copy();
        assertEquals(game.hash(), copy.hash());
        for (int turn = 10; turn < 60 && !game.isOver(); turn++) {
            long before = copy.hash();
            command(game, Pilot.Aim.WIN, new SplitMix64(turn));
            game.play();
            assertEquals(before, copy.hash(), "the copy stays as it was");
            command(copy, Pilot.Aim.WIN, new SplitMix64(turn));
            copy.play();
            assertEquals(game.hash(), copy.hash(), "turn " + turn);
            assertEquals(game.scores()[0], copy.scores()[0]);
        }
        assertNotEquals(create(5).hash(), create(6).hash());
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

    /** Turns in which nothing comes or goes; others allocate their events, and a new game's log grows at first. */
    @Test
    void aTurnWithoutEventsAllocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        G game = create(4);
        SplitMix64 random = new SplitMix64(4);
        int free = 0;
        int eventless = 0;
        for (int turn = 0; turn < 2500; turn++) {
            game = game.isOver() ? create(turn) : game;
            command(game, Pilot.Aim.WIN, random);
            int additions = additions(game);
            long before = threads.getCurrentThreadAllocatedBytes();
            game.play();
            long allocated = threads.getCurrentThreadAllocatedBytes() - before;
            if (turn > 2000 && game.events().isEmpty() && !game.isOver() && additions(game) <= additions) {
                eventless++;
                free += allocated == 0 ? 1 : 0;
            }
        }
        assertTrue(eventless > 50, eventless + " turns");
        assertTrue(free >= 0.8 * eventless, "nothing allocated in " + free + " of " + eventless + " turns");
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

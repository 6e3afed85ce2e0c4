package steward.game;

import java.util.Collections;
import java.util.List;
import steward.scene.SceneFiles;
import steward.text.ViewLines;

/**
 * Reader of scene and seed from the first view in a recording of the site's server, for {@code steward import}. Each
 * kind of game has views of its own, which {@link ViewWriter} writes in full; the rest of a recording is the same for
 * all games.
 */
public interface ServerView {

    /** Name of the game as the site's server shows it. */
    String title();

    /** True if a recording with this first view is of this game: where the views tell, its line 1 is the title. */
    default boolean isOf(ViewLines first) {
        return first.line(1).strip().equals(title());
    }

    /**
     * Reads how a game begins.
     *
     * @param first the view of frame 0
     * @param input what the server's referee was given, field {@code refereeInput}; empty if that is not recorded
     * @throws IllegalArgumentException if anything about it is wrong: names the line, what was found and was expected
     */
    Start open(ViewLines first, String input);

    /**
     * Lines of the answer of a player that the server did not ask any more in the turn in which the game ended: they
     * should have no effect.
     *
     * @param sent what our referee has sent
     */
    default List<String> idle(String sent, int lines) {
        return Collections.nCopies(lines, "WAIT");
    }

    /** Beginning of a recorded game. @param scene as JSON */
    record Start(String scene, long seed) { }

    /** Views of a game in a shipped scene that is decided by the seed in {@code refereeInput}. */
    static ServerView ofSeed(String title, String scene) {
        return new Seeded(title, scene);
    }

    /** Reader of such views. */
    record Seeded(String title, String scene) implements ServerView {

        @Override
        public Start open(ViewLines first, String input) {
            return new Start(SceneFiles.load(scene).text(), ShownSeed.required(input, first.source()));
        }
    }
}

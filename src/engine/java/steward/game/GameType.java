package steward.game;

import java.util.List;
import java.util.Optional;
import steward.Internal;
import steward.scene.Scene;

/**
 * A kind of game: opens scenes, and names its bots and protocols. Stateless, with a public constructor without
 * parameters; found as a service.
 */
public interface GameType {

    /** The most players of any game. */
    int MOST_PLAYERS = 16;

    /** The id of the game in scenes, such as {@code pod-race}. */
    String id();

    /** Describes the game in a few words for a list of its official scenes. */
    default String about() {
        return "the official rules of " + id();
    }

    /** Describes one of its official scenes, as {@link #about()}, where a game has several. */
    default String about(Scene scene) {
        return about();
    }

    /**
     * The scene of a game for one player of which nothing is known but the lines of text that it was sent.
     *
     * @return as JSON; {@code null} if these are no lines of this game
     */
    default String sceneOfLines(List<String> lines) {
        return null;
    }

    /** True if a replay may be played again: not where that runs a program that it names, and nobody has agreed. */
    @Internal
    default boolean isTrusted() {
        return true;
    }

    /**
     * A scene by the rules of a league of the site.
     *
     * @param league 1 for the lowest; the highest one has all rules, and so have numbers beyond it
     * @return the scene as JSON; the scene itself where a game has the same rules in all leagues
     */
    default String inLeague(Scene scene, int league) {
        return scene.json();
    }

    /** The scene with another bound on its turns. @return as JSON; {@code null} where a game has no such bound */
    default String withTurns(Scene scene, int turns) {
        return null;
    }

    /** Finds how a game began in recordings of the site's server; without, none of them can be imported this way. */
    @Internal
    default Optional<ServerView> serverView() {
        return Optional.empty();
    }

    /** View of the site's server of a game of this type; without, views are not compared. */
    @Internal
    default Optional<ViewWriter> viewWriter() {
        return Optional.empty();
    }

    /** Lines of text that bots of the game's official scene read and write, or {@code null} if it declares none. */
    default BotStub lineStub() {
        return null;
    }

    /** JSON frames that bots of the game read and write, or {@code null} if it declares none. */
    default BotStub frameStub() {
        return null;
    }

    /** The weakest bundled bot of the game, or {@code null} if there is none. */
    default String weakestBot() {
        return null;
    }

    /** The fewest players that a scene of this game can have. */
    default int fewestPlayers() {
        return 1;
    }

    /** The most players that a scene of this game can have, no more than a scene can have at all. */
    default int mostPlayers() {
        return MOST_PLAYERS;
    }

    /** The most players of a match on the site; a scene may be for more. */
    default int mostOnSite() {
        return mostPlayers();
    }

    /**
     * Reads and checks the game's own blocks of a scene and says which parts it needs.
     *
     * @throws steward.scene.json.SceneException if a block is missing or wrong, or the scene has an unknown field
     */
    GameSetup open(Scene scene);
}

package steward.game;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import steward.Internal;
import steward.scene.Scene;
import steward.scene.SceneReader;
import steward.text.NearestName;

/**
 * The known games; created by the command line, the only place that lists them.
 *
 * @param types each with its own id
 */
public record GameTypes(List<GameType> types) {

    /** Copies the list. */
    public GameTypes {
        types = List.copyOf(types);
    }

    /**
     * Reads a scene, including the blocks of its game.
     *
     * @param text   the scene as JSON
     * @param source where it came from, for errors
     * @throws steward.scene.json.SceneException if anything about it is wrong
     */
    public GameSetup open(String text, String source) {
        return open(SceneReader.read(text, source));
    }

    /**
     * Lets the game of a scene read its blocks.
     *
     * @throws steward.scene.json.SceneException if there is no such game, or anything about its blocks is wrong
     */
    public GameSetup open(Scene scene) {
        List<String> known = new ArrayList<>();
        for (GameType type : types) {
            if (type.id().equals(scene.gameId())) {
                checkPlayers(type, scene);
                return type.open(scene);
            }
            known.add(type.id());
        }
        throw scene.root().error("game", "unknown game \"" + scene.gameId() + "\"",
            "one of " + String.join(", ", known) + NearestName.question(scene.gameId(), known, "\""));
    }

    /** A scene by the rules of a league of the site, see {@link GameType#inLeague}; the setup itself if it has them. */
    public GameSetup inLeague(GameSetup setup, int league) {
        Scene scene = setup.scene();
        GameType type = types.stream().filter(each -> each.id().equals(scene.gameId())).findFirst().orElseThrow();
        String text = type.inLeague(scene, league);
        return text.equals(scene.json()) ? setup : open(text, scene.root().source());
    }

    /** Returns how the site's server shows a game; empty also for an unknown one. */
    @Internal
    public Optional<ServerView> serverView(String gameId) {
        return types.stream().filter(type -> type.id().equals(gameId)).findFirst().flatMap(GameType::serverView);
    }

    /** A new writer of what the site's server would show; empty also for an unknown game. */
    @Internal
    public Optional<ViewWriter> viewWriter(String gameId) {
        return types.stream().filter(type -> type.id().equals(gameId)).findFirst().flatMap(GameType::viewWriter);
    }

    private static void checkPlayers(GameType type, Scene scene) {
        int fewest = type.fewestPlayers();
        int most = type.mostPlayers();
        if (scene.players() < fewest || scene.players() > most) {
            throw scene.root().error("players", Integer.toString(scene.players()), (fewest == most
                ? Integer.toString(most) : fewest + ".." + most) + ", as many as " + type.id() + " is for");
        }
    }
}

package steward.game;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeSet;
import steward.Internal;
import steward.scene.Scene;
import steward.scene.SceneReader;
import steward.text.NearestName;

/**
 * All known games: those of the program, which are listed as services of {@link GameType}, and those of jars.
 *
 * @param types each with its own id
 * @param guest the type of scenes whose referee is a program of its own, or {@code null}; it is not listed
 */
public record GameTypes(List<GameType> types, GameType guest) {

    private static final String SERVICES = "/META-INF/services/" + GameType.class.getName();

    /** Games that Steward computes. */
    public GameTypes(List<GameType> types) {
        this(types, null);
    }

    /** Returns these games and those of a type of guests. */
    @Internal
    public GameTypes withGuests(GameType guests) {
        return new GameTypes(types, guests);
    }

    /** Copies the list. @throws IllegalArgumentException if two games have the same id */
    public GameTypes {
        types = List.copyOf(types);
        Set<String> ids = new TreeSet<>();
        for (GameType type : types) {
            if (!ids.add(type.id())) {
                throw new IllegalArgumentException("found two games \"" + type.id() + "\", expected one");
            }
        }
    }

    /**
     * The games that come with the program, and those that the context class loader of this thread adds as services.
     *
     * @throws IllegalArgumentException if a game of a jar cannot be loaded, or has the id of another
     */
    public static GameTypes installed() {
        List<GameType> types = new ArrayList<>();
        // A ServiceLoader would open every jar of the class path, at every start, for the list of this one.
        try (InputStream in = GameTypes.class.getResourceAsStream(SERVICES)) {
            for (String name : new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList()) {
                types.add((GameType) Class.forName(name).getConstructor().newInstance());
            }
        } catch (IOException | ReflectiveOperationException problem) {
            throw new IllegalStateException(problem);
        }
        ClassLoader context = Thread.currentThread().getContextClassLoader();
        if (context != null && context != GameTypes.class.getClassLoader()) {
            addServices(context, types);
        }
        return new GameTypes(types);
    }

    private static void addServices(ClassLoader loader, List<GameType> types) {
        try {
            for (GameType type : ServiceLoader.load(GameType.class, loader)) {
                if (type.getClass().getClassLoader() == loader) {
                    types.add(type);
                }
            }
        } catch (ServiceConfigurationError | LinkageError problem) {
            throw new IllegalArgumentException("found a jar whose game cannot be loaded (" + problem.getMessage()
                + "), expected one made for this version");
        }
    }

    public Optional<GameType> of(String gameId) {
        return guest != null && guest.id().equals(gameId) ? Optional.of(guest)
            : types.stream().filter(type -> type.id().equals(gameId)).findFirst();
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
        if (guest != null && guest.id().equals(scene.gameId())) {
            return guest.open(scene);
        }
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
        String text = of(scene.gameId()).orElseThrow().inLeague(scene, league);
        return text.equals(scene.json()) ? setup : open(text, scene.root().source());
    }

    /** A new writer of what the site's server would show; empty also for an unknown game. */
    @Internal
    public Optional<ViewWriter> viewWriter(String gameId) {
        return of(gameId).flatMap(GameType::viewWriter);
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

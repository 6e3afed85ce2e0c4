package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * No file of the program names a game other than the first, but for its own room and resources, its bots, the list of
 * games, the names of the shipped scenes, and one view file with its entry in the list of scripts.
 */
@Execution(ExecutionMode.CONCURRENT)
class GameNamesTest {

    private static final Path GAMES = Path.of("src/engine/java/steward/game");
    private static final String FIRST = "podrace";

    /** Where every game has a line. */
    private static final List<String> LISTS = List.of("resources/META-INF/services/steward.game.GameType",
        "java/steward/scene/SceneFiles.java", "resources/steward/view/page.js");

    /** The ids of the games, as their rooms are called: without the hyphen. */
    private static List<String> games() throws IOException {
        try (Stream<Path> rooms = Files.list(GAMES)) {
            return rooms.filter(Files::isDirectory).map(room -> room.getFileName().toString())
                .filter(room -> !room.equals(FIRST)).sorted().toList();
        }
    }

    /**
     * A room's name with a hyphen at any place: {@code searchrace} is also {@code search-race} and SearchRace. Bodies
     * are everywhere; the game of this name is known by its package, its types and its files.
     */
    private static Pattern nameOf(String game) {
        return game.equals("bodies") ? Pattern.compile("steward[./]game[./]bodies|Bodies(Game|Type)|/bodies\\.js")
            : Pattern.compile(String.join("-?", game.split("")), Pattern.CASE_INSENSITIVE);
    }

    private static boolean isOwn(String file, String game) {
        return file.startsWith("java/steward/game/" + game + "/")
            || file.matches("(resources|schemas)/.*") && nameOf(game).matcher(file).find();
    }

    private static List<String> filesThatName(String game) throws IOException {
        Pattern name = nameOf(game);
        TreeSet<String> found = new TreeSet<>();
        for (Path part : HouseClasses.sources().stream().map(Path::getParent).toList()) {
            try (Stream<Path> files = Files.walk(part)) {
                for (Path path : files.filter(Files::isRegularFile).toList()) {
                    String file = part.relativize(path).toString().replace('\\', '/');
                    if (!isOwn(file, game) && name.matcher(Files.readString(path)).find()) {
                        found.add(file);
                    }
                }
            }
        }
        return List.copyOf(found);
    }

    @Test
    @Tag("slow")
    void aGameIsNamedInTheListsAlone() throws IOException {
        assertTrue(games().contains("searchrace"), "there are games to look for: " + games());
        for (String game : games()) {
            TreeSet<String> elsewhere = new TreeSet<>(filesThatName(game));
            elsewhere.removeAll(LISTS);
            assertEquals(new TreeSet<>(), elsewhere, game);
        }
    }

    @Test
    void theFirstGameIsFoundWhereItIsNamed() throws IOException {
        assertTrue(filesThatName(FIRST).contains("java/steward/codingame/recording/RecordingImport.java"),
            "it can find something");
    }
}

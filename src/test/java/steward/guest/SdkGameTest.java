package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.isolation.Isolation;
import steward.scene.SceneReader;

/**
 * A small game of ours on CodinGame's SDK, played by {@code ./gradlew sdkTest -Psteward.sdk=FOLDER}: the SDK's jars are
 * not ours to bring.
 */
@Tag("sdk")
@Tag("process")
@Timeout(300)
class SdkGameTest {

    private static final Path SOURCES = Path.of("src/test/resources/referees/game/com/codingame/game");

    @TempDir
    private Path folder;
    private String jars;

    @BeforeEach
    void compile() throws IOException {
        Path sdk = Path.of(System.getProperty("steward.sdk"));
        List<Path> files;
        try (Stream<Path> all = Files.list(sdk)) {
            files = all.filter(file -> file.toString().endsWith(".jar")).sorted().map(Path::toAbsolutePath).toList();
        }
        Path classes = Files.createDirectories(folder.resolve("target/classes"));
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this is no JDK");
        assertEquals(0, compiler.run(null, null, null, "-proc:none", "-d", classes.toString(), "-cp",
            files.stream().map(Path::toString).collect(Collectors.joining(":")),
            SOURCES.resolve("Player.java").toString(), SOURCES.resolve("Referee.java").toString()));
        jars = Stream.concat(Stream.of(classes), files.stream()).map(file -> "\"" + file + "\"")
            .collect(Collectors.joining(","));
        Files.createDirectories(folder.resolve("lib"));
        for (Path file : files) {
            Files.copy(file, folder.resolve("lib").resolve(file.getFileName()));
        }
        Files.createDirectories(folder.resolve("config/level1"));
        Files.writeString(folder.resolve("config/config.ini"), "min_players=2\nmax_players=3\ntype=multi");
    }

    @AfterEach
    void end() {
        ResidentReferees.shared().close();
    }

    private String scene(int players, String more) {
        return """
            {"name": "small", "game": "guest", "players": %d, "referee": {"classPath": [%s]%s}}"""
            .formatted(players, jars, more);
    }

    /** All that was said in a game of players who answer the number, but for the last, who fails in turn 3. */
    private static List<String> play(String scene, long seed) {
        GuestGame game = (GuestGame) new GuestType(false).open(SceneReader.read(scene, "test")).create(seed);
        List<String> said = new ArrayList<>();
        try {
            while (!game.isOver()) {
                game.blocks().forEach(block -> said.add(block.name() + " " + block.lines()));
                String[] words = game.input(game.asked()).toString().strip().split(" ");
                if (words[0].equals("3") && game.asked() == game.players() - 1) {
                    game.eliminate(game.asked(), "late");
                } else {
                    game.answer(List.of(words[1]), 1);
                }
                game.play();
            }
            for (double score : game.scores()) {
                said.add("score " + score);
            }
        } finally {
            game.close();
        }
        return said;
    }

    @Test
    void twoHundredGamesWithFreshClassesAreTheSame() {
        String scene = scene(3, ", \"leagueLevel\": 2");
        List<String> first = play(scene, 5);
        assertEquals(List.of("score 5.0", "score 5.0", "score -1.0"), first.subList(first.size() - 3, first.size()));
        for (int game = 1; game < 200; game++) {
            assertEquals(first, play(scene, 5));
        }
    }

    @Test
    void twoHundredGamesWithKeptClassesAreRememberedByOneJvm() {
        String scene = scene(2, ", \"leagueLevel\": 1, \"reuse\": \"classes\"");
        for (int game = 1; game < 200; game++) {
            play(scene, game % 100);
        }
        List<String> last = play(scene, 5);
        assertTrue(last.contains("SUMMARY [turn 1, remembered 200]"), last.toString());
    }

    @Test
    void levelsAndSeedsAreOtherGames() {
        List<String> one = play(scene(2, ", \"leagueLevel\": 1"), 5);
        assertTrue(!one.equals(play(scene(2, ", \"leagueLevel\": 2"), 5)), one.toString());
        assertTrue(!one.equals(play(scene(2, ", \"leagueLevel\": 1"), 6)), one.toString());
    }

    @Test
    void aStaticThatRemembersIsFoundByAdopting() {
        List<String> told = new ArrayList<>();
        String scene = Adoption.scene(folder, null, null, "small", Isolation::usual, told::add).json();
        assertEquals("deterministic: games played again were the same in every line", told.get(2));
        assertEquals("classes kept from game to game: SUMMARY differ, so each game gets fresh ones", told.get(3));
        assertTrue(!scene.contains("reuse"), scene);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        101 | exited with status 7
        102 | failed:
        103 | said nothing for 5000 ms
        104 | said SCORES before it asked anybody
        105 | asked more than 20000 times
        106 | said nothing for 5000 ms
        107 | 16 MiB
        """)
    void aFaultIsTheRefereesAndTheNextGameIsPlayed(long seed, String fault) {
        String scene = scene(2, ", \"leagueLevel\": 1, \"limitMs\": 5000");
        String message = assertThrows(RefereeFault.class, () -> play(scene, seed)).getMessage();
        assertTrue(message.contains(fault), message);
        play(scene, 5);
    }
}

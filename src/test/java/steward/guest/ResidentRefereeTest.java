package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.files.JarFolder;
import steward.match.TestSize;
import steward.scene.SceneReader;

/**
 * Referees on a class path, by a stand-in for the SDK that is compiled here: game after game in one JVM. It takes long
 * because each project is compiled, and each resident referee is a JVM.
 */
@Tag("process")
@Timeout(120)
class ResidentRefereeTest {

    @TempDir
    private Path folder;
    private StandInProject project;

    @BeforeEach
    void compile() throws IOException {
        project = StandInProject.compiled(folder);
    }

    @AfterEach
    void end() {
        ResidentReferees.shared().close();
    }

    private String scene(int players, String more) {
        return project.scene(players, more);
    }

    /** Compiles the project with another referee. */
    private void referee(String source) throws IOException {
        StandInProject.compiled(folder, Files.writeString(Files.createDirectories(folder.resolve("source"))
            .resolve("Referee.java"), source));
    }

    /** The lines that adopting tells. */
    private List<String> adopted() {
        List<String> told = new ArrayList<>();
        Adoption.scene(folder, null, null, "small", Isolation::usual, told::add);
        return told;
    }

    /** The summaries of a game in which all answer. */
    private static List<String> play(String scene, long seed) {
        GuestGame game = (GuestGame) new GuestType(false).open(SceneReader.read(scene, "test")).create(seed);
        List<String> summaries = new ArrayList<>();
        try {
            while (!game.isOver()) {
                game.blocks().stream().filter(block -> block.name() == RefereeBlock.Name.SUMMARY)
                    .forEach(block -> summaries.addAll(block.lines()));
                game.answer(List.of("WAIT"), 0);
                game.play();
            }
        } finally {
            game.close();
        }
        return summaries;
    }

    /** Fifty games are more than the loaders that may be alive at once: earlier ones are gone. */
    @Test
    @Tag("sized")
    void manyGamesArePlayedByOneJvmEachWithFreshClasses() {
        int games = TestSize.of(50, 200);
        String scene = scene(3, "");
        List<String> first = play(scene, 200);
        for (int game = 2; game < games; game++) {
            assertEquals(first.size(), play(scene, 200).size());
        }
        List<String> last = play(scene, 200);
        assertTrue(first.get(0).endsWith(" remembered 1 game 1"), first.toString());
        assertEquals(first.get(0).replace("game 1", "game " + games), last.get(0));
        assertEquals("\u00e4 true", last.get(2));
    }

    /** Classes that nothing can unload: the referee has put them where the whole JVM holds them. */
    @Test
    @Tag("campaign")
    void aJvmWithFortyLoadersAliveIsStartedAnew() throws IOException {
        referee("""
            public class Referee {
                static {
                    System.getProperties().put(new Object(), Referee.class);
                }

                public static String turn(int turn, long seed, int games) {
                    return "game " + games;
                }
            }
            """);
        String scene = scene(2, "");
        for (int game = 0; game < 45; game++) {
            assertEquals("game " + (game % 40 + 1), play(scene, 200).get(0));
        }
    }

    @Test
    void reusedClassesRememberAndOneJvmPlaysOneLevel() {
        String reused = ", \"reuse\": \"classes\", \"leagueLevel\": ";
        play(scene(2, reused + 1), 200);
        List<String> second = play(scene(2, reused + 1), 200);
        assertTrue(second.get(0).endsWith(" remembered 9 game 2"), second.toString());
        assertEquals("level 1", second.get(1));
        List<String> other = play(scene(2, reused + 2), 200);
        assertTrue(other.get(0).endsWith(" remembered 1 game 1"), other.toString());
        assertEquals("level 2", other.get(1));
    }

    /** The limit is that of the scene which is played, not of the one that started the JVM: its start is over. */
    @Test
    @Tag("campaign")
    void aFaultIsTheRefereesAndTheNextGameIsPlayedByANewJvm() {
        String scene = scene(2, "");
        assertFault("exited with status 7 before answering; its stderr: noise of the referee | leaving", scene,
            101);
        assertTrue(play(scene, 200).get(0).endsWith(" game 1"));
        assertFault("failed: java.lang.reflect.InvocationTargetException", scene, 102);
        assertTrue(play(scene, 200).get(0).endsWith(" game 1"));
        assertFault("said nothing for 500 ms", scene(2, ", \"limitMs\": 500"), 103);
        assertTrue(play(scene, 200).get(0).endsWith(" game 1"));
    }

    private static void assertFault(String expected, String scene, long seed) {
        String message = assertThrows(RefereeFault.class, () -> play(scene, seed)).getMessage();
        assertTrue(message.contains(expected), message);
    }

    @Test
    void whatIsAdoptedHasLevelsAndFreshClassesBecauseAStaticRemembers() {
        List<String> told = new ArrayList<>();
        String scene = Adoption.scene(folder, null, null, "small", Isolation::usual, told::add).json();
        assertEquals(List.of("players: [2, 3], multi; the scene has 2",
            "league level: 2, the highest that has a folder; no class file compares the level with a number that "
                + "reaches past it",
            "deterministic: games played again were the same in every line",
            "classes kept from game to game: SUMMARY differ, so each game gets fresh ones"), told);
        assertFalse(scene.contains("reuse"), scene);
        assertTrue(scene.contains("\"leagueLevels\": 3"), scene);
        assertEquals("level 2", play(scene, 5).get(1));
    }

    /** Rules that only the next level has, by a number in the class files; games between idle bots show none of it. */
    @Test
    void aLevelPastTheFoldersIsTakenIfClassFilesKnowIt() throws IOException {
        referee("""
            public class Referee {
                private static final int LEVEL = Integer.getInteger("league.level");

                public static String turn(int turn, long seed, int games) {
                    return "rules, chance " + seed + (LEVEL > 2 && turn > 9 ? " more" : "");
                }
            }
            """);
        List<String> told = new ArrayList<>();
        String scene = Adoption.scene(folder, null, null, "small", Isolation::usual, told::add).json();
        assertEquals("league level: 3, since the folders end with level2, and the class files compare the level with "
            + "a number that reaches past it", told.get(1));
        assertEquals("classes kept from game to game: the same games, so the scene reuses them", told.get(3));
        assertTrue(scene.contains("\"leagueLevel\": 3") && scene.contains("\"leagueLevels\": 3"), scene);
        assertTrue(scene.contains("\"level\": \"since the folders end with level2"), scene);
    }

    /** As a contest whose third level was never made: the number in its class files is that of a level that fails. */
    @Test
    void aLevelWithoutAFolderThatFailsIsNone() throws IOException {
        referee("""
            public class Referee {
                public static String turn(int turn, long seed, int games) {
                    if (Integer.getInteger("league.level") > 2) {
                        throw new IllegalStateException("no such level");
                    }
                    return "rules";
                }
            }
            """);
        assertEquals("league level: 2, since games at level 3 fail", adopted().get(1));
    }

    /** Games of one level that differ by themselves are no level; a bot that answers sees what idle ones do not. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        level > 2 ? 7 : 0            | 3, since the folders end with level2, and games between the contest's own bots \
        differ beyond it
        System.nanoTime() % 1000003   | 2, the highest that has a folder; no class file compares the level with a \
        number that reaches past it
        """)
    void gamesOfAnsweringBotsTellLevelsApart(String rule, String expected) throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: needs python3");
        referee("""
            public class Referee {
                public static String turn(int turn, long seed, int games) {
                    String text = System.getProperty("league.level");
                    double level = Double.valueOf(text);           // so that its way is not plain
                    System.setProperty("seen", " " + (RULE));
                    return "rules";
                }
            }
            """.replace("RULE", rule));
        Files.writeString(folder.resolve("config/Boss.py"), "while True:\n    input()\n    print(4, flush=True)\n");
        assertEquals("league level: " + expected, adopted().get(1));
    }

    @Test
    void theCommandWritesTheSceneAndSaysWhatIsMissing() throws IOException {
        Path scene = folder.resolve("made");
        Cli cli = Cli.run("adopt", folder.toString(), "--as", "../" + scene);
        cli.assertRefused("--as: found '../");
        Cli.run("adopt", folder.resolve("nothing").toString()).assertRefused("found no such file, expected the folder "
            + "of a project on the SDK or its jar");
        Files.delete(folder.resolve("lib/core.jar"));
        Cli.run("adopt", folder.toString()).assertRefused("found neither a pom.xml nor target/classes with jars");
        assertEquals(ExitStatus.UNUSABLE, cli.status());
    }

    @Test
    void anotherClassPathIsOtherRules() throws IOException {
        String before = JarFolder.digestOf(new GuestType(false).open(SceneReader.read(scene(2, ""), "test")));
        Files.writeString(folder.resolve("target/classes/more.txt"), "more");
        String after = JarFolder.digestOf(new GuestType(false).open(SceneReader.read(scene(2, ""), "test")));
        assertTrue(before.startsWith("sha256:"), before);
        assertFalse(before.equals(after), after);
    }
}

package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import steward.bot.isolation.Isolation;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.files.JarFolder;
import steward.scene.SceneReader;

/** Referees on a class path, by a stand-in for the SDK that is compiled here: game after game in one JVM. */
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

    /** The summaries of a game in which all answer. */
    private static List<String> play(String scene, long seed) {
        GuestGame game = (GuestGame) new GuestType(false).open(SceneReader.read(scene, "test")).create(seed);
        List<String> summaries = new ArrayList<>();
        try {
            while (!game.isOver()) {
                game.blocks().stream().filter(block -> block.name() == Block.Name.SUMMARY)
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
    void manyGamesArePlayedByOneJvmEachWithFreshClasses() {
        playByOneJvm(50);
    }

    @Test
    @Tag("campaign")
    void twoHundredGamesArePlayedByOneJvmEachWithFreshClasses() {
        playByOneJvm(200);
    }

    private void playByOneJvm(int games) {
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
        StandInProject.compiled(folder, Files.writeString(Files.createDirectories(folder.resolve("source"))
            .resolve("Referee.java"), """
            public class Referee {
                static {
                    System.getProperties().put(new Object(), Referee.class);
                }

                public static String turn(int turn, long seed, int games) {
                    return "game " + games;
                }
            }
            """));
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
        String scene = Adoption.scene(folder, null, "small", Isolation::usual, told::add);
        assertEquals(List.of("players: [2, 3], multi; the scene has 2",
            "league levels: 1, 2, 3, 4; the scene has 4",
            "deterministic: games played again were the same in every line",
            "classes kept from game to game: SUMMARY differ, so each game gets fresh ones"), told);
        assertFalse(scene.contains("reuse"), scene);
        assertTrue(scene.contains("\"leagueLevels\": 4"), scene);
        assertEquals("level 4", play(scene, 5).get(1));
    }

    /** The level is read once, into a static field: a check at one level finds nothing of it. */
    @Test
    @Tag("campaign")
    void aStaticThatKeepsTheLevelIsFoundByMixingLevels() throws IOException {
        StandInProject.compiled(folder, Files.writeString(Files.createDirectories(folder.resolve("source"))
            .resolve("Referee.java"), """
            public class Referee {
                private static final int LEVEL = Integer.getInteger("league.level");

                public static String turn(int turn, long seed, int games) {
                    return "rules of level " + Math.min(LEVEL, 2) + ", chance " + seed;
                }
            }
            """));
        List<String> told = new ArrayList<>();
        String scene = Adoption.scene(folder, null, "small", Isolation::usual, told::add);
        assertEquals("classes kept from game to game: the same games, so the scene reuses them; one JVM one level, "
            + "since SUMMARY differ where levels are mixed", told.get(3));
        assertTrue(scene.contains("\"reuse\": \"classes\""), scene);
        for (int level : new int[] {1, 2, 1}) {
            List<String> summaries = play(scene.replaceFirst("\"leagueLevel\": \\d", "\"leagueLevel\": " + level), 5);
            assertEquals("rules of level " + level + ", chance 5", summaries.get(0));
        }
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

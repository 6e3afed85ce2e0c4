package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.cli.Cli;

/** Commands that play many games of a scene with a referee of its own, or one by other rules. */
@Tag("process")
@Tag("slow")
@Timeout(120)
class GuestContestTest {

    @TempDir
    private static Path project;
    private static String scene;

    @TempDir
    private Path folder;

    @BeforeAll
    static void compile() throws IOException {
        scene = Files.writeString(project.resolve("small.json"), StandInProject.compiled(project).scene(2,
            ", \"leagueLevel\": 1")).toString();
    }

    @AfterAll
    static void end() {
        StandInProject.end();
    }

    private String bot(String name, String word) throws IOException {
        return StandInProject.bot(folder, name, word);
    }

    private static String done(String... words) {
        return Cli.run(words).done().out();
    }

    /** A referee in the folder of its scene, called from another folder. */
    @Test
    void theFilesOfARefereeAreSoughtBesideItsScene() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        Path games = Files.createDirectory(folder.resolve("games"));
        Files.copy(Path.of("src/test/resources/referees/standin.py"), games.resolve("standin.py"));
        String beside = Files.writeString(games.resolve("beside.json"), """
            {"name": "beside", "game": "guest", "players": 2, "referee": {"command": ["python3", "standin.py", "good"]}}
            """).toString();
        Path file = folder.resolve("beside.jsonl");
        done("match", "--scene", beside, "--bot", bot("one", "1"), "--bot", bot("two", "2"), "--out", file.toString());
        done("replay", file.toString(), "--verify", "--run-referee");
        done("league", "init", folder.resolve("league").toString(), "--scene", beside);
        assertTrue(Files.readString(folder.resolve("league/scene.json")).contains("\"" + games.resolve("standin.py")
            + "\""));
    }

    @Test
    void aLeagueLevelIsThatOfTheReferee() throws IOException {
        for (int level = 1; level <= 2; level++) {
            Path file = folder.resolve(level + ".jsonl");
            done("match", "--scene", scene, "--bot", bot("one", "1"), "--bot", bot("two", "2"), "--seed", "5",
                "--league-level", Integer.toString(level), "--out", file.toString());
            String replay = Files.readString(file);
            assertTrue(replay.contains("\"leagueLevel\":" + level + "}"), replay);
            assertTrue(replay.contains("\"level " + level + "\""), replay);
            assertEquals("verified: states of 8 of 8 turns and the result\n", done("replay", file.toString(),
                "--verify", "--run-referee"));
        }
        String command = Files.writeString(folder.resolve("s.json"), """
            {"name": "s", "game": "guest", "players": 2, "referee": {"command": ["sh"]}}""").toString();
        Cli.run("match", "--scene", command, "--bot", bot("one", "1"), "--bot", bot("two", "2"), "--league-level", "2")
            .assertRefused("referee: found a command, expected a classPath with a league level");
        String known = Files.writeString(folder.resolve("known.json"), new StandInProject(project).scene(2,
            ", \"leagueLevels\": 2")).toString();
        Cli.run("match", "--scene", known, "--bot", bot("one", "1"), "--bot", bot("two", "2"), "--league-level", "3")
            .assertRefused("referee.leagueLevel: found 3, expected a whole number 1..2");
    }

    @Test
    @Tag("campaign")
    void aGameForOneIsAdoptedAndPlayed() throws IOException {
        StandInProject.compiled(folder);
        Files.writeString(folder.resolve("config/config.ini"), "type=opti\ncriteria=points\nsorting_order=asc");
        Files.writeString(folder.resolve("config/test1.json"), "{\"title\": \"one\", \"testIn\": \"7\"}");
        Files.writeString(folder.resolve("config/test2.json"), "{\"title\": \"two\", \"testIn\": \"8\"}");
        List<String> told = new ArrayList<>();
        String solo = Files.writeString(folder.resolve("solo.json"), Adoption.scene(folder, null, null, "solo",
            Isolation::usual, told::add).json()).toString();
        assertEquals("players: [1], solo; the scene has 1", told.get(0));
        assertTrue(Files.readString(Path.of(solo)).replaceAll("\\s", "").contains(
            "\"criterion\":\"points\",\"lowerIsBetter\":true,\"tests\":[{\"testIn\":[\"7\"]},{\"testIn\":[\"8\"]}]"),
            told::toString);
        // The stand-in's points are 100.5 less the sum of what the bot said: the better bot says more.
        String table = done("match", "--scene", solo, "--bot", bot("one", "1"), "--bot", bot("two", "2"), "--games",
            "4", "--threads", "1");
        assertTrue(table.contains("seeds 1 to 4, each bot alone"), table);
        assertTrue(table.matches("(?s).*\none +0 +0 +4 .*\ntwo +4 +0 +0 .*\ntest +one +two   .a lower score is better."
            + "\n   1 +[0-9.]+ +[0-9.]+\n   2 +[0-9.]+ +[0-9.]+\nsum +[0-9.]+ +[0-9.]+\n.*"), table);
        Path file = folder.resolve("x.jsonl");
        String said = done("match", "--scene", solo, "--bot", bot("one", "1"), "--out", file.toString());
        assertTrue(said.startsWith("one: the referee has ended the game, score "), said);
        assertTrue(said.contains(", 4 turns (solo, ") && said.contains(" --verify --run-referee   plays it"), said);
        assertTrue(done("replay", file.toString(), "--verify", "--run-referee").startsWith("verified"), said);
        String league = folder.resolve("league").toString();
        done("league", "init", league, "--scene", solo);
        done("league", "add", league, bot("one", "1"));
        done("league", "add", league, bot("two", "2"));
        assertTrue(done("league", "run", league, "--games", "4").contains("games of solo"));
    }

    @Test
    @Tag("campaign")
    void aTestThatDrawsAtRandomLeavesTheOthersVerifiable() throws IOException {
        Path referee = Files.writeString(folder.resolve("Referee.java"),
            Files.readString(Path.of("src/test/resources/referees/sdk/Referee.java"))
                .replace("remembered++;",
                    "System.setProperty(\"seen\", \" \" + (seed == 8 ? System.nanoTime() : 0));"));
        StandInProject.compiled(folder, referee);
        Files.writeString(folder.resolve("config/config.ini"), "type=opti\ncriteria=points\nsorting_order=desc");
        for (int test = 1; test <= 3; test++) {
            Files.writeString(folder.resolve("config/test" + test + ".json"), "{\"testIn\": \"" + (6 + test) + "\"}");
        }
        List<String> told = new ArrayList<>();
        String solo = Files.writeString(folder.resolve("solo.json"), Adoption.scene(folder, null, null, "solo",
            Isolation::usual, told::add).json()).toString();
        assertTrue(told.contains("tests drawn at random: 2; their replays cannot be verified, those of the other 2 "
            + "tests can"), told::toString);
        for (int test = 1; test <= 3; test++) {
            Path file = folder.resolve(test + ".jsonl");
            done("match", "--scene", solo, "--bot", bot("one", "1"), "--seed", "" + test, "--out", file.toString());
            String said = Cli.run("replay", file.toString(), "--verify", "--run-referee").out();
            assertEquals(test != 2, said.startsWith("verified"), said);
        }
    }

    @Test
    @Tag("campaign")
    void aTestEndsWhenTheBetterBotIsFound() throws IOException {
        String said = done("sprt", "--scene", scene, "--bot", bot("new", "3"), "--bot", bot("old", "1"), "--seed",
            "1", "--elo1", "200", "--games", "60", "--quiet");
        assertTrue(said.contains("H1 is accepted: new is better"), said);
    }

    @Test
    void aSearchFindsTheBetterChoice() throws IOException {
        String said = done("tune", "--scene", scene, "--bot", bot("mine", "{word:1|4}"), "--against", bot("other",
            "2"), "--games", "16", "--seeds", "1", "--test-games", "0", "--seed", "1");
        assertTrue(said.contains("word 4"), said);
    }

    @Test
    void aLeagueIsPlayedAndItsRowsCanBeUsed() throws IOException {
        String league = folder.resolve("league").toString();
        done("league", "init", league, "--scene", scene, "--keep", "all", "--seed", "5");
        done("league", "add", league, bot("low", "1"));
        done("league", "add", league, bot("high", "5"));
        String table = done("league", "run", league, "--games", "8");
        assertTrue(table.startsWith("8 games of small\n") && table.contains("1 high"), table);
        assertEquals("Every row can be used: 8 games\n", done("league", "verify", league));
        try (Stream<Path> files = Files.walk(folder.resolve("league/replays"))) {
            List<Path> replays = files.filter(Files::isRegularFile).toList();
            assertEquals(8, replays.size());
            assertTrue(done("replay", replays.get(0).toString(), "--verify", "--run-referee").startsWith("verified"));
        }
    }

    @Test
    void programsOfAFolderMeet() throws IOException {
        Path programs = Files.createDirectories(folder.resolve("submissions"));
        for (int word = 1; word <= 2; word++) {
            Files.writeString(programs.resolve("p" + word + ".py"), """
                import sys
                for line in sys.stdin:
                    print(%d, flush=True)
                """.formatted(word * 4));
        }
        String said = done("tournament", programs.toString(), "--scene", scene, "--games", "4");
        assertTrue(said.contains("1 p2"), said);
        assertFalse(said.contains("failed:"), said);
    }
}

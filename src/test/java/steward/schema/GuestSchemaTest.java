package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.networknt.schema.Schema;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.guest.StandInProject;

/** The schema of scenes with a referee of their own, and of their replays. */
class GuestSchemaTest {

    static final String GAME = "guest";

    static final String ALL = """
        { "$schema": "scene.schema.json", "name": "all", "game": "guest", "players": 1,
          "referee": { "classPath": ["target/classes", "lib/core.jar"], "main": "a.Main", "reuse": "classes",
            "mode": "solo", "leagueLevel": 3, "leagueLevels": 4, "lowerIsBetter": true, "testIn": ["1 2", ""],
            "adopted": {"level": "the highest"},
            "properties": {"width": "12"}, "limitMs": 5000, "undetermined": ["METADATA"] } }
        """;

    @Test
    void aGameForSeveralHasAsManyPlayersAsTheSceneSays() {
        String multi = ALL.replaceFirst("\"mode.*\\],", "");
        SceneVerdictsTest.agree(GAME, multi.replace("\"players\": 1", "\"players\": 16"), true);
        SceneVerdictsTest.agree(GAME, multi.replace("\"players\": 1", "\"players\": 17"), false);
    }

    /** Times of answers, tooltips and summaries, setup lines, and a bot that fails. */
    @ParameterizedTest
    @CsvSource({"monitored, ', \"properties\": {\"width\": \"12\"}'", "chance, ', \"limitMs\": 9000'", "pairs, ''"})
    @Tag("process")
    void sceneAndReplayOfAMatchAreValid(String mode, String more, @TempDir Path folder) throws Exception {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        String scene = """
            {"name": "%s", "game": "guest", "players": 2, "referee": {"command": ["python3", "%s", "%s"]%s}}"""
            .formatted(mode, Path.of("src/test/resources/referees/standin.py").toAbsolutePath(), mode, more);
        SceneVerdictsTest.agree(GAME, scene, true);
        Path file = folder.resolve("x.jsonl");
        assertEquals(0, Cli.run("match", "--scene", Files.writeString(folder.resolve("s.json"), scene).toString(),
            "--bot", StandInProject.bot(folder, "one", "1"), "--bot", "two=sh -c 'read x; echo 1; exit 3'", "--out",
            file.toString(), "--time-factor", "20").status());
        Schema replay = Schemas.open(GAME, "replay");
        List<String> lines = Files.readAllLines(file);
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(replay, line), line);
        }
        assertTrue(lines.stream().anyMatch(line -> line.contains("\"faults\":[null,")), lines.toString());
        assertEquals(Schemas.text(GAME), Cli.run("scene", GAME, "--schema").out());
    }
}

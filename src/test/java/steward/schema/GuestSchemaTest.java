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
import steward.cli.shared.Games;
import steward.guest.StandInProject;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** The schema of scenes with a referee of their own, and of their replays. */
class GuestSchemaTest {

    private static final String GAME = "guest";

    private static final String ALL = """
        { "$schema": "scene.schema.json", "name": "all", "game": "guest", "players": 1,
          "referee": { "classPath": ["target/classes", "lib/core.jar"], "main": "a.Main", "reuse": "classes",
            "mode": "solo", "leagueLevel": 3, "leagueLevels": 4, "lowerIsBetter": true, "testIn": ["1 2", ""],
            "adopted": {"level": "the highest"},
            "properties": {"width": "12"}, "limitMs": 5000, "undetermined": ["METADATA"] } }
        """;

    /** Each row: a part of {@link #ALL}, what stands there instead, and the verdict of both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "players": 1       | "players": 2                  | false
        "players": 1       | "players": 0                  | false
        "name": "all"      | "name": "a\\tb"              | false
        "referee"          | "referees"                    | false
        "game"             | "accuracy": 1, "game"         | false
        "game"             | "impacts": {}, "game"         | false
        "game"             | "motion": {"drag": 1}, "game" | false
        "game"             | "field": {"width": 9, "height": 9}, "game"              | false
        "game"             | "time": {"firstAnswerMs": 9, "answerMs": 9}, "game"     | false
        "target/classes"   | "x y"                         | true
        "target/classes"   | "x\\u0000y"                   | false
        ["target/classes", "lib/core.jar"] | []            | false
        ["target/classes", "lib/core.jar"] | "lib"         | false
        "classPath"        | "command": ["x"], "classPath" | false
        "classPath"        | "classPaths"                  | false
        "classPath"        | "command"                     | false
        "reuse": "classes" | "reuse": "nothing"            | true
        "reuse": "classes" | "reuse": "levels"             | false
        "mode": "solo"     | "mode": "opti"                | false
        "mode": "solo"     | "mode": "multi"               | false
        "mode": "solo",    | ``                            | false
        "leagueLevel": 3   | "leagueLevel": 21             | false
        "leagueLevel": 3   | "leagueLevel": "3"            | false
        "leagueLevels": 4  | "leagueLevels": 21            | false
        "limitMs": 5000    | "limitMs": 0                  | false
        "1 2"              | 5                             | false
        "testIn": ["1 2", ""] | "tests": [{"testIn": ["1"]}], "criterion": "x" | false
        "testIn": ["1 2", ""] | "tests": [{"testIn": ["1", ""]}, {"testIn": []}] | true
        "testIn": ["1 2", ""] | "tests": ["1"]              | false
        "testIn": ["1 2", ""] | "tests": [{"testIn": "1"}]  | false
        "testIn": ["1 2", ""] | "tests": []                 | false
        "testIn": ["1 2", ""] | "tests": [{"testIn": ["1"]}], "testIn": ["1"]                   | false
        "lowerIsBetter": true | "lowerIsBetter": 1          | false
        "the highest"      | ""                            | false
        "the highest"      | 4                             | false
        "width": "12"      | "width": 12                   | false
        "width": "12"      | "wi=dth": "12"                | false
        "width": "12"      | "seed": "12"                  | false
        "width": "12"      | "seeds": "12"                 | true
        "width": "12"      | "width": ""                   | false
        "METADATA"         | "SCORES"                      | false
        "main": "a.Main",  | "main": " ",                  | false
        """)
    void readerAndSchemaAgree(String part, String instead, boolean valid) {
        assertTrue(ALL.contains(part), part);
        agree(ALL.replace(part, instead), valid);
    }

    @Test
    void aGameForSeveralHasAsManyPlayersAsTheSceneSays() {
        String multi = ALL.replaceFirst("\"mode.*\\],", "");
        agree(multi.replace("\"players\": 1", "\"players\": 16"), true);
        agree(multi.replace("\"players\": 1", "\"players\": 17"), false);
    }

    private static void agree(String text, boolean valid) {
        String refusal = null;
        try {
            Games.types().open(SceneReader.read(text, "s.json"));
        } catch (SceneException problem) {
            refusal = problem.getMessage();
        }
        assertEquals(valid, refusal == null, refusal);
        assertEquals(valid, Schemas.problems(Schemas.open(GAME, "scene"), text).isEmpty(), text);
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
        agree(scene, true);
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

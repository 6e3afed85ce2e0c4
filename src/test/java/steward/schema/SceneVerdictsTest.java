package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.shared.Games;
import steward.match.TestScenes;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** Scenes of every game with one part changed: the reader and the schema give the verdict that the table has. */
@Execution(ExecutionMode.CONCURRENT)
class SceneVerdictsTest {

    private static final String BETWEEN = " ~ ";

    static void agree(String game, String text, boolean valid) {
        String refusal = null;
        try {
            Games.types().open(SceneReader.read(text, "s.json"));
        } catch (SceneException problem) {
            refusal = problem.getMessage();
        }
        assertEquals(valid, refusal == null, refusal);
        assertEquals(valid, Schemas.problems(Schemas.open(game, "scene"), text).isEmpty(), text);
    }

    /** Each row: a game, a part of a scene of it, what may stand there instead, and what may not. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        pod-race | "players": 1 | "players": 1e0 | "players": 1.5
        pod-race | "name": "all" | "name": "é ☃" | "name": "a\\tb"
        pod-race | "scene.schema.json" | | 5
        pod-race | "react" | | "ignore"
        pod-race | "deadZone": 1, | | "pushOu": 1,
        pod-race | "laps": 1 | | "laps": 1, "x": 1
        pod-race | "truncate" | "truncate-snap" ~ "round-half-away" | "round"
        pod-race | "round" | "truncate-snap" |
        pod-race | "first": "velocity" | "first": "position" | "first": "drag"
        pod-race | "steps": 4 | | "steps": 1025
        pod-race | "double" | | "exact"
        guest | "players": 1 | | "players": 2 ~ "players": 0
        guest | "name": "all" | | "name": "a\\tb"
        guest | "referee" | | "referees"
        guest | "game" | | "accuracy": 1, "game" ~ "impacts": {}, "game" ~ "motion": {"drag": 1}, "game" \
         ~ "field": {"width": 9, "height": 9}, "game" ~ "time": {"firstAnswerMs": 9, "answerMs": 9}, "game"
        guest | "target/classes" | "x y" | "x\\u0000y"
        guest | ["target/classes", "lib/core.jar"] | | [] ~ "lib"
        guest | "classPath" | | "command": ["x"], "classPath" ~ "classPaths" ~ "command"
        guest | "reuse": "classes" | "reuse": "nothing" | "reuse": "levels"
        guest | "mode": "solo" | | "mode": "opti" ~ "mode": "multi"
        guest | "mode": "solo", | | NOTHING
        guest | "leagueLevel": 3 | | "leagueLevel": 21 ~ "leagueLevel": "3"
        guest | "leagueLevels": 4 | | "leagueLevels": 21
        guest | "limitMs": 5000 | | "limitMs": 0
        guest | "1 2" | | 5
        guest | "testIn": ["1 2", ""] | "tests": [{"testIn": ["1", ""]}, {"testIn": []}] \
         | "tests": [{"testIn": ["1"]}], "criterion": "x" ~ "tests": ["1"] ~ "tests": [{"testIn": "1"}] ~ "tests": [] \
         ~ "tests": [{"testIn": ["1"]}], "testIn": ["1"]
        guest | "lowerIsBetter": true | | "lowerIsBetter": 1
        guest | "the highest" | | "" ~ 4
        guest | "width": "12" | "seeds": "12" | "width": 12 ~ "wi=dth": "12" ~ "seed": "12" ~ "width": ""
        guest | "METADATA" | | "SCORES"
        guest | "main": "a.Main", | | "main": " ",
        mean-max | "winningScore": 50 | "winningScore": 1 | "winningScore": 0 ~ "winningScore": 1001
        mean-max | "maximumTurns": 200 | | "maximumTurns": 10001
        mean-max | "players": 3 | | "players": 2
        mean-max | "harvest" | | "motion": {}, "harvest" ~ "race": {}, "harvest" ~ "harvst"
        mean-max | "radius": 6000 | | "radius": 6001
        mean-max | "x": 0, | | "x": 1,
        mean-max | "type": "arena" | | "type": "ring"
        mean-max | "pushOut": 1e-5 | "pushOut": 1e-5, "maximumImpactsPerTurn": 9 | "pushOut": 2e-5
        mean-max | "minimumImpulse": 30 | | "minimumImpulse": 31
        mean-max | "x": -6000 | | "x": "left"
        mean-max | "arithmetic": "official" | "arithmetic": "exact" |
        fantastic-bits | "variant": "puzzle" | "variant": "contest" | "variant": "league"
        fantastic-bits | "maximumTurns": 200 | "maximumTurns": 1 | "maximumTurns": 10001
        fantastic-bits | "players": 2 | | "players": 3
        fantastic-bits | "match" | | "motion": {}, "match" ~ "race": {}, "match" ~ "mach"
        fantastic-bits | "width": 16000 | "width": 8000 |
        fantastic-bits | "x": 16150 | | "x": 16000
        fantastic-bits | "y": 1750 | | "y": 1751
        fantastic-bits | "radius": 300 | | "radius": 300, "restitution": 0.5
        fantastic-bits | "pushOut": 1e-5 | "pushOut": 1e-5, "maximumImpactsPerTurn": 9 | "pushOut": 2e-5
        fantastic-bits | "batchWindow": 1e-5, | | NOTHING
        fantastic-bits | "minimumImpulse": 100 | | "minimumImpulse": 101 ~ "minimumImpulse": 100, "deadZone": 1 \
         ~ "minimumImpulse": 100, "restSpeed": 1
        fantastic-bits | "arithmetic": "official" | "arithmetic": "exact" |
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 1 \
         ~ "neutral": 0, "perPlayer": 20, "radius": 1.5, "maximumTurns": 9 ~ "symmetric": true, "maximumTurns": 9 \
         | "maximumTurns": 0 ~ "maximumTurns": 1001 ~ "maximumTurns": 9, "neutral": 201 \
         ~ "maximumTurns": 9, "perPlayer": 0 ~ "maximumTurns": 9, "radius": 0.5 ~ "maximumTurns": 9, "symmetric": 1 \
         ~ "neutral": 3
        poker-chip-race | "players": 2 | "players": 4 | "players": 5 ~ "players": 1
        poker-chip-race | "chips" | "impacts": {"maximumImpactsPerTurn": 9}, "chips" | "motion": {}, "chips" \
         ~ "harvest": {}, "chips" ~ "chps" ~ "impacts": {"pushOut": 1e-5}, "chips" \
         ~ "impacts": {"minimumImpulse": 3}, "chips" ~ "impacts": {"restSpeed": 1}, "chips"
        poker-chip-race | "x": -400 | | "x": 0
        poker-chip-race | "height": 515 | | "height": 516
        poker-chip-race | "walls": "box" | | "walls": []
        poker-chip-race | "arithmetic": "official" | "arithmetic": "exact" |
        poker-chip-race | "official" } | "exact" }, "impacts": {"restSpeed": 1} |
        search-race | "by seed" | "by seed" ~ 7 ~ 704 | 703 ~ "random"
        search-race | "official": "by seed" | "points": [{"x":1,"y":2},{"x":3,"y":4}] \
         | "points": [{"x":1,"y":2},{"x":3,"y":4.5}] ~ "points": [{"x":1,"y":2}] \
         ~ "official": 7, "points": [{"x":1,"y":2},{"x":3,"y":4}] ~ "maps": 7
        search-race | "players": 1 | | "players": 2
        search-race | "maximumTurns": 600 | | "maximumTurns": 1001
        search-race | "laps": 3 | | "laps": 0
        search-race | "map" | | "impacts": {}, "map" ~ "pods": {}, "map"
        search-race | "velocity": "truncate-snap" | "velocity": "truncate" |
        search-race | "arithmetic": "official" | "arithmetic": "double" |
        """)
    void readerAndSchemaAgree(String game, String part, String accepted, String refused) {
        String scene = game.equals(Schemas.POD_RACE) ? SceneSchemaTest.ALL
            : game.equals(GuestSchemaTest.GAME) ? GuestSchemaTest.ALL : TestScenes.text(game);
        assertTrue(scene.contains(part), part);
        for (String words : accepted == null ? new String[0] : accepted.split(BETWEEN)) {
            agree(game, scene.replace(part, words), true);
        }
        for (String words : refused == null ? new String[0] : refused.split(BETWEEN)) {
            agree(game, scene.replace(part, words.replace("NOTHING", "")), false);
        }
    }
}

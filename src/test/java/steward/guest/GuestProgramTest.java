package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.shared.Games;
import steward.scene.json.SceneException;

/** The block of a referee in a scene: the places and words of refusals. */
class GuestProgramTest {

    private static final String SCENE = "{\"name\": \"s\", \"game\": \"guest\", \"players\": 2,\n \"referee\": ";

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        {"classPath": ["a"], "testIn": ["7"]} | 2:44: referee.testIn: found a test in the mode multi, expected the \
        mode solo with it
        {"classPath": ["a"], "properties": {"seed": "7"}} | 2:57: referee.properties.seed: found a seed, expected \
        none: each game has one of its own
        {"classPath": ["a"], "limit": 7} | 2:34: referee.limit: found an unknown field, expected one of "classPath", \
        "main", "reuse", "mode", "leagueLevels", "leagueLevel", "adopted", "limitMs", "testIn", "tests", \
        "criterion", "lowerIsBetter", "undetermined", "properties"; did you mean "limitMs"?
        {"command": ["a"], "limit": 7} | 2:32: referee.limit: found an unknown field, expected one of "command", \
        "adopted", "limitMs", "testIn", "tests", "criterion", "lowerIsBetter", "undetermined", "properties", \
        "leagueLevels"; did you mean "limitMs"?
        {"classPath": ["a"], "mode": "solo"} | 1:43: players: found 2, expected 1: the mode of its referee is solo
        {"classPath": ["a"], "leagueLevels": 4, "leagueLevel": 5} | 2:68: referee.leagueLevel: found 5, expected a \
        whole number 1..4
        """)
    void refusalsSayWhereAndWhatIsExpected(String referee, String refusal) {
        assertEquals("s.json:" + refusal, assertThrows(SceneException.class, () ->
            Games.types().open(SCENE + referee + "}", "s.json")).getMessage());
    }
}

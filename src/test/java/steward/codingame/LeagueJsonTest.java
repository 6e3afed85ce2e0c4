package steward.codingame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import steward.json.JsonObject;
import steward.match.MatchResult;
import steward.match.MatchResult.PlayerResult;
import steward.match.TestScenes;

/** The result as rating tools read it. */
class LeagueJsonTest {

    private static String json(long seed, MatchResult result, LeagueAttributes attributes) {
        return JsonObject.text(RatingToolJson.of(seed, result,
            result.players().stream().map(PlayerResult::fault).toArray(String[]::new), attributes)::write);
    }

    private static PlayerResult player(int rank, String fault, Map<String, String> data) {
        return new PlayerResult("x", rank, 0, fault, fault, 1, 1, 1, 1, 0, data);
    }

    @Test
    void wholeNumbersAreNumbersAndAttributesAreTexts() {
        MatchResult result = new MatchResult(9, "over", List.of(player(1, "late", Map.of("depth", "12.50")),
            player(0, null, Map.of())), Map.of("map", "a\"b", "seed", "99"));

        assertEquals("{\"ranks\":[1,0],\"errors\":[1,0],\"faults\":[\"late\",null],"
            + "\"test_data\":{\"seed\":-7,\"map\":\"a\\\"b\"},"
            + "\"player_data\":[{\"depth\":\"12.50\"},{}],\"attributes\":["
            + "{\"name\":\"map\",\"player\":null,\"turn\":null,\"value\":\"a\\\"b\"},"
            + "{\"name\":\"depth\",\"player\":0,\"turn\":null,\"value\":\"12.50\"}]}",
            json(-7, result, new LeagueAttributes()));
    }

    @Test
    void onlyWholeNumbersAreNumbers() {
        for (String[] pair : new String[][] {{"7", "7"}, {"-07", "-7"}, {"0.9", "\"0.9\""}, {"1e3", "\"1e3\""},
            {"1e999", "\"1e999\""}, {"NaN", "\"NaN\""}, {"0x10", "\"0x10\""}, {"1d", "\"1d\""}, {"", "\"\""},
            {"1 2", "\"1 2\""}}) {
            MatchResult result = new MatchResult(1, "over", List.of(player(0, null, Map.of())), Map.of("k", pair[0]));
            String json = json(1, result, new LeagueAttributes());
            assertEquals(pair[1], json.substring(json.indexOf("\"k\":") + 4, json.indexOf("},\"player_data\"")));
        }
    }

    @Test
    void dataOfTurnsIsInTheAttributesAlone() throws InterruptedException {
        LeagueAttributes attributes = new LeagueAttributes();
        MatchResult result = TextPilot.play(TestScenes.open("mad-pod-racing"), attributes, turn -> switch (turn) {
            case 1 -> "[PDATA][1] money = 5\n[PDATA] k = 1\n";
            case 2 -> "[TDATA][0] empty cells = 3\n[TDATA][70000] x = 1\n[TDATA][2]  cells=3 of 4 \nnoise";
            default -> null;
        }, 0, 3);

        assertEquals("{\"ranks\":[0,1],\"errors\":[0,1],\"faults\":[null,\"line 1 of 2: found \\\"nonsense\\\", "
            + "expected X Y and a thrust, SHIELD or BOOST; received: nonsense\\\\nnonsense\"],"
            + "\"test_data\":{\"seed\":7},"
            + "\"player_data\":[{\"k\":1},{}],\"attributes\":["
            + "{\"name\":\"k\",\"player\":0,\"turn\":null,\"value\":\"1\"},"
            + "{\"name\":\"money\",\"player\":0,\"turn\":1,\"value\":\"5\"},"
            + "{\"name\":\"cells\",\"player\":null,\"turn\":2,\"value\":\"3 of 4\"}]}", json(7, result, attributes));
    }
}

package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.AlteredBot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** A schema that accepts anything would pass every other test: here valid lines are spoilt, one field at a time. */
class RefusalsTest {

    private static List<String> frames;
    private static List<String> replay;

    @BeforeAll
    static void playMatch() {
        AlteredBot listening = new AlteredBot(new SeededBot(1, 0.5), (turn, answer) -> answer);
        replay = Recorded.of(TestScenes.open("walled-race"), 2, List.of(listening, new SeededBot(2, 0.5))).lines();
        frames = listening.sent();
    }

    private static String valid(String what) {
        return switch (what) {
            case "setup" -> frames.get(0);
            case "turn" -> frames.get(5);
            case "end" -> frames.get(frames.size() - 1);
            case "header" -> replay.get(0);
            case "result" -> replay.get(replay.size() - 1);
            default -> replay.stream().filter(line -> line.contains("\"impacts\":[{") && line.contains(",\"b\":"))
                .findFirst().orElseThrow();
        };
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "setup  | \"type\":\"setup\"       | \"type\":\"turn\"",
        "setup  | \"player\":0             | \"player\":-1",
        "setup  | \"player\":0             | \"player\":0.5",
        "setup  | \"player\":0,            | ``",
        "setup  | \"answerMs\":75          | \"answerMs\":\"75\"",
        "setup  | \"answerMs\":75          | \"answerMs\":75,\"more\":1",
        "setup  | \"laps\":3               | \"laps\":0",
        "setup  | \"drag\":0.15            | \"drag\":1.5",
        "setup  | \"walls\":true           | \"walls\":\"box\"",
        "setup  | \"podRadius\":400        | \"podRadius\":0",
        "setup  | \"checkpoints\":[        | \"checkpoints\":[5,",
        "turn   | \"turn\":5               | \"turn\":0",
        "turn   | \"lap\":0                | \"lap\":null",
        "turn   | \"nextCheckpoint\":1     | \"nextCheckpoint\":-1",
        "turn   | \"shieldTimer\":0,       | ``",
        "turn   | \"heading\":             | \"heading\":360,\"h\":",
        "turn   | \"heading\":             | \"h\":",
        "turn   | \"shieldTimer\":0        | \"shieldTimer\":5",
        "turn   | \"pods\":\\[             | \"pods\":[[],",
        "turn   | \"turnsLeft\"            | \"turnLeft\"",
        "end    | \"ranks\":\\[            | \"ranks\":[0.5,",
        "end    | \"reason\":\"            | \"reason\":5,\"r\":\"",
        "end    | \"scores\":              | \"score\":",
        "header | \"format\":3             | \"format\":4",
        "header | \"seed\":\"2\"           | \"seed\":2",
        "header | \"timeFactor\":null      | \"timeFactor\":0",
        "header | \"kind\":\"pod\"         | \"kind\":\"bumper\"",
        "header | \"owner\":0,             | ``",
        "header | \"hash\":\"[0-9a-f]      | \"hash\":\"",
        "header | \"drawing\":             | \"drawings\":",
        "header | \"hash\":               | \"h\":",
        "header | ,\"hash\":\"[0-9a-f]*\" | ``",
        "impact | ,\"hash\":\"[0-9a-f]*\" | ``",
        "impact | ,\"energy\":[-0-9.E]*   | ``",
        "impact | \"turnsLeft\":\\[[0-9,]*] | \"left\":0",
        "impact | \"thrust\":              | \"shield\":true,\"thrust\":",
        "impact | ,\"turnHash\":\"[^\"]*\" | ``",
        "impact | \"time\":0               | \"time\":1",
        "impact | \"impulse\":             | \"impuls\":",
        "impact | \"b\":                   | \"c\":",
        "impact | \"b\":                   | \"wall\":1,\"b\":",
        "impact | \"knots\":\\[\\[         | \"knots\":[[0.5,",
        "impact | \"passed\":              | \"passed\":0.5,\"p\":",
        "impact | \"answerNanos\":\\[      | \"answerNanos\":[-1,",
        "impact | \"type\":\"turn\"        | \"type\":\"result\"",
        "result | \"rank\":0               | \"rank\":-1",
        "result | \"ending\":\"[^\"]*\"    | \"ending\":\"\"",
        "result | \"name\":\"P0\"          | \"name\":null",
        "result | \"times\":               | \"time\":"})
    void spoiltLines(String what, String from, String to) {
        String schema = switch (what) {
            case "header", "impact", "result" -> "replay";
            default -> what;
        };
        String line = valid(what);
        String spoilt = line.replaceFirst(what.equals("setup") ? Pattern.quote(from) : from,
            Matcher.quoteReplacement(to));

        assertNotEquals(line, spoilt, "nothing was spoilt in " + line);
        assertEquals(List.of(), Schemas.problems(Schemas.open(schema), line));
        assertTrue(Schemas.problems(Schemas.open(schema), spoilt).size() > 0, spoilt);
    }
}

package steward.game.meanmax.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.CodecText;
import steward.game.GameAnswers;
import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.MeanMax;

/** Answers of Mean Max bots, as lines and as JSON, and the commands that a replay keeps of them. */
class MeanMaxAnswersTest extends GameAnswers<MeanMaxType.MeanMaxSetup, MeanMax> {

    MeanMaxAnswersTest() {
        super("mean-max", setup -> setup.create(7), 1);
    }

    private List<LooterCommand> commands() {
        return List.of(game.command(1, 0), game.command(1, 1), game.command(1, 2));
    }

    @Test
    void everyKindOfLineIsRead() {
        assertNull(lines("10 -20 30 go/skill\t5   -6 now/wait"));
        assertEquals(List.of(LooterCommand.move(10, -20, 30), LooterCommand.skill(5, -6), LooterCommand.WAIT),
            commands());
        assertEquals("go | now", text.message(1));
        assertNull(lines("1 2 999999999/WAIT  a b/SKILL 1 2"));
        assertEquals(LooterCommand.move(1, 2, 300), game.command(1, 0), "more power is 300");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        `1 2 `| `1 2  msg`| ` 1 2 3`| `1 2 3 `| `WAIT `| `WAIT10`| `1.0 2 3`| `+1 2 3`| `1 2 -3`| `1 2 0000000003`
        `SKILL 1`| `SKILL 1 2 `| `SKILL  `| `MOVE 1 2 3`| `１ 2 3`| ``| `1000000000 1 1`| `1 2 3x`| `--1 2 3`| `1 2 +3`
        """)
    void otherLinesAreFaultsAndLinesBeforeThemCount(String a, String b, String c, String d, String e, String f,
                                                    String g, String h, String i, String j) {
        for (String bad : List.of(a, b, c, d, e, f, g, h, i, j)) {
            codec.clearCommand(1);
            String wrong = lines("1 2 3/" + bad + "/4 5 6");
            assertTrue(wrong != null && wrong.startsWith("line 2 of 3: found "), bad + ": " + wrong);
            assertEquals(LooterCommand.move(1, 2, 3), game.command(1, 0));
            assertNull(game.command(1, 1));
            assertTrue(codec.hasPartialCommand(1));
        }
        assertEquals("found 2 lines, expected 3", lines("1 2 3/4 5 6"));
    }

    @Test
    void aTurnIsWrittenAsTheSiteDoes() {
        assertEquals("", CodecText.setup(text, 1));
        List<String> turn = turn(false).lines().toList();
        assertEquals(List.of("0", "0", "0", "0", "0", "0", Integer.toString(game.bodies().size())), turn.subList(0, 7));
        assertTrue(turn.get(7).startsWith("0 0 1 0.5 400 "), "the first looter of another player");
        assertTrue(turn.get(10).startsWith("3 0 0 0.5 400 "), "the own reaper");
        assertTrue(turn.get(13).startsWith("6 0 2 0.5 400 "));
        assertTrue(turn.get(16).matches("9 3 -1 3\\.0 [0-9]+ -?[0-9]+ -?[0-9]+ -?[0-9]+ -?[0-9]+ 1 [4-9]"),
            turn.get(16));
    }

    @Test
    void everyKindOfCommandIsReadFromJsonAndKept() {
        assertNull(json("{'looters':[{'x':1.5,'y':-2,'power':300},{'x':1e2,'y':2,'skill':true},{'wait':true}],"
            + "'message':'hello'}"));
        assertEquals(List.of(LooterCommand.move(1.5, -2, 300), LooterCommand.skill(100, 2), LooterCommand.WAIT),
            commands());
        assertEquals("hello", codec.message(1));
        assertKept("{'c':[{'x':1.5,'y':-2,'power':300},{'x':100,'y':2,'skill':true},{'wait':true}]}", false);
    }

    @Test
    void whatAFaultLeftIsKeptToo() {
        lines("1 2 3/WAIT/?");
        String kept = "{'c':[{'x':1,'y':2,'power':3},{'wait':true},null]}";
        assertKept(kept, true);
        assertEquals("looters[2]: found null, expected an object", read(kept, false));
        assertEquals("looters[2]: found an object, expected null",
            read("{\"c\":[{\"wait\":true},null,{\"wait\":true}]}", true));
        assertEquals("looters: found 3 commands, expected fewer",
            read("{\"c\":[{\"wait\":true},{\"wait\":true},{\"wait\":true}]}", true));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        `[]` | `found an array, expected an object`
        `{}` | `looters: found nothing, expected an array of 3`
        `{'looters':5}` | `looters: found 5, expected an array of 3`
        `{'looters':[{'wait':true}]}` | `looters: found 1, expected 3`
        `{'looters':[{'wait':true},{'wait':true},{'wait':true},1]}` | `looters: found more than 3, expected 3`
        `{'looters':[{'x':1,'y':2,'power':301},1,1]}` | `looters[0].power: found 301, expected a number 0..300`
        `{'looters':[{'x':1,'power':3},1,1]}` | `looters[0].y: found nothing, expected a number`
        `{'looters':[{'x':1e10,'y':2,'power':3},1,1]}` | `looters[0].x: found 1e10, expected a number -1e9..1e9`
        `{'looters':[{'x':1,'x':1,'y':2,'power':3},1,1]}` | `looters[0].x: found twice, expected once`
        `{'looters':[{'x':1,'y':2},1,1]}` | `looters[0]: found none of power, skill, wait, expected exactly one`
        `{'looters':[{'x':1,'y':2,'skill':true,'power':1},1,1]}`|`looters[0].power: found more than one of power, skill`
        `{'looters':[{'wait':true,'x':1},1,1]}` | `looters[0].x: found a number, expected nothing beside wait`
        `{'looters':[{'skill':1},1,1]}` | `looters[0].skill: found 1, expected true (or leave it out)`
        `{'looters':[{'powr':1},1,1]}` | `looters[0].powr: unknown field, expected one of power, skill`
        """)
    void wrongJsonSaysWhatIsWrong(String answer, String expected) {
        assertWrong(answer, expected);
    }
}

package steward.game.pokerchiprace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameAnswers;
import steward.game.pokerchiprace.ChipCommand;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.ChipTables;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.JsonObject;

/** Answers of bots, as lines and as JSON, and the commands that a replay keeps of them. */
class ChipAnswersTest extends GameAnswers<PokerChipRaceType.PokerChipRaceSetup, PokerChipRace> {

    ChipAnswersTest() {
        super("poker-chip-race", ChipAnswersTest::game, 1);
    }

    /** Player 1 has chips 2, 3 and 5, of which 5 is too small to push itself; 0 and 4 are neutral. */
    private static PokerChipRace game(PokerChipRaceType.PokerChipRaceSetup setup) {
        ChipTable table = ChipTables.empty(2, 10);
        table.add(ChipTable.NEUTRAL, 10, -300, 0, 1, -0.0);
        table.add(0, 20, -200, 0, 0, 0);
        table.add(1, 20, 0, 0, 0.1234565, -1e-9);
        table.add(1, 20, 100, 0, 0, 0);
        table.add(ChipTable.NEUTRAL, 5, 200, 0, 0, 0);
        table.add(1, 5, 300, 0, 0, 0);
        return ChipTables.game(setup, table, -1, -1);
    }

    @Test
    void aTurnIsWrittenAsTheSiteDoes() {
        assertEquals("""
            1
            3
            6
            2 1 20.000000 400.000000 257.500000 0.123457 -0.000000
            3 1 20.000000 500.000000 257.500000 0.000000 0.000000
            5 1 5.000000 700.000000 257.500000 0.000000 0.000000
            0 -1 10.000000 100.000000 257.500000 1.000000 -0.000000
            1 0 20.000000 200.000000 257.500000 0.000000 0.000000
            4 -1 5.000000 600.000000 257.500000 0.000000 0.000000
            """, turn(true));
    }

    @Test
    void everyKindOfLineIsRead() {
        assertEquals(3, text.answerLines(1));
        assertNull(lines("1e3 0x1p9 go/wait  a b/what ever"));
        assertEquals(new ChipCommand(600, 254.5), game.command(1, 0));
        assertEquals(ChipCommand.WAIT, game.command(1, 1));
        assertEquals(ChipCommand.WAIT, game.command(1, 2), "a small chip's words need not be numbers");
        assertEquals("go | a b", text.message(1));
        assertNull(lines("3f -.5/Wait/WAIT"));
        assertEquals(new ChipCommand(-397, -258), game.command(1, 0));
        assertNull(text.message(1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"WAIT ", "1 2 ", " 1 2", "1  2", "1", "", "WAITx", "waitx 3", "NaN 3", "Infinity 1",
        "1e999 1", "1,5 2", "1 WAIT", "1\t2", "1_0 2", "１ 3"})
    void otherLinesAreFaultsAndLinesBeforeThemCount(String bad) {
        String wrong = lines("1 2/" + bad + "/WAIT");
        assertNotNull(wrong);
        assertTrue(wrong.startsWith("line 2 of 3: found \""), wrong);
        assertEquals(new ChipCommand(-399, -255.5), game.command(1, 0));
        assertNull(game.command(1, 1));
        assertTrue(codec.hasPartialCommand(1));
        assertEquals("found 2 lines, expected 3", lines("WAIT/WAIT"));
    }

    @Test
    void everyKindOfCommandIsReadFromJsonAndKept() {
        assertNull(json("{'chips':[{'x':1.5,'y':-2},{'wait':true},{'x':1e2,'y':-0.0}],'message':'hello'}"));
        assertEquals("hello", codec.message(1));
        assertEquals(new ChipCommand(1.5, -2), game.command(1, 0));
        assertKept("{'c':[{'x':1.5,'y':-2},{'wait':true},{'x':100,'y':-0.0}]}", false);
    }

    @Test
    void whatAFaultLeftIsKeptToo() {
        lines("1e300 2/WAIT 4/1 WAIT");
        lines("1e300 2/?/WAIT");
        assertEquals("{'c':[{'x':1.0E300,'y':-255.5},{'wait':true},{'wait':true}]}", kept(),
            "the game forgets only what was played");
        codec.clearCommand(1);
        lines("1e300 2/?/WAIT");
        String kept = "{'c':[{'x':1.0E300,'y':-255.5},null,null]}";
        assertKept(kept, true);
        assertEquals("chips[1]: found null, expected an object", read(kept, false));
        assertEquals("chips[2]: found an object, expected null",
            read("{\"c\":[{\"wait\":true},null,{\"wait\":true}]}", true));
        assertEquals("chips: found 3 commands, expected fewer",
            read("{\"c\":[{\"wait\":true},{\"wait\":true},{\"wait\":true}]}", true));
    }

    @Test
    void aFrameNamesTheOwnChips() {
        String turn = new String(JsonObject.of(out -> codec.writeTurn(out, 1)), StandardCharsets.UTF_8);
        assertTrue(turn.startsWith("{\"own\":[2,3,5],\"chips\":[{\"id\":0,\"radius\":10,\"x\":-300,\"y\":0,\"vx\":1,"
            + "\"vy\":-0.0},{\"id\":1,\"player\":0,\"radius\":20,"), turn);
        assertEquals(List.of(2, 3, 5),
            List.of(game.table().ownId(1, 0), game.table().ownId(1, 1), game.table().ownId(1, 2)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        `[]` | `found an array, expected an object`
        `{}` | `chips: found nothing, expected an array of 3`
        `{'chips':5}` | `chips: found 5, expected an array of 3`
        `{'chips':[{'wait':true}]}` | `chips: found 1, expected 3`
        `{'chips':[{'wait':true},{'wait':true},{'wait':true},1]}` | `chips: found more than 3, expected 3`
        `{'chips':[{'x':1},1,1]}` | `chips[0].y: found nothing, expected a number (or wait alone)`
        `{'chips':[{'x':1e10,'y':2},1,1]}` | `chips[0].x: found 1e10, expected a number -1e9..1e9`
        `{'chips':[{'x':1,'x':1,'y':2},1,1]}` | `chips[0].x: found twice, expected once`
        `{'chips':[{'wait':true,'x':1},1,1]}` | `chips[0].x: found a number, expected nothing beside wait`
        `{'chips':[{'wait':1},1,1]}` | `chips[0].wait: found 1, expected true (or leave it out)`
        `{'chips':[{'z':1},1,1]}` | `chips[0].z: unknown field, expected one of wait, x, y`
        `{'chips':[],'chips':[]}` | `chips: found 0, expected 3`
        """)
    void wrongJsonSaysWhatIsWrong(String answer, String expected) {
        assertWrong(answer, expected);
    }
}

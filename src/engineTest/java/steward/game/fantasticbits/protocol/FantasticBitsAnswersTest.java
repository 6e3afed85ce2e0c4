package steward.game.fantasticbits.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.CodecText;
import steward.game.GameAnswers;
import steward.game.GameSetup;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.WizardCommand;
import steward.match.TestScenes;

/** Answers of Fantastic Bits bots, as lines and as JSON, and the commands that a replay keeps of them. */
class FantasticBitsAnswersTest extends GameAnswers<FantasticBitsType.FantasticBitsSetup, FantasticBits> {

    FantasticBitsAnswersTest() {
        super("fantastic-bits", setup -> setup.create(7), 1);
    }

    private List<WizardCommand> commands() {
        return List.of(game.command(1, 0), game.command(1, 1));
    }

    @Test
    void everyKindOfLineIsRead() {
        game.bodies().columns[Pitch.HELD][3] = 4;
        assertNull(lines("MOVE 10\t-20   150 go/THROW -3 4 500  now"));
        assertEquals(List.of(WizardCommand.move(10, -20, 150), WizardCommand.toss(-3, 4, 500)), commands());
        assertEquals("go | now", text.message(1));
        assertNull(lines("ACCIO 4/FLIPENDO 0 away"));
        assertEquals(List.of(WizardCommand.cast(Spell.ACCIO, 4), WizardCommand.cast(Spell.FLIPENDO, 0)), commands());
    }

    @ParameterizedTest
    @ValueSource(strings = {"MOVE 1 2 151", "MOVE 1 2", "MOVE  1 2 3", "move 1 2 3", "MOVE 1 2 3 ", "MOVE 1.0 2 3",
        "MOVE 1 2 -3", "MOVE 123456789 2 3", "THROW 1 2 3", "WAIT", "", "ACCIO", "ACCIO 1000", "ACCIO 3",
        "OBLIVIATE 4", "FLIPENDO 2", "PETRIFICUS -1", "WINGARDIUM 4", "ACCIO  4"})
    void otherLinesAreFaultsAndTheLineBeforeCounts(String bad) {
        String wrong = lines("MOVE 1 2 3/" + bad);
        assertTrue(wrong != null && wrong.startsWith("line 2 of 2: "), bad + ": " + wrong);
        assertTrue(wrong.contains("found ") && wrong.contains(", expected "), wrong);
        assertEquals(WizardCommand.move(1, 2, 3), game.command(1, 0));
        assertNull(game.command(1, 1));
        assertTrue(codec.hasPartialCommand(1));
    }

    @Test
    void aTurnIsWrittenAsEachVariantOfTheSiteDoes() {
        List<String> puzzle = turn(true).lines().toList();
        int entities = game.pitch().entities();
        assertEquals(List.of("1", "0 0", "0 0", "" + entities, "2 WIZARD 15000 2250 0 0 0", "3 WIZARD 15000 5250 0 0 0",
            "0 OPPONENT_WIZARD 1000 5250 0 0 0"), puzzle.subList(0, 7));
        assertEquals((entities - 1) + " BLUDGER 8550 3750 0 0 -1", puzzle.get(puzzle.size() - 1));
        GameSetup contest = TestScenes.open("fantastic-bits-contest");
        List<String> lines = CodecText.turn(contest.textCodec(contest.create(7)).orElseThrow(), 1).lines().toList();
        assertEquals("" + entities, lines.get(0));
        assertEquals((entities - 1) + " BLUDGER 8550 3750 0 0 0", lines.get(lines.size() - 1));
    }

    @Test
    void everyKindOfCommandIsReadFromJsonAndKept() {
        game.bodies().columns[Pitch.HELD][2] = 4;
        assertNull(json("{'wizards':[{'x':1.5,'y':-2,'throw':500},{'spell':'accio','target':5}],'message':'hello'}"));
        assertEquals(List.of(WizardCommand.toss(1.5, -2, 500), WizardCommand.cast(Spell.ACCIO, 5)), commands());
        assertEquals("hello", codec.message(1));
        assertKept("{'c':[{'x':1.5,'y':-2,'throw':500},{'spell':'accio','target':5}]}", false);
    }

    /** Another bot in the recorded one's place: the snaffle that it had is not there. */
    @Test
    void aRecordedCommandThatTheStateDoesNotAllowDoesNothing() {
        double x = game.bodies().x[2];
        assertNull(read("{\"c\":[{\"x\":1,\"y\":2,\"throw\":500},{\"x\":15000,\"y\":0,\"power\":150}]}", false));
        game.play();
        assertEquals(x, game.bodies().x[2]);
        assertEquals(5100, game.bodies().y[3]);
        assertEquals("wizards[0].throw: found 501, expected a number 0..500",
            read("{\"c\":[{\"x\":1,\"y\":2,\"throw\":501},{\"x\":1,\"y\":2,\"power\":150}]}", false));
    }

    @Test
    void whatAFaultLeftIsKeptToo() {
        lines("MOVE 1 2 3/?");
        String kept = "{'c':[{'x':1,'y':2,'power':3},null]}";
        assertKept(kept, true);
        assertEquals("wizards[1]: found null, expected an object", read(kept, false));
        assertEquals("wizards: found 2 commands, expected fewer",
            read("{\"c\":[{\"x\":1,\"y\":2,\"power\":3},{\"x\":1,\"y\":2,\"power\":3}]}", true));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        `[]` | `found an array, expected an object`
        `{}` | `wizards: found nothing, expected an array of 2`
        `{'wizards':5}` | `wizards: found 5, expected an array of 2`
        `{'wizards':[{'x':1,'y':2,'power':3}]}` | `wizards: found 1, expected 2`
        `{'wizards':[{'x':1,'y':2,'power':3},{'x':1,'y':2,'power':3},1]}` | `wizards: found more than 2, expected 2`
        `{'wizards':[{'x':1,'y':2,'power':151},1]}` | `wizards[0].power: found 151, expected a number 0..150`
        `{'wizards':[{'x':1,'y':2,'throw':501},1]}` | `wizards[0].throw: found 501, expected a number 0..500`
        `{'wizards':[{'x':1,'y':2,'throw':5},1]}` | `wizards[0]: found a throw without a snaffle in hand, expected`
        `{'wizards':[{'x':1,'power':3},1]}` | `wizards[0].y: found nothing, expected a number`
        `{'wizards':[{'x':1e10,'y':2,'power':3},1]}` | `wizards[0].x: found 1e10, expected a number -1e9..1e9`
        `{'wizards':[{'x':1,'x':1,'y':2,'power':3},1]}` | `wizards[0].x: found twice, expected once`
        `{'wizards':[{'x':1,'y':2},1]}` | `wizards[0]: found none of power, throw, spell, expected exactly one`
        `{'wizards':[{'x':1,'y':2,'power':1,'spell':'accio'},1]}` | `wizards[0].spell: found more than one of power, t`
        `{'wizards':[{'spell':'acio','target':4},1]}` | `wizards[0].spell: found "acio", expected one of accio, flipen`
        `{'wizards':[{'spell':'accio'},1]}` | `wizards[0].target: found nothing, expected a number`
        `{'wizards':[{'spell':'accio','target':4.5},1]}` | `wizards[0].target: found 4.5, expected the id of an entity`
        `{'wizards':[{'spell':'accio','target':2},1]}` | `wizards[0].target: found 2, a wizard, expected a bludger or a`
        `{'wizards':[{'spell':'accio','target':4,'x':1},1]}` | `wizards[0].x: found a number, expected nothing beside`
        `{'wizards':[{'powr':1},1]}` | `wizards[0].powr: unknown field, expected one of power, spell`
        """)
    void wrongJsonSaysWhatIsWrong(String answer, String expected) {
        assertWrong(answer, expected);
    }
}

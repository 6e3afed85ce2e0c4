package steward.game.fantasticbits.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameJson;
import steward.game.TextCodec;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.WizardCommand;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;

/** Answers of Fantastic Bits bots, as lines and as JSON, and the commands that a replay keeps of them. */
class FantasticBitsAnswersTest {

    private final FantasticBitsType.FantasticBitsSetup setup = open("fantastic-bits");
    private final FantasticBits game = setup.create(7);
    private final GameJson codec = setup.codec(game);
    private final TextCodec text = setup.textCodec(game).orElseThrow();

    private static FantasticBitsType.FantasticBitsSetup open(String scene) {
        return new FantasticBitsType().open(SceneReader.read(SceneFiles.load(scene), null));
    }

    private String lines(String lines) {
        byte[] bytes = lines.replace('/', '\n').getBytes(StandardCharsets.UTF_8);
        return text.readAnswer(1, bytes, bytes.length);
    }

    private String json(String line) {
        byte[] bytes = line.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
        return codec.readAnswer(1, bytes, bytes.length);
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
        StringBuilder out = new StringBuilder();
        text.writeSetup(out, 1);
        text.writeTurn(out, 1);
        List<String> puzzle = out.toString().lines().toList();
        int entities = game.pitch().entities();
        assertEquals(List.of("1", "0 0", "0 0", "" + entities, "2 WIZARD 15000 2250 0 0 0", "3 WIZARD 15000 5250 0 0 0",
            "0 OPPONENT_WIZARD 1000 5250 0 0 0"), puzzle.subList(0, 7));
        assertEquals((entities - 1) + " BLUDGER 8550 3750 0 0 -1", puzzle.get(puzzle.size() - 1));
        FantasticBitsType.FantasticBitsSetup contest = open("fantastic-bits-contest");
        FantasticBits other = contest.create(7);
        StringBuilder shorter = new StringBuilder();
        contest.textCodec(other).orElseThrow().writeTurn(shorter, 1);
        List<String> lines = shorter.toString().lines().toList();
        assertEquals("" + entities, lines.get(0));
        assertEquals((entities - 1) + " BLUDGER 8550 3750 0 0 0", lines.get(lines.size() - 1));
    }

    @Test
    void everyKindOfCommandIsReadFromJsonAndKept() {
        game.bodies().columns[Pitch.HELD][2] = 4;
        assertNull(json("{'wizards':[{'x':1.5,'y':-2,'throw':500},{'spell':'accio','target':5}],'message':'hello'}"));
        assertEquals(List.of(WizardCommand.toss(1.5, -2, 500), WizardCommand.cast(Spell.ACCIO, 5)), commands());
        assertEquals("hello", codec.message(1));
        String kept = kept();
        assertEquals("{\"c\":[{\"x\":1.5,\"y\":-2,\"throw\":500},{\"spell\":\"accio\",\"target\":5}]}", kept);
        codec.clearCommand(1);
        assertNull(read(kept, false));
        assertEquals(kept, kept());
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

    private String kept() {
        return new String(JsonObject.of(out -> {
            out.writeName("c");
            codec.writeCommand(out, 1);
        }), StandardCharsets.UTF_8);
    }

    private String read(String kept, boolean partial) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(),
                kept.getBytes(StandardCharsets.UTF_8))) {
            in.nextToken();
            in.nextToken();
            in.nextToken();
            return partial ? codec.readPartialCommand(in, 1) : codec.readCommand(in, 1);
        }
    }

    @Test
    void whatAFaultLeftIsKeptToo() {
        lines("MOVE 1 2 3/?");
        String kept = kept();
        assertEquals("{\"c\":[{\"x\":1,\"y\":2,\"power\":3},null]}", kept);
        codec.clearCommand(1);
        assertEquals("wizards[1]: found null, expected an object", read(kept, false));
        assertNull(read(kept, true));
        assertEquals(kept, kept());
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
        String wrong = json(answer);
        assertTrue(wrong != null && wrong.startsWith(expected), wrong);
    }
}

package steward.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static steward.match.Refusal.refused;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.game.BotStub.Command;
import steward.game.BotStub.Field;
import steward.game.BotStub.Input;
import steward.game.BotStub.Kind;

/** Declarations of input and answers. */
class BotStubTest {

    @Test
    void aFieldHasANameAKeyAndAKind() {
        assertEquals(List.of(new Field("id", "id", Kind.INT), new Field("next", "nextCheckpoint", Kind.REAL),
            new Field("kind", "kind", Kind.WORD)),
            Input.values("id:int  next=nextCheckpoint:real kind:word").fields());
        refused("found the field \"x\", expected NAME:KIND or NAME=KEY:KIND with int, real or word as KIND",
            () -> Input.values("id:int x"));
    }

    @Test
    void aNameIsOneInAllLanguages() {
        for (String name : List.of("class", "lambda", "auto", "let", "command", "nearest", "first name", "1st", "",
                "each")) {
            refused("found the name \"" + name
                + "\", expected letters and digits that are no word of Python, Java, C++ or JavaScript",
                () -> Command.each(name, "pods", ""));
        }
        assertEquals("discs", Input.objects("discs=bodies", "Disc", "x:real").name());
    }

    @Test
    void aTypeHasOneForm() {
        List<Input> two = List.of(Input.lines("pods", "Pod", "2", "x:int"), Input.lines("others", "Pod", "2", "y:int"));
        refused("found two forms of the type Pod, expected one",
            () -> new BotStub(List.of(), two, "", List.of(), List.of()));
    }
}

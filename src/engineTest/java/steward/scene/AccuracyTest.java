package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.physics.Arithmetic;
import steward.physics.Contacts;
import steward.physics.event.EventAdvance;
import steward.physics.event.QueueAdvance;
import steward.physics.event.StepAdvance;
import steward.scene.json.SceneException;

/** The ladder by its names: in a scene, and in the short form of a command line. */
class AccuracyTest {

    @ParameterizedTest
    @CsvSource({"event/official, event/official", "event/double, event/double", "event/compensated, event/compensated",
        "event/exact, event/exact", "official, event/official", "double, event/double", "exact, event/exact",
        "compensated, event/compensated", "event, event/double", "step/1, step/1", "step/1024, step/1024",
        "step/7, step/7", "step/0004, step/4"})
    void aShortFormIsRead(String text, String rung) {
        assertEquals(rung, Accuracy.parse(text).text());
        assertEquals(Accuracy.parse(rung), Accuracy.parse(text));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "exakt | event/ARITHMETIC, step/K or one of \"official\", \"double\", \"compensated\", \"exact\"; "
            + "did you mean \"exact\"?",
        "evnt/double | event/ARITHMETIC, step/K or one of \"official\", \"double\", \"compensated\", \"exact\"; "
            + "did you mean \"event\"?",
        "event/doubel | event/ and one of \"official\", \"double\", \"compensated\", \"exact\"; "
            + "did you mean \"double\"?",
        "event/ | event/ and one of \"official\", \"double\", \"compensated\", \"exact\"",
        "step | step/ and a whole number 1..1024",
        "step/0 | step/ and a whole number 1..1024",
        "step/1025 | step/ and a whole number 1..1024",
        "step/-1 | step/ and a whole number 1..1024",
        "step/2.5 | step/ and a whole number 1..1024",
        "step/99999999999 | step/ and a whole number 1..1024",
        "step/exact | step/ and a whole number 1..1024",
        "`` | event/ARITHMETIC, step/K or one of \"official\", \"double\", \"compensated\", \"exact\""})
    void anythingElseIsRefused(String text, String expected) {
        assertEquals("accuracy: found \"" + text + "\", expected " + expected,
            assertThrows(IllegalArgumentException.class, () -> Accuracy.parse(text)).getMessage());
    }

    @Test
    void theLadderGoesFromOneStepToExact() {
        assertEquals("[step/1, step/2, step/4, step/8, step/16, step/32, step/64, step/128, step/256, step/512, "
            + "step/1024, event/official, event/double, event/compensated, event/exact]",
            Accuracy.ladder().toString());
        for (Accuracy rung : Accuracy.ladder()) {
            assertEquals(rung, Accuracy.parse(rung.text()));
        }
    }

    @Test
    void whatDoesNotGoTogetherIsNoRung() {
        assertThrows(IllegalArgumentException.class, () -> new Accuracy(Accuracy.Way.EVENT, 4, Arithmetic.DOUBLE));
        assertThrows(IllegalArgumentException.class, () -> new Accuracy(Accuracy.Way.STEP, 4, Arithmetic.EXACT));
        assertThrows(IllegalArgumentException.class, () -> Accuracy.step(0));
        assertThrows(IllegalArgumentException.class, () -> Accuracy.step(1025));
    }

    @Test
    void aSceneNamesItsRungAndThePlanHasItsAdvance() {
        for (Accuracy rung : Accuracy.ladder()) {
            boolean steps = rung.way() == Accuracy.Way.STEP;
            Scene scene = scene("\"advance\": \"" + rung.way().text() + "\", \"arithmetic\": \""
                + rung.arithmetic().text() + "\"" + (steps ? ", \"steps\": " + rung.steps() : ""));
            assertEquals(rung, scene.accuracy());
            Plan plan = Plan.of(scene, new Contacts(1), 1, false, List.of());
            assertEquals(steps ? StepAdvance.class : EventAdvance.class, plan.advance(null).getClass());
            Plan crowd = Plan.of(scene, new Contacts(1), 1, false, 99, List.of());
            assertEquals(steps ? StepAdvance.class : QueueAdvance.class, crowd.advance(null).getClass());
        }
    }

    @Test
    void stepsBelongToTheAdvanceByStepsAlone() {
        Scene scene = scene("\"advance\": \"event\", \"arithmetic\": \"double\", \"steps\": 4");
        assertEquals("s.json:2:60: accuracy.steps: found an unknown field, expected one of \"advance\", \"arithmetic\"",
            assertThrows(SceneException.class, () -> scene.root().done()).getMessage());
    }

    private static Scene scene(String accuracy) {
        return SceneReader.read("""
            { "name": "s", "game": "g", "players": 2, "time": { "firstAnswerMs": 1000, "answerMs": 75 },
              "accuracy": {""" + accuracy + "} }", "s.json");
    }
}

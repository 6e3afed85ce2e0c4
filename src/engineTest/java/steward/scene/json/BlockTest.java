package steward.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** A block as a game meets it when it reads its own blocks. */
class BlockTest {

    private static final double INFINITE = Double.POSITIVE_INFINITY;

    @Test
    void numbersComeAsTheyAreWritten() {
        Block block = block("{ 'a': 1e-5, 'b': -2.50, 'c': 1e3, 'd': 'infinite' }");
        assertEquals(1e-5, block.positive("a"));
        assertEquals(-2.5, block.number("b", -2.5, -2.5));
        assertEquals(1000, block.integer("c", 1, 1000));
        assertEquals(1000, block.mass("c"));
        assertEquals(INFINITE, block.mass("d"));
        block.done();
    }

    @Test
    void absenceHasAValueOnlyWhereOneIsGiven() {
        Block block = block("{}");
        assertEquals(7, block.number("a", 0, 1, 7));
        assertEquals(8, block.integer("a", 0, 1, 8));
        assertTrue(block.flag("a", true));
        assertEquals("none", block.choice("a", Map.of("x", "y"), "none"));
        assertEquals(Optional.empty(), block.optionalBlock("a"));
        refused("a: found nothing, expected true or false", () -> block.flag("a"));
        refused("a: found nothing, expected an array of objects", () -> block.blocks("a"));
    }

    @Test
    void presenceIsCheckedEvenWhereAbsenceIsFine() {
        Block block = block("{ 'a': 2, 'b': null }");
        refused("a: found 2, expected a number 0..1", () -> block.number("a", 0, 1, 0.5));
        refused("a: found 2, expected a whole number 0..1", () -> block.integer("a", 0, 1, 0));
        refused("a: found 2, expected true or false", () -> block.flag("a", true));
        refused("a: found 2, expected \"x\"", () -> block.choice("a", Map.of("x", 1), 1));
        refused("b: found null, expected an object", () -> block.optionalBlock("b"));
        refused("b: found null, expected true or false", () -> block.flag("b"));
    }

    @Test
    void rangesAreSaidAsPlainlyAsPossible() {
        Block block = block("{ 'a': -9e99 }");
        refused("a: found -9e99, expected a number -1.5..1e-5", () -> block.number("a", -1.5, 1e-5));
        refused("a: found -9e99, expected a number of at least 0", () -> block.number("a", 0, INFINITE));
        refused("a: found -9e99, expected a number above 0", () -> block.positive("a"));
        refused("a: found -9e99, expected a number above 0 or \"infinite\"", () -> block.mass("a"));
        refused("b: found nothing, expected a number of at most 3", () -> block.number("b", -INFINITE, 3));
        refused("b: found nothing, expected a finite number", () -> block.number("b", -INFINITE, INFINITE));
    }

    @Test
    void aNumberTooSmallToTellFromZeroIsNotAboveIt() {
        refused("a: found 1e-999, expected a number above 0", () -> block("{ 'a': 1e-999 }").positive("a"));
    }

    @Test
    void massesAreNoOtherTexts() {
        refused("a: found the text \"infinity\", expected a number above 0 or \"infinite\"",
            () -> block("{ 'a': 'infinity' }").mass("a"));
    }

    @Test
    void alternativesCanBeToldApart() {
        Block block = block("{ 'text': 'x', 'array': [], 'block': {} }");
        assertTrue(block.isText("text") && block.isArray("array") && block.isBlock("block") && block.has("text"));
        assertFalse(block.isText("array") || block.isArray("block") || block.isBlock("text") || block.has("none"));
        block.done();
    }

    @Test
    void choicesAreListedInTheOrderOfALinkedMapOtherwiseSorted() {
        Block block = block("{ 'a': 'zorro' }");
        Map<String, Integer> linked = new LinkedHashMap<>();
        linked.put("zero", 0);
        linked.put("one", 1);
        refused("a: found \"zorro\", expected one of \"zero\", \"one\"", () -> block.choice("a", linked));
        refused("a: found \"zorro\", expected one of \"one\", \"zero\"",
            () -> block.choice("a", Map.of("zero", 0, "one", 1)));
        linked.put("zorro", 2);
        assertEquals(2, block.choice("a", linked));
    }

    @Test
    void objectsInArraysKnowTheirPath() {
        Block block = block("{ 'maps': [ {}, 5 ] , 'none': [] }");
        assertEquals("", block.path());
        assertEquals(List.of(), block.blocks("none"));
        refused("maps[1]: found 5, expected an object", () -> block.blocks("maps"));
        Block nested = block("{ 'maps': [ { 'points': [ { 'x': 1 }, { 'x': 'two' } ] } ] }");
        Block point = nested.blocks("maps").get(0).blocks("points").get(1);
        assertEquals("maps[0].points[1]", point.path());
        refused("maps[0].points[1].x: found the text \"two\", expected a number above 0", () -> point.positive("x"));
    }

    @Test
    void theSameObjectIsTheSameBlockForEveryReader() {
        Block block = block("{ 'a': { 'b': 1, 'c': 2 } }");
        block.block("a").positive("b");
        block.block("a").positive("c");
        block.done();
    }

    @Test
    void fieldsNobodyAskedForAreRefusedAtTheirNames() {
        Block block = block("{ 'a': { 'mass': 1, 'raduis': 2 } }");
        block.block("a").positive("mass");
        block.block("a").number("radius", 0, 1, 1);
        refusedAt("1:21: a.raduis: found an unknown field, expected one of \"mass\", \"radius\"; did you mean "
            + "\"radius\"?", block::done);
        refusedAt("1:3: a: found an unknown field, expected no fields", () -> block("{ 'a': 1 }").done());
    }

    @Test
    void readersAddErrorsOfTheirOwn() {
        Block block = block("{ 'list': [] }");
        assertEquals("s.json:1:11: list: found 0 maps, expected at least 1",
            block.error("list", "0 maps", "at least 1").getMessage());
        assertEquals("s.json:1:1: none: found nothing, expected a list",
            block.error("none", "nothing", "a list").getMessage());
        assertEquals("s.json:1:1: found all, expected some", block.error("all", "some").getMessage());
    }

    @Test
    void refusalsOfConstructorsAreLocatedAtTheFieldTheyName() {
        Block block = block("{ 'a': 1.50 }");
        block.has("a");
        assertEquals("s.json:1:8: a: found 1.50, expected 1",
            block.error(new IllegalArgumentException("thing: a 1.5, expected 1")).getMessage());
        assertEquals("s.json:1:1: found b 1.5, expected 1",
            block.error(new IllegalArgumentException("b 1.5, expected 1")).getMessage());
        assertEquals("s.json:1:1: found nonsense, expected values that go together",
            block.error(new IllegalArgumentException("nonsense")).getMessage());
    }

    @Test
    void whatIsFoundIsShownShort() {
        Block block = block("{ 'a': '" + "x".repeat(100) + "', 'b': 'tab\\there', 'c': [ 1 ], 'd': {} }");
        refused("a: found the text \"" + "x".repeat(60) + "...\", expected a number above 0",
            () -> block.positive("a"));
        refused("b: found the text \"tab?here\", expected a number above 0", () -> block.positive("b"));
        refused("c: found an array, expected a number above 0", () -> block.positive("c"));
        refused("d: found an object, expected a number above 0", () -> block.positive("d"));
    }

    private static void refused(String message, Executable reading) {
        String found = assertThrows(SceneException.class, reading).getMessage();
        assertEquals(message, found.replaceFirst("^s\\.json:1:\\d+: ", ""));
    }

    private static void refusedAt(String message, Executable reading) {
        assertEquals("s.json:" + message, assertThrows(SceneException.class, reading).getMessage());
    }

    private static Block block(String text) {
        return new Block("s.json", "", JsonTree.read(text.replace('\'', '"'), "s.json", "a scene"));
    }
}

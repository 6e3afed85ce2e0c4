package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Templates, by the rules of Mustache. */
class SourceTemplateTest {

    @Test
    void aListIsWrittenForEachAndKnowsItsLast() {
        assertEquals("f(a, b)", SourceTemplate.render("f({{#items}}{{name}}{{^last}}, {{/last}}{{/items}})",
            Map.of("items", List.of(Map.of("name", "a"), Map.of("name", "b")))));
    }

    @Test
    void aMarkAloneOnItsLineLeavesNone() {
        String text = "one\n  {{#yes}}\ntwo {{word}}\n{{/yes}}\n{{^yes}}\nno\n{{/yes}}\nthree";
        assertEquals("one\ntwo W\nthree", SourceTemplate.render(text, Map.of("yes", true, "word", "W")));
        assertEquals("one\nno\nthree", SourceTemplate.render(text, Map.of("yes", false, "word", "W")));
    }

    @Test
    void theInnermostValueCountsAndSectionsOfOneNameLieInEachOther() {
        assertEquals("[in][out]", SourceTemplate.render("{{#a}}{{#a}}[{{x}}]{{/a}}{{/a}}[{{x}}]",
            Map.of("x", "out", "a", List.of(Map.of("x", "in", "a", "there")))));
    }

    @Test
    void whatIsMissingIsNamed() {
        assertEquals("found no value of {{name}}, expected one",
            assertThrows(IllegalStateException.class, () -> SourceTemplate.render("{{name}}", Map.of())).getMessage());
        assertEquals("found no end of {{#name}}, expected {{/name}}", assertThrows(IllegalStateException.class,
            () -> SourceTemplate.render("{{#name}}", Map.of())).getMessage());
    }
}

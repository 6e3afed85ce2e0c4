package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class PageScriptTest {

    private static final String FOLDER = "/steward/replay/page/script/";

    @Test
    void modulesStandInTheOrderOfTheirImportsEachOnce() {
        assertEquals("(() => {\n'use strict';\nconst base = 1;\n\n\nconst left = base + 1;\n\n\n"
            + "const right = base + 2;\n\n\n"
            + "window.sum = left + right;\n\n})();\n", PageScript.of(FOLDER + "top.js", null));
    }

    @Test
    void aCircleIsRefused() {
        assertTrue(problem("circle.js").contains("in a circle"));
    }

    @Test
    void aNameThatIsDeclaredTwiceIsRefused() {
        assertTrue(problem("twice.js").endsWith("base is declared in " + FOLDER + "base.js, too"), problem("twice.js"));
    }

    @Test
    void aFormThatIsNotReadIsRefused() {
        assertTrue(problem("default.js").contains("found 'export default 1;'"));
    }

    @Test
    void aMissingModuleIsNamed() {
        assertTrue(problem("missing.js").contains("missing.js is missing"));
    }

    private static String problem(String module) {
        return assertThrows(IllegalStateException.class, () -> PageScript.of(FOLDER + module, null)).getMessage();
    }

    /** Whoever sends a page by mail or opens it on a phone waits for these bytes. */
    @Test
    void aPageWithoutAReplayHasAtMost310Kilobytes() {
        int size = ReplayPage.live("t", "feed", null).length;
        assertTrue(size <= 310_000, () -> size + " bytes");
    }
}

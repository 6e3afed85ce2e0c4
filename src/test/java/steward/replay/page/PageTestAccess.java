package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The page, asked by axe: light and dark, wide and narrow, while it goes on and at its end. */
@Tag("browser")
class PageTestAccess {

    private static final String AXE = "/META-INF/resources/webjars/axe-core/4.6.3/axe.min.js";

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"true, 1280, 720", "false, 1280, 720", "true, 500, 844", "false, 500, 844"})
    void axeFindsNothing(boolean isDark, int width, int height) throws IOException {
        try (PageTestBrowser browser = PageTestBrowser.start(folder.resolve("profile"))) {
            browser.size(width, height);
            browser.prefer(isDark, true);
            browser.open(new PageTestPages(folder).page(PageTestRaces.play(PageTestRaces.scene("duel"), 5), "Duel"),
                "#t=9.5");
            assertEquals(List.of(), violations(browser));
            browser.run("steward.seek(steward.lastTurn())");
            assertEquals(List.of(), violations(browser));
        }
    }

    /** What axe finds wrong with the page that is open: the rule, and where. */
    @SuppressWarnings("unchecked")
    public static List<String> violations(PageTestBrowser browser) throws IOException {
        try (InputStream in = PageTestAccess.class.getResourceAsStream(AXE)) {
            browser.run(new String(in.readAllBytes(), StandardCharsets.UTF_8) + ";window.axe = axe;");
        }
        return (List<String>) browser.run("""
            return axe.run(document, { resultTypes: ['violations'] }).then(found => found.violations.flatMap(
              ({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target}`)));
            """);
    }
}

package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.match.TestSize;

/** The page inside another one: as a file in a frame, locked up as notebooks do it, and as a text in one. */
class PageTestFrame extends PageTestCase {

    private static Path page;

    @BeforeAll
    static void play() {
        page = pages.page(PageTestRaces.play(PageTestRaces.scene("duel"), 5), "Duel");
    }

    static Stream<String> kinds() {
        return Stream.of("sandbox", "file", "text").limit(TestSize.of(1, 3));
    }

    @ParameterizedTest
    @MethodSource("kinds")
    @Tag("sized")
    void behavesInsideAnotherPage(String kind) throws IOException {
        String frame = switch (kind) {
            case "file" -> "src=\"" + page.getFileName() + "#t=7.25\"";
            case "sandbox" -> "sandbox=\"allow-scripts\" src=\"" + page.getFileName() + "#t=7.25\"";
            default -> "srcdoc=\"" + PageTemplate.escape(Files.readString(page)) + "\"";
        };
        Path outer = folder.resolve("outer.html");
        Files.writeString(outer, "<!DOCTYPE html><title>Notebook</title><body style=\"margin:0;height:3000px\">"
            + "<iframe width=\"700\" height=\"420\" " + frame + "></iframe></body>");
        browser.openPlain(outer);
        browser.enterFrame();
        if (!kind.equals("text")) {
            assertEquals(7.25, browser.number("steward.time()"));
        }
        browser.run("steward.seek(3)");
        browser.click("#play");
        browser.await("it does not play", () -> browser.number("steward.time()") > 3.5);
        browser.click("#play");
        assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"), "nothing is wider");
        double scale = browser.number("steward.camera().scale");
        browser.leaveFrame();
        browser.wheel(200, 150, 240);
        browser.await("the outer page does not scroll", () -> browser.is("scrollY > 100"));
        browser.enterFrame();
        assertEquals(scale, browser.number("steward.camera().scale"), "a wheel without Ctrl is the outer page's");
        if (kind.equals("text")) {
            browser.press("s");
            assertTrue(browser.text("#told").startsWith("This page has no address of its own; the moment is #t="),
                browser.text("#told"));
        }
    }
}

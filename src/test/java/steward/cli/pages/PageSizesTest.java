package steward.cli.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.replay.page.PageTestBrowser;

/** Pages on small screens and on paper: nothing is cut off, nothing is wider than the screen. */
@Tag("browser")
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class PageSizesTest extends GalleryTest {

    /** What is outside of the window at its sides, but for what is in a box that scrolls sideways. */
    private static final String CUT_OFF = """
        const isScrolled = node => node
            && (/auto|scroll/.test(getComputedStyle(node).overflowX) || isScrolled(node.parentElement));
        return [...document.querySelectorAll('button, select, input, a, h1, th, td, summary, .name, .why')]
          .filter(node => node.checkVisibility() && !isScrolled(node.parentElement))
          .map(node => [node, node.getBoundingClientRect()])
          .filter(([, box]) => box.right > innerWidth + 1 || box.left < -1)
          .map(([node]) => node.outerHTML.slice(0, 80));
        """;

    static Stream<String> pages() {
        return PageGallery.ALL.stream();
    }

    private static void assertNothingIsCutOff(String name) throws IOException {
        browser.prefer(true, true);
        for (int width : new int[] {390, 320}) {
            browser.size(width, 640);
            gallery.show(browser, name);
            browser.settle();
            assertEquals(List.of(), browser.run(CUT_OFF), name + " at " + width);
            assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"), name + " at " + width);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "undrawn", "tournament", PageGallery.SMALL_LEAGUE})
    void nothingIsCutOffOnAPhone(String name) throws IOException {
        assertNothingIsCutOff(name);
    }

    @Tag("campaign")
    @ParameterizedTest
    @MethodSource("pages")
    void nothingIsCutOffOnAPhoneOfAnyPage(String name) throws IOException {
        assertNothingIsCutOff(name);
    }

    /** Of a match without a drawing the names stand above the strip, and the result is whole. */
    @Test
    void aMatchWithoutADrawingHasItsNamesAndItsResultOnAPhone() throws IOException {
        browser.prefer(true, true);
        browser.size(390, 844);
        gallery.show(browser, "undrawn");
        browser.run("steward.addTurn(arguments[0])", "{\"type\":\"result\",\"turns\":2,\"ending\":\"over\","
            + "\"standing\":[{\"rank\":0,\"score\":1},{\"rank\":1,\"score\":0}],"
            + "\"players\":[{},{\"fault\":\"no answer\"}]}");
        browser.run("steward.seek(2)");
        browser.settle();
        for (String part : List.of(".score .name", "#ending .headline", "#ending li .why")) {
            assertTrue(browser.is("[...document.querySelectorAll('" + part + "')].every(node => { const box "
                + "= node.getBoundingClientRect(); const parent = node.closest('#ending, #scores')"
                + ".getBoundingClientRect(); return box.height === 0 && !node.textContent || box.height >= 12 "
                + "&& box.top >= parent.top"
                + " && box.bottom <= parent.bottom + 1; })"), part);
        }
    }

    /** The colours of a canvas and of charts are those of paper while it is printed, and of the screen afterwards. */
    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", PageGallery.SMALL_LEAGUE})
    void paperIsLight(String name) throws IOException {
        browser.size(1280, 720);
        browser.prefer(true, true);
        gallery.show(browser, name);
        String ground = "getComputedStyle(document.body).backgroundColor";
        Object dark = browser.run("return " + ground);
        browser.run("dispatchEvent(new Event('beforeprint'))");
        assertEquals("rgb(238, 242, 247)", browser.run("return " + ground));
        browser.run("dispatchEvent(new Event('afterprint'))");
        assertEquals(dark, browser.run("return " + ground));
    }
}

package steward.cli.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.replay.page.PageTestBrowser;

/** Every page, asked by axe: light and dark, on a desk and on a phone. */
@Tag("browser")
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class PageAccessTest extends GalleryTest {

    private static final String AXE = "/META-INF/resources/webjars/axe-core/4.6.3/axe.min.js";
    /** Colours that this axe does not know, as it knows them; without it no contrast of a page is looked at. */
    private static final String OLDER_COLOURS = """
        ;(() => {
          const share = /color\\(srgb ([\\d.e-]+) ([\\d.e-]+) ([\\d.e-]+)(?: \\/ ([\\d.e-]+))?\\)/g;
          const older = value => typeof value === 'string' ? value.replace(share, (all, r, g, b, a = '1') =>
            `rgba(${[r, g, b].map(part => Math.round(255 * part)).join(', ')}, ${a})`) : value;
          const computed = window.getComputedStyle;
          window.getComputedStyle = (...of) => new Proxy(computed.apply(window, of), {
            get: (style, name) => typeof style[name] === 'function'
              ? (...words) => older(style[name](...words)) : older(style[name]) });
        })();
        """;
    private static final int[] DESK = {1280, 720};
    private static final int[] PHONE = {390, 844};
    private static final int[] PHONE_ON_ITS_SIDE = {844, 390};

    static Stream<String> pages() {
        return PageGallery.ALL.stream();
    }

    private static void assertNothingFound(boolean isDark, int[] size) throws IOException {
        browser.prefer(isDark, true);
        browser.size(size[0], size[1]);
        browser.settle();
        assertEquals(List.of(), violations(), () -> (isDark ? "dark, " : "light, ") + size[0] + " wide");
    }

    private static void goToTheEnd(String name) {
        if (PageGallery.MATCHES.contains(name)) {
            browser.run("steward.seek(steward.lastTurn())");
        }
    }

    private static void assertMistakesAreFound() throws IOException {
        browser.run("""
            const head = document.querySelector('h1');
            Object.assign(head.style, { color: '#888888', backgroundColor: '#999999' });
            head.append(document.createElement('img'));
            """);
        assertEquals(List.of("color-contrast", "image-alt"),
            violations().stream().map(each -> each.replaceFirst(":.*", "")).sorted().toList());
    }

    /** A page of a match and one of a league, each theme at another size, the match the second time at its end. */
    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", PageGallery.SMALL_LEAGUE})
    void axeFindsNothingInEitherTheme(String name) throws IOException {
        gallery.show(browser, name);
        assertNothingFound(true, DESK);
        goToTheEnd(name);
        assertNothingFound(false, PHONE);
    }

    /** A page of a match without a drawing and one of a bot, in one theme. */
    @ParameterizedTest
    @CsvSource({"undrawn, false", "author, true"})
    void axeFindsNothingInOneTheme(String name, boolean isDark) throws IOException {
        gallery.show(browser, name);
        assertNothingFound(isDark, isDark ? DESK : PHONE);
    }

    @Test
    void aMistakeIsFound() throws IOException {
        gallery.show(browser, "undrawn");
        assertMistakesAreFound();
    }

    @Tag("campaign")
    @ParameterizedTest
    @MethodSource("pages")
    void axeFindsNothing(String name) throws IOException {
        gallery.show(browser, name);
        for (boolean isDark : new boolean[] {true, false}) {
            for (int[] size : List.of(DESK, PHONE, PHONE_ON_ITS_SIDE)) {
                assertNothingFound(isDark, size);
            }
        }
        goToTheEnd(name);
        assertEquals(List.of(), violations(), "at the end");
    }

    @Test
    @Tag("campaign")
    void whatIsWrongIsFound() throws IOException {
        browser.size(DESK[0], DESK[1]);
        for (String name : List.of("mad-pod-racing", "league", "tournament")) {
            gallery.show(browser, name);
            assertMistakesAreFound();
        }
    }

    /** Findings of axe on the page that is open, the rule and the place; also rules that axe could not ask. */
    @SuppressWarnings("unchecked")
    private static List<String> violations() throws IOException {
        if (!browser.is("window.axe")) {
            try (InputStream in = PageAccessTest.class.getResourceAsStream(AXE)) {
                browser.run(OLDER_COLOURS + new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    + ";window.axe = axe;");
            }
        }
        return (List<String>) browser.run("""
            return axe.run(document, { resultTypes: ['violations', 'incomplete'] }).then(found => [
              ...found.violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target}`)),
              ...found.incomplete.filter(({ nodes }) => !nodes.length).map(({ id }) => `${id}: was not asked`)]);
            """);
    }
}

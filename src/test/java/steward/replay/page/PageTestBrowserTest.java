package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The one browser of the tests: nothing that a test did to it is there for the next. */
@Tag("browser")
class PageTestBrowserTest {

    @TempDir
    static Path folder;

    @Test
    void whoGetsTheBrowserFindsItAsNew() throws IOException {
        Path page = Files.writeString(folder.resolve("page.html"), "<!DOCTYPE html><title>Page</title>"
            + "<meta name=viewport content=width=device-width>");
        String look = "return [localStorage.length, matchMedia('(prefers-color-scheme: dark)').matches,"
            + " matchMedia('(prefers-reduced-motion: reduce)').matches, innerWidth].join(' ')";
        Object first;
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            assertThrows(IllegalStateException.class, PageTestBrowser::start);
            browser.openPlain(page);
            first = browser.run(look);
            browser.prefer(browser.is("!matchMedia('(prefers-color-scheme: dark)').matches"), true);
            browser.size(390, 844);
            browser.run("localStorage.setItem('theme', 'dark'); window.open('page.html')");
            browser.await("the other window does not open", () -> browser.windows() == 2);
            assertTrue(browser.is("localStorage.length === 1 && innerWidth === 390"));
        }
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            assertEquals(1, browser.windows());
            browser.openPlain(page);
            assertEquals(first, browser.run(look));
        }
    }
}

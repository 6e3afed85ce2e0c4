package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;

/** The one browser of the tests: nothing that a test did to it is there for the next. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
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

    /** Tests of pages run beside each other: without the lock two would want the browser at once now and then. */
    @Test
    void whoHasTheTagHasTheLock() throws IOException {
        Pattern tag = Pattern.compile("(?m)^ *@Tag\\(\"browser\"\\)$[^{]*");
        List<String> without = new ArrayList<>();
        int with = 0;
        try (Stream<Path> files = Files.walk(Path.of("src"))) {
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                for (MatchResult found : tag.matcher(Files.readString(file)).results().toList()) {
                    if (found.group().contains("@ResourceLock(PageTestBrowser.LOCK)")) {
                        with++;
                    } else {
                        without.add(file.toString());
                    }
                }
            }
        }
        assertEquals(List.of(), without);
        assertTrue(with > 5, with + " have it");
    }
}

package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;

/**
 * Tests that look at pages in a real browser. Each method gets it as new, dark and at rest, and fails if the last page
 * that it opened has complained.
 */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
public abstract class PageTestCase {

    /** Complaints that tests cause: a live page that no server sends turns, and pixels that they read back. */
    private static final List<String> OF_TESTS = List.of("/feed", "Multiple readback operations");

    /** Folder of the class. */
    @TempDir
    protected static Path folder;

    protected static PageTestPages pages;

    protected static PageTestBrowser browser;

    @BeforeAll
    static void makePages() {
        pages = new PageTestPages(folder);
    }

    @BeforeEach
    final void startBrowser() {
        browser = PageTestBrowser.start();
        browser.prefer(true, true);
    }

    @AfterEach
    final void closeBrowser() {
        if (browser != null) {
            try (PageTestBrowser closed = browser) {
                assertEquals(List.of(), closed.complaints().stream()
                    .filter(line -> OF_TESTS.stream().noneMatch(line::contains)).toList());
            }
        }
    }
}

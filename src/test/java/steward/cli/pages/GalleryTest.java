package steward.cli.pages;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import steward.replay.page.PageTestBrowser;

/** One browser and one gallery for all tests of a class. */
abstract class GalleryTest {

    @TempDir
    static Path folder;

    static PageTestBrowser browser;
    static PageGallery gallery;

    @BeforeAll
    static void start() {
        browser = PageTestBrowser.start();
        gallery = new PageGallery(folder);
    }

    @AfterAll
    static void quit() {
        if (browser != null) {
            browser.close();
        }
    }
}

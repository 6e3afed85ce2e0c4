package steward.cli.pages;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import steward.replay.page.PageTestBrowser;

/**
 * Every page beside a reference picture of few large pixels, so that fonts and smoothing of another machine make no
 * difference, but a lane, hulls or a panel that are gone do.
 */
@Tag("browser")
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class PagePicturesTest extends GalleryTest {

    /** The side of a large pixel, in pixels of the page. */
    private static final int CELL = 24;
    /** Of 255, a channel: a pixel that differs by more is another one. */
    private static final int NEAR = 24;
    /** Share of pixels that may be others. */
    private static final double OTHERS = 0.004;
    /** The details of a match, in which answer times differ from run to run. */
    private static final int DETAILS = 344;

    static Stream<Arguments> pagesAndThemes() {
        return PageGallery.ALL.stream().flatMap(name -> Stream.of(Arguments.of(name, true), Arguments.of(name, false)));
    }

    /** Pages without a field, in one theme. */
    @ParameterizedTest
    @CsvSource({"undrawn, false", "tournament, false", "author, true"})
    void looksLikeTheReference(String name, boolean isDark) throws IOException {
        show(name, isDark);
        assertLooksLikeTheReference(name, isDark);
    }

    @Test
    void followsWhenTheThemeChanges() throws IOException {
        assertFollowsWhenTheThemeChanges("mad-pod-racing", true);
    }

    @Tag("campaign")
    @ParameterizedTest
    @MethodSource("pagesAndThemes")
    void everyPageLooksLikeTheReferencesWhenOpenedAndWhenTheThemeChanges(String name, boolean isDark)
            throws IOException {
        assertFollowsWhenTheThemeChanges(name, isDark);
    }

    private static void assertFollowsWhenTheThemeChanges(String name, boolean isDark) throws IOException {
        show(name, isDark);
        assertLooksLikeTheReference(name, isDark);
        browser.prefer(!isDark, true);
        assertLooksLikeTheReference(name, !isDark);
    }

    private static void assertLooksLikeTheReference(String name, boolean isDark) throws IOException {
        BufferedImage seen = seen(name);
        String file = name + (isDark ? "-dark" : "-light") + ".png";
        try (InputStream in = PagePicturesTest.class.getResourceAsStream(file)) {
            double others = in == null ? 1 : others(seen, ImageIO.read(in));
            if (others > OTHERS) {
                Path written = Files.createDirectories(Path.of("build/pictures")).resolve(file);
                ImageIO.write(seen, "png", written.toFile());
                throw new AssertionError((in == null ? "there is no reference picture " + file
                    : file + ": " + Math.round(1000 * others) / 10.0 + "% of the pixels differ")
                    + "; this one is at " + written);
            }
        }
    }

    @Test
    void whatIsGoneIsFound() throws IOException {
        assertWhatIsGoneIsFound("steward.hide('drawBody')", "document.getElementById('scores').hidden = true");
    }

    @Test
    @Tag("campaign")
    void moreThatIsGoneIsFound() throws IOException {
        assertWhatIsGoneIsFound("steward.hide('drawGround')", "document.getElementById('marks').hidden = true");
    }

    /** Other letters are within the tolerance; what belongs to the picture and is not there is not. */
    private static void assertWhatIsGoneIsFound(String... changes) throws IOException {
        String name = "mad-pod-racing";
        show(name, true);
        BufferedImage whole = seen(name);
        browser.run("document.body.style.fontFamily = 'serif'");
        double serif = others(whole, seen(name));
        assertTrue(serif <= OTHERS, () -> "another font: " + serif);
        browser.run("document.body.style.fontFamily = ''");
        for (String gone : changes) {
            browser.run(gone);
            BufferedImage now = seen(name);
            double others = others(whole, now);
            assertTrue(others > OTHERS, () -> gone + ": " + others);
            whole = now;
        }
    }

    private static void show(String name, boolean isDark) throws IOException {
        browser.size(1280, PageGallery.MATCHES.contains(name) ? 720 : 1600);
        browser.prefer(isDark, true);
        gallery.show(browser, name);
    }

    private static BufferedImage seen(String name) throws IOException {
        browser.settle();
        BufferedImage whole = ImageIO.read(new ByteArrayInputStream(browser.screenshot()));
        return shrunk(whole, whole.getWidth() - (PageGallery.MATCHES.contains(name) ? DETAILS : 0));
    }

    private static BufferedImage shrunk(BufferedImage whole, int width) {
        BufferedImage small = new BufferedImage(width / CELL, whole.getHeight() / CELL, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < small.getHeight(); y++) {
            for (int x = 0; x < small.getWidth(); x++) {
                small.setRGB(x, y, mean(whole, x * CELL, y * CELL));
            }
        }
        return small;
    }

    private static int mean(BufferedImage whole, int left, int top) {
        int bands = whole.getRaster().getNumBands();         // red, green, blue, perhaps alpha
        int[] samples = whole.getRaster().getPixels(left, top, CELL, CELL, (int[]) null);
        int[] sums = new int[bands];
        for (int k = 0; k < samples.length; k++) {
            sums[k % bands] += samples[k];
        }
        int all = CELL * CELL;
        return sums[0] / all << 16 | sums[1] / all << 8 | sums[2] / all;
    }

    private static int channel(int colour, int channel) {
        return colour >> 8 * channel & 255;
    }

    private static double others(BufferedImage one, BufferedImage other) {
        if (one.getWidth() != other.getWidth() || one.getHeight() != other.getHeight()) {
            return 1;
        }
        int count = 0;
        for (int y = 0; y < one.getHeight(); y++) {
            for (int x = 0; x < one.getWidth(); x++) {
                int far = 0;
                for (int channel = 0; channel < 3; channel++) {
                    far = Math.max(far, Math.abs(channel(one.getRGB(x, y), channel)
                        - channel(other.getRGB(x, y), channel)));
                }
                count += far > NEAR ? 1 : 0;
            }
        }
        return count / (double) (one.getWidth() * one.getHeight());
    }
}

package steward.cli.pages;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every page beside a reference picture of few large pixels, so that fonts and smoothing of another machine make no
 * difference, but a lane, hulls or a panel that are gone do.
 */
@Tag("browser")
@Tag("process")
@Tag("slow")
@Timeout(300)
class PagePicturesTest extends GalleryTest {

    /** The side of a large pixel, in pixels of the page. */
    private static final int CELL = 24;
    /** Of 255, a channel: a pixel that differs by more is another one. */
    private static final int NEAR = 24;
    /** Share of pixels that may be others. */
    private static final double OTHERS = 0.004;
    /** The details of a match, in which answer times differ from run to run. */
    private static final int DETAILS = 344;

    static Stream<Arguments> pages() {
        return PageGallery.ALL.stream()
            .flatMap(name -> Stream.of(Arguments.of(name, true), Arguments.of(name, false)));
    }

    @ParameterizedTest
    @MethodSource("pages")
    void looksLikeTheReference(String name, boolean isDark) throws IOException {
        BufferedImage seen = seen(name, isDark, "");
        String file = name + (isDark ? "-dark" : "-light") + ".png";
        try (InputStream in = getClass().getResourceAsStream(file)) {
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

    /** Other letters are within the tolerance; what belongs to the picture and is not there is not. */
    @Test
    void whatIsGoneIsFound() throws IOException {
        BufferedImage whole = seen("mad-pod-racing", true, "");
        double serif = others(whole, seen("mad-pod-racing", true, "document.body.style.fontFamily = 'serif'"));
        assertTrue(serif <= OTHERS, () -> "another font: " + serif);
        for (String gone : List.of("steward.hide('drawBody')", "steward.hide('drawGround')",
                "document.getElementById('scores').hidden = true", "document.getElementById('marks').hidden = true")) {
            double others = others(whole, seen("mad-pod-racing", true, gone));
            assertTrue(others > OTHERS, () -> gone + ": " + others);
        }
    }

    private static BufferedImage seen(String name, boolean isDark, String change) throws IOException {
        boolean isMatch = PageGallery.MATCHES.contains(name);
        browser.size(1280, isMatch ? 720 : 1600);
        browser.prefer(isDark, true);
        gallery.show(browser, name);
        browser.run(change);
        browser.settle();
        browser.screenshot(folder.resolve("seen.png"));
        BufferedImage whole = ImageIO.read(folder.resolve("seen.png").toFile());
        return shrunk(whole, whole.getWidth() - (isMatch ? DETAILS : 0));
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
        int[] sums = new int[3];
        for (int y = top; y < top + CELL; y++) {
            for (int x = left; x < left + CELL; x++) {
                for (int channel = 0; channel < 3; channel++) {
                    sums[channel] += channel(whole.getRGB(x, y), channel);
                }
            }
        }
        int all = CELL * CELL;
        return sums[2] / all << 16 | sums[1] / all << 8 | sums[0] / all;
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

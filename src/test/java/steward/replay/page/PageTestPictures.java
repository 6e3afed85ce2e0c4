package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Field, scores and timeline of a match beside a reference picture of few large pixels, so that fonts and smoothing of
 * another machine make no difference, but a hull, a lane or a panel that is gone does.
 */
@Tag("browser")
class PageTestPictures {

    private static final int ACROSS = 48;
    private static final int DOWN = 30;
    /** Of 255, a channel: a pixel that differs by more is another one. */
    private static final int NEAR = 24;
    /** Share of pixels that may be others: text is in some of them. */
    private static final double OTHERS = 0.03;
    /** The details, in which answer times differ from run to run. */
    private static final int DETAILS = 344;

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"mad-pod-racing, true", "mad-pod-racing, false", "walled-race, true"})
    void looksLikeTheReference(String scene, boolean isDark) throws IOException {
        String name = scene + (isDark ? "-dark" : "-light") + ".png";
        BufferedImage seen;
        try (PageTestBrowser browser = PageTestBrowser.start(folder.resolve("profile"))) {
            browser.size(1280, 720);
            browser.prefer(isDark, true);
            browser.open(new PageTestPages(folder).page(PageTestRaces.play(PageTestRaces.scene(scene), 3), "Race"),
                "#t=30.5");
            browser.screenshot(folder.resolve("seen.png"));
            BufferedImage whole = ImageIO.read(folder.resolve("seen.png").toFile());
            seen = shrunk(whole.getSubimage(0, 0, whole.getWidth() - DETAILS, whole.getHeight()));
        }
        try (InputStream in = getClass().getResourceAsStream("pictures/" + name)) {
            if (in == null) {
                Path written = Files.createDirectories(Path.of("build/pictures")).resolve(name);
                ImageIO.write(seen, "png", written.toFile());
                throw new AssertionError("there is no reference picture " + name + "; this one is at " + written);
            }
            double others = others(seen, ImageIO.read(in));
            assertTrue(others <= OTHERS, () -> name + ": " + Math.round(100 * others) + "% of the pixels differ");
        }
    }

    private static BufferedImage shrunk(BufferedImage whole) {
        BufferedImage small = new BufferedImage(ACROSS, DOWN, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < DOWN; y++) {
            for (int x = 0; x < ACROSS; x++) {
                small.setRGB(x, y, mean(whole, x, y));
            }
        }
        return small;
    }

    /** The mean colour of the part of a picture that becomes one pixel. */
    private static int mean(BufferedImage whole, int column, int row) {
        long red = 0;
        long green = 0;
        long blue = 0;
        int left = column * whole.getWidth() / ACROSS;
        int right = (column + 1) * whole.getWidth() / ACROSS;
        int top = row * whole.getHeight() / DOWN;
        int bottom = (row + 1) * whole.getHeight() / DOWN;
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                int colour = whole.getRGB(x, y);
                red += colour >> 16 & 255;
                green += colour >> 8 & 255;
                blue += colour & 255;
            }
        }
        int all = (right - left) * (bottom - top);
        return (int) (red / all) << 16 | (int) (green / all) << 8 | (int) (blue / all);
    }

    private static double others(BufferedImage one, BufferedImage other) {
        int count = 0;
        for (int y = 0; y < DOWN; y++) {
            for (int x = 0; x < ACROSS; x++) {
                int a = one.getRGB(x, y);
                int b = other.getRGB(x, y);
                int far = Math.max(Math.abs((a >> 16 & 255) - (b >> 16 & 255)),
                    Math.max(Math.abs((a >> 8 & 255) - (b >> 8 & 255)), Math.abs((a & 255) - (b & 255))));
                count += far > NEAR ? 1 : 0;
            }
        }
        return count / (double) (ACROSS * DOWN);
    }
}

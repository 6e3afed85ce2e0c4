package steward.lab.chart;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.knowm.xchart.style.AxesChartStyler;

/** Writer of pictures to files, for light and for dark pages, with wrapped text. */
public final class ChartFiles {

    static {
        // Headless even where there is a display; must be set before the first colour is created.
        System.setProperty("java.awt.headless", "true");
    }

    /** Pixels of a picture for one of the drawing. */
    private static final double SCALE = 2;
    private static final int PADDING = 4;
    private static final float THIN = 0.8f;

    private ChartFiles() { }

    /**
     * Writes a picture in pixels, replacing an older one.
     *
     * @throws IOException if it cannot be written
     */
    public static void png(Drawing drawing, ChartColours colours, Path file) throws IOException {
        BufferedImage image = new BufferedImage((int) (SCALE * drawing.width()), (int) (SCALE * drawing.height()),
            BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        pen.scale(SCALE, SCALE);
        paint(drawing, colours, pen);
        pen.dispose();
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            ImageIO.write(image, "png", out);
        }
    }

    private static void paint(Drawing drawing, ChartColours colours, Graphics2D pen) {
        pen.setColor(colours.background());
        pen.fillRect(0, 0, drawing.width(), drawing.height());
        drawing.paint(pen, colours);
    }

    public static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }

    /** A text in lines no wider than this; a longer word is cut. */
    public static List<String> lines(String text, Font font, int width) {
        Graphics2D pen = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        FontMetrics metrics = pen.getFontMetrics(font);
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : text.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (metrics.stringWidth(longer) > width && !line.isEmpty()) {
                lines.add(line);
                longer = word;
            }
            while (metrics.stringWidth(longer) > width && longer.length() > 1) {
                int most = longer.length() - 1;
                while (most > 1 && metrics.stringWidth(longer.substring(0, most)) > width) {
                    most--;
                }
                lines.add(longer.substring(0, most));
                longer = longer.substring(most);
            }
            line = longer;
        }
        lines.add(line);
        pen.dispose();
        return lines;
    }

    /** Colours and fonts that all charts share. */
    public static void style(AxesChartStyler style, ChartColours colours, int size) {
        style.setChartBackgroundColor(colours.background());
        style.setPlotBackgroundColor(colours.background());
        style.setPlotBorderColor(colours.grid());
        style.setChartFontColor(colours.ink());
        style.setChartTitleVisible(false);
        style.setLegendBackgroundColor(colours.background());
        style.setLegendBorderColor(colours.background());
        style.setLegendFont(font(Font.PLAIN, size));
        style.setChartPadding(PADDING);
        style.setAxisTickLabelsColor(colours.ink());
        style.setAxisTickMarksColor(colours.grid());
        style.setPlotGridLinesColor(colours.grid());
        style.setPlotGridLinesStroke(new BasicStroke(THIN));
        style.setAxisTickLabelsFont(font(Font.PLAIN, size));
        style.setAxisTitleFont(font(Font.PLAIN, size));
    }
}

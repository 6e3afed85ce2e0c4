package steward.lab.tradeoff.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/**
 * Draws error against cost in small multiples: a panel per scene, all with the same logarithmic axes, painted into one
 * picture, for light and for dark pages.
 */
final class TradeoffPlot {

    static {
        // Headless even where there is a display; must be set before the first colour is created.
        System.setProperty("java.awt.headless", "true");
    }

    /** The picture, and the drawing, each for light and dark pages. */
    static final String PNG = "tradeoff.png";
    static final String DARK_PNG = "tradeoff-dark.png";
    static final String SVG = "tradeoff.svg";
    static final String DARK_SVG = "tradeoff-dark.svg";

    private static final int COLUMNS = 4;
    private static final int WIDTH = 340;
    private static final int HEIGHT = 300;
    private static final int MARGIN = 12;
    private static final int TITLE = 34;
    private static final int CAPTION = 72;
    private static final int LINE = 20;
    /** Pixels of the picture for one of the drawing. */
    private static final double SCALE = 1.5;

    private static final List<String> MEANING = List.of(
        "Across: cost of a turn as a multiple of double's, whose time stands above the panel, up to "
            + Math.round(TradeoffPanel.MOST_COST) + " times; a bar holds four rounds in five.",
        "Upward: 99% of the turns are off by at most so many u; errors of 0 at the bottom.",
        "Circles: 1, 2, 4 ... steps a turn. Squares: exact times. Chosen: the cheapest below the dashed line at "
            + TradeoffRow.DEMAND + " u.");

    private TradeoffPlot() {
    }

    /** Writes all four files into a folder, replacing older ones. */
    static void write(TradeoffResult result, Path folder) throws IOException {
        for (TradeoffColours colours : List.of(TradeoffColours.LIGHT, TradeoffColours.DARK)) {
            boolean light = colours.equals(TradeoffColours.LIGHT);
            writePng(result, colours, folder.resolve(light ? PNG : DARK_PNG));
            writeSvg(result, colours, folder.resolve(light ? SVG : DARK_SVG));
        }
    }

    private static void writePng(TradeoffResult result, TradeoffColours colours, Path file) throws IOException {
        BufferedImage image = new BufferedImage((int) (SCALE * width(result)), (int) (SCALE * height(result)),
            BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        pen.scale(SCALE, SCALE);
        paint(result, colours, pen);
        pen.dispose();
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            ImageIO.write(image, "png", out);
        }
    }

    /** All panels as one chart of XChart, whose own encoder writes drawings. */
    private static void writeSvg(TradeoffResult result, TradeoffColours colours, Path file) throws IOException {
        XYChart grid = new XYChart(new XYChartBuilder().width(width(result)).height(height(result))) {
            @Override
            public void paint(Graphics2D pen, int width, int height) {
                TradeoffPlot.paint(result, colours, pen);
            }
        };
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            ChartEncoder.saveChart(grid, out, "svg");
        }
    }

    private static int columns(TradeoffResult result) {
        return Math.min(COLUMNS, Math.max(2, result.scenes().size()));
    }

    private static int width(TradeoffResult result) {
        return columns(result) * WIDTH + 2 * MARGIN;
    }

    private static int height(TradeoffResult result) {
        int rows = (result.scenes().size() + columns(result) - 1) / columns(result);
        return TITLE + rows * HEIGHT + CAPTION + MARGIN;
    }

    private static void paint(TradeoffResult result, TradeoffColours colours, Graphics2D pen) {
        pen.setColor(colours.background());
        pen.fillRect(0, 0, width(result), height(result));
        text(pen, colours.ink(), Font.BOLD, 15, "Error against cost, rung by rung: "
            + result.machine().replaceFirst(" \\(.*", "") + ", " + result.date(), MARGIN, TITLE - 10);
        TradeoffPanel.Axes axes = TradeoffPanel.Axes.of(result.rows());
        List<String> scenes = result.scenes();
        for (int n = 0; n < scenes.size(); n++) {
            Graphics2D place = (Graphics2D) pen.create();
            place.translate(MARGIN + n % columns(result) * WIDTH, TITLE + n / columns(result) * HEIGHT);
            TradeoffPanel.of(result, scenes.get(n), axes, colours).paint(place, WIDTH, HEIGHT);
            place.dispose();
        }
        int line = height(result) - CAPTION + LINE;
        for (String each : MEANING) {
            text(pen, colours.ink(), Font.PLAIN, 13, each, MARGIN, line);
            line += LINE;
        }
    }

    private static void text(Graphics2D pen, Color colour, int style, int size, String text, int x, int y) {
        pen.setColor(colour);
        pen.setFont(new Font(Font.SANS_SERIF, style, size));
        pen.drawString(text, x, y);
    }
}

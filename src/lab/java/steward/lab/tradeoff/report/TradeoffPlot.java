package steward.lab.tradeoff.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import steward.lab.chart.ChartColours;
import steward.lab.chart.ChartFiles;
import steward.lab.chart.Drawing;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/**
 * Plot of error against cost: a panel per scene, one under the other so that a phone shows them large, all with equal
 * logarithmic axes.
 */
record TradeoffPlot(TradeoffResult result, List<String> scenes) implements Drawing {

    /** The first scene alone, for light and for dark pages. */
    static final String PNG = "tradeoff.png";
    static final String DARK_PNG = "tradeoff-dark.png";
    /** All scenes. */
    static final String ALL_PNG = "tradeoff-scenes.png";
    static final String ALL_DARK_PNG = "tradeoff-scenes-dark.png";

    private static final int WIDTH = 500;
    private static final int PANEL = 380;
    private static final int MARGIN = 12;
    private static final int LINE = 19;
    private static final Font BOLD = ChartFiles.font(Font.BOLD, 15);
    private static final Font PLAIN = ChartFiles.font(Font.PLAIN, 13);

    private static final String MEANING = "Circles: rungs with 1, 2, 4 ... steps a turn. Squares: rungs with exact "
        + "times of impact. A bar is the range over JVMs. Errors of 0 are at the bottom. Dashed: " + TradeoffRow.DEMAND
        + " u. Chosen: double, the default, unless it decides some impact wrongly or is above that line, or another "
        + "rung clearly costs less.";

    /**
     * Writes all files into a folder, replacing older ones.
     *
     * @throws IOException if one cannot be written
     */
    static void write(TradeoffResult result, Path folder) throws IOException {
        Drawing first = new TradeoffPlot(result, result.scenes().subList(0, 1));
        Drawing all = new TradeoffPlot(result, result.scenes());
        for (ChartColours colours : ChartColours.both()) {
            ChartFiles.png(first, colours, folder.resolve(colours.isDark() ? DARK_PNG : PNG));
            ChartFiles.png(all, colours, folder.resolve(colours.isDark() ? ALL_DARK_PNG : ALL_PNG));
        }
    }

    @Override
    public int width() {
        return WIDTH;
    }

    @Override
    public int height() {
        int lines = head().size() + meaning().size() + scenes.stream().mapToInt(scene -> title(scene).size()).sum();
        return MARGIN + lines * LINE + scenes.size() * (PANEL + MARGIN) + 2 * MARGIN;
    }

    private List<String> head() {
        return lines("Error against cost, rung by rung: " + result.machine().replaceFirst(" \\(.*", "") + ", "
            + result.date(), BOLD);
    }

    private static List<String> meaning() {
        return lines(MEANING, PLAIN);
    }

    /** The name of a scene of one's own may be longer than a line. */
    private List<String> title(String scene) {
        TradeoffRow usual = result.row(scene, TradeoffRow.DEFAULT_RUNG);
        return lines(scene + (usual == null ? "" : ": a turn of double takes "
            + time(usual.cost().nanosPerTurn())), BOLD);
    }

    private static List<String> lines(String text, Font font) {
        return ChartFiles.lines(text, font, WIDTH - 2 * MARGIN);
    }

    @Override
    public void paint(Graphics2D pen, ChartColours colours) {
        int y = text(pen, colours.ink(), BOLD, head(), MARGIN);
        TradeoffPanel.Axes axes = TradeoffPanel.Axes.of(result.rows());
        for (String scene : scenes) {
            y = text(pen, colours.ink(), BOLD, title(scene), y + MARGIN);
            Graphics2D place = (Graphics2D) pen.create();
            place.translate(0, y);
            TradeoffPanel.of(result, scene, axes, colours).paint(place, WIDTH, PANEL);
            place.dispose();
            y += PANEL;
        }
        text(pen, colours.ink(), PLAIN, meaning(), y);
    }

    /** Draws lines, and returns where they end. */
    private static int text(Graphics2D pen, Color colour, Font font, List<String> lines, int from) {
        pen.setColor(colour);
        pen.setFont(font);
        int y = from;
        for (String line : lines) {
            y += LINE;
            pen.drawString(line, MARGIN, y);
        }
        return y;
    }

    /** With three digits or more. */
    static String time(double nanos) {
        return Double.isNaN(nanos) ? "-" : nanos < 100 ? fixed("%.1f ns", nanos) : nanos < 1e4 ? fixed("%.0f ns", nanos)
            : nanos < 1e5 ? fixed("%.1f us", nanos / 1e3) : nanos < 1e7 ? fixed("%.0f us", nanos / 1e3)
            : fixed("%.1f ms", nanos / 1e6);
    }

    private static String fixed(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}

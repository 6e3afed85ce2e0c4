package steward.lab.tradeoff.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/**
 * Draws error against cost on logarithmic axes: one line per scene along its Pareto front, whose rungs have big marks;
 * rungs off the front are small crosses of the same colour.
 */
final class TradeoffPlot {

    static {
        // Headless even where there is a display; must be set before the first colour is created.
        System.setProperty("java.awt.headless", "true");
    }

    /** Name of the drawing. */
    static final String SVG = "tradeoff.svg";
    /** Name of the picture. */
    static final String PNG = "tradeoff.png";

    /** An error of 0, and any smaller one, is drawn here: there is no zero on a logarithmic axis. In u. */
    static final double FLOOR = 1e-14;

    private static final int WIDTH = 1250;
    private static final int HEIGHT = 780;
    private static final int DPI = 108;
    private static final Color INK = new Color(0x333333);
    private static final Color GRID = new Color(0xE4E4E4);

    /** Colours that can be told apart with colour vision deficiencies (after Okabe and Ito, 2008). */
    private static final Color[] COLOURS = {new Color(0x0072B2), new Color(0xD55E00), new Color(0x009E73),
        new Color(0xCC79A7), new Color(0xE69F00), new Color(0x56B4E9), new Color(0x222222), new Color(0x7A5195)};
    private static final Marker[] MARKS = {SeriesMarkers.CIRCLE, SeriesMarkers.SQUARE, SeriesMarkers.DIAMOND,
        SeriesMarkers.TRIANGLE_UP, SeriesMarkers.TRIANGLE_DOWN, SeriesMarkers.TRAPEZOID, SeriesMarkers.RECTANGLE};
    private static final Marker SMALL_CROSS = new SmallCross();
    /** How far above its mark a rung's name stands: a factor, on a logarithmic axis. */
    private static final double ABOVE = 2.2;
    /** About how wide a name is: a factor as well. */
    private static final double NAME_WIDTH = 2.5;

    private TradeoffPlot() {
    }

    /** Half the size of the marks on the front. */
    private static final class SmallCross extends Marker {

        @Override
        public void paint(Graphics2D g, double x, double y, int size) {
            double half = size / 4.0;
            g.setStroke(new BasicStroke(1.3f));
            g.draw(new Line2D.Double(x - half, y - half, x + half, y + half));
            g.draw(new Line2D.Double(x - half, y + half, x + half, y - half));
        }
    }

    /** Writes both files into a folder, replacing older ones. */
    static void write(TradeoffResult result, Path folder) throws IOException {
        XYChart chart = chart(result);
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(folder.resolve(SVG)))) {
            ChartEncoder.saveChart(chart, out, "svg");
        }
        BitmapEncoder.saveBitmapWithDPI(chart, folder.resolve(PNG).toString(), BitmapEncoder.BitmapFormat.PNG, DPI);
    }

    private static XYChart chart(TradeoffResult result) {
        XYChart chart = new XYChartBuilder().width(WIDTH).height(HEIGHT)
            .title("Error against cost, rung by rung: " + result.machine().replaceFirst(" \\(.*", "") + ", "
                + result.date())
            .xAxisTitle("cost of a turn, ns of CPU (marks on a line: the Pareto front; small crosses: rungs that "
                + "another beats in cost and error)")
            .yAxisTitle("position error after one turn, u: 99% of the turns are off by at most this (0 drawn at "
                + power(FLOOR) + ")").build();
        style(chart.getStyler());
        List<String> scenes = result.scenes();
        List<double[]> taken = new ArrayList<>();
        for (int n = 0; n < scenes.size(); n++) {
            List<TradeoffRow> rows = result.of(scenes.get(n));
            Color colour = COLOURS[n % COLOURS.length];
            List<TradeoffRow> front = rows.stream().filter(TradeoffRow::onFront)
                .sorted(Comparator.comparingDouble(row -> row.cost().nanosPerTurn())).toList();
            List<TradeoffRow> beaten = rows.stream().filter(row -> !row.onFront()).toList();
            if (!front.isEmpty()) {
                XYSeries line = add(chart, scenes.get(n), front);
                line.setMarker(MARKS[n % MARKS.length]).setMarkerColor(colour).setLineColor(colour);
                line.setLineStyle(new BasicStroke(2));
                names(chart, front, taken);
            }
            if (!beaten.isEmpty()) {
                XYSeries points = add(chart, scenes.get(n) + ", beaten", beaten);
                points.setMarker(SMALL_CROSS).setMarkerColor(colour);
                points.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
                points.setShowInLegend(false);
            }
        }
        return chart;
    }

    /**
     * Labels the first rung on the front, the last with steps, and the last: above or below, unless another name is
     * there.
     */
    private static void names(XYChart chart, List<TradeoffRow> front, List<double[]> taken) {
        for (int k = 0; k < front.size(); k++) {
            boolean last = k + 1 == front.size();
            boolean lastStep = isStep(front.get(k)) && (last || !isStep(front.get(k + 1)));
            if (k == 0 || last || lastStep) {
                TradeoffRow row = front.get(k);
                boolean below = k > 0 && last;
                double near = below ? error(row) / ABOVE : error(row) * ABOVE;
                double otherSide = error(row) * error(row) / near;
                for (double y : new double[] {near, otherSide}) {
                    if (isFree(row.cost().nanosPerTurn(), y, taken)) {
                        taken.add(new double[] {row.cost().nanosPerTurn(), y});
                        chart.addAnnotation(new AnnotationText(row.rung().replace("event/", ""),
                            row.cost().nanosPerTurn(), y, false));
                        break;
                    }
                }
            }
        }
    }

    private static boolean isFree(double x, double y, List<double[]> taken) {
        return taken.stream().noneMatch(other -> Math.abs(Math.log(x / other[0])) < Math.log(NAME_WIDTH)
            && Math.abs(Math.log(y / other[1])) < Math.log(ABOVE) * 0.9);
    }

    private static boolean isStep(TradeoffRow row) {
        return row.rung().startsWith("step/");
    }

    private static double error(TradeoffRow row) {
        return Math.max(FLOOR, Math.min(row.most99(), 1e9));
    }

    private static String power(double value) {
        return "1e" + Math.round(Math.log10(value));
    }

    private static XYSeries add(XYChart chart, String name, List<TradeoffRow> rows) {
        return chart.addSeries(name, rows.stream().mapToDouble(row -> row.cost().nanosPerTurn()).toArray(),
            rows.stream().mapToDouble(TradeoffPlot::error).toArray());
    }

    private static void style(XYStyler style) {
        style.setChartBackgroundColor(Color.WHITE);
        style.setChartFontColor(INK);
        style.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 16));
        style.setAxisTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        style.setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        style.setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        style.setLegendPosition(Styler.LegendPosition.OutsideE);
        style.setPlotGridLinesColor(GRID);
        style.setPlotGridLinesStroke(new BasicStroke(0.4f));
        style.setXAxisLogarithmic(true);
        style.setYAxisLogarithmic(true);
        style.setXAxisLogarithmicDecadeOnly(true);
        style.setYAxisLogarithmicDecadeOnly(true);
        style.setYAxisMin(FLOOR);
        style.setMarkerSize(10);
        style.setLocale(Locale.ROOT);
        style.setXAxisTickLabelsFormattingFunction(TradeoffPlot::power);
        style.setYAxisTickLabelsFormattingFunction(TradeoffPlot::power);
        style.setAnnotationTextFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
        style.setAnnotationTextFontColor(INK);
    }
}

package steward.league.page;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;

/** Draws the ratings with their bars, and the ratings over games, as PNG and SVG. */
public final class LeaguePlots {

    static {
        // Headless even where there is a display; must be set before the first colour is created.
        System.setProperty("java.awt.headless", "true");
    }

    private static final int WIDTH = 1000;
    private static final int HEIGHT = 620;
    private static final int DPI = 108;
    private static final Color INK = new Color(0x333333);
    private static final Color GRID = new Color(0xE4E4E4);
    /** Colours that can be told apart with colour vision deficiencies (after Okabe and Ito, 2008). */
    private static final Color[] COLOURS = {new Color(0x0072B2), new Color(0xD55E00), new Color(0x009E73),
        new Color(0xCC79A7), new Color(0xE69F00), new Color(0x56B4E9), new Color(0x222222), new Color(0x7A5195)};

    private LeaguePlots() { }

    /**
     * Writes {@code ratings} and {@code path}, each with {@code .png} and {@code .svg}, replacing older ones.
     *
     * @return the files
     * @throws IOException if one cannot be written
     */
    public static List<Path> write(LeagueTable table, RatingPath path, String title, Path folder) throws IOException {
        List<Path> files = new ArrayList<>();
        files.addAll(save(bars(table, title), folder.resolve("ratings")));
        files.addAll(save(path(path, title), folder.resolve("path")));
        return files;
    }

    private static List<Path> save(XYChart chart, Path name) throws IOException {
        Path svg = name.resolveSibling(name.getFileName() + ".svg");
        Path png = name.resolveSibling(name.getFileName() + ".png");
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(svg))) {
            ChartEncoder.saveChart(chart, out, "svg");
        }
        BitmapEncoder.saveBitmapWithDPI(chart, png.toString(), BitmapEncoder.BitmapFormat.PNG, DPI);
        return List.of(png, svg);
    }

    private static XYChart bars(LeagueTable table, String title) {
        XYChart chart = new XYChartBuilder().width(WIDTH).height(HEIGHT).title(title + ": ratings, 95% bars")
            .xAxisTitle("rank").yAxisTitle("rating, Elo; 0 is the mean").build();
        style(chart.getStyler());
        int number = 0;
        for (LeagueTable.Row row : table.rows()) {
            if (row.sums().games() == 0) {
                continue;
            }
            XYSeries bar = chart.addSeries((number + 1) + "  " + row.entry().name(), new double[] {number + 1},
                new double[] {row.rating()}, row.hasBar() ? new double[] {row.bar()} : null);
            Color colour = COLOURS[number % COLOURS.length];
            bar.setMarker(SeriesMarkers.CIRCLE).setMarkerColor(colour).setLineColor(colour);
            number++;
        }
        chart.getStyler().setXAxisMin(0.0);
        chart.getStyler().setXAxisMax(number + 1.0);
        chart.getStyler().setXAxisDecimalPattern("#");
        return chart;
    }

    private static XYChart path(RatingPath path, String title) {
        XYChart chart = new XYChartBuilder().width(WIDTH).height(HEIGHT).title(title + ": rating over games")
            .xAxisTitle("games").yAxisTitle("rating, Elo; 0 is the mean").build();
        style(chart.getStyler());
        for (int k = 0; k < path.entries().size(); k++) {
            List<Double> games = new ArrayList<>();
            List<Double> ratings = new ArrayList<>();
            for (RatingPath.Point point : path.points()) {
                if (!Double.isNaN(point.ratings()[k])) {
                    games.add((double) point.games());
                    ratings.add(point.ratings()[k]);
                }
            }
            if (!games.isEmpty()) {
                Color colour = COLOURS[k % COLOURS.length];
                XYSeries line = chart.addSeries(path.entries().get(k).name(), games, ratings);
                line.setMarker(SeriesMarkers.NONE).setLineColor(colour).setLineStyle(new BasicStroke(2));
            }
        }
        return chart;
    }

    /** How all plots of leagues look. */
    public static void style(XYStyler style) {
        style.setChartBackgroundColor(Color.WHITE);
        style.setChartFontColor(INK);
        style.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 16));
        style.setAxisTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        style.setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        style.setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        style.setLegendPosition(Styler.LegendPosition.OutsideE);
        style.setPlotGridLinesColor(GRID);
        style.setErrorBarsColorSeriesColor(true);
        style.setMarkerSize(10);
        style.setLocale(Locale.ROOT);
    }
}

package steward.league.page;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.markers.SeriesMarkers;
import steward.league.tune.TunedCommand;

/** Draws how parameters went, as PNG and SVG. */
public final class TunePlot {

    static {
        // Headless even where there is a display; must be set before the first colour is created.
        System.setProperty("java.awt.headless", "true");
    }

    private static final int WIDTH = 1000;
    private static final int HEIGHT = 620;
    private static final int DPI = 108;
    private static final double PERCENT = 100;
    /** Pixels between the numbers of steps. */
    private static final int TICKS = 80;

    private TunePlot() { }

    /**
     * Writes {@code tune.png} and {@code tune.svg}, replacing older ones.
     *
     * @return the files
     * @throws IOException if one cannot be written
     */
    public static List<Path> write(TunedCommand command, List<double[]> path, Path folder) throws IOException {
        XYChart chart = new XYChartBuilder().width(WIDTH).height(HEIGHT).title("Parameters while they are tuned")
            .xAxisTitle("step").yAxisTitle("place in its range, %").build();
        LeaguePlots.style(chart.getStyler());
        chart.getStyler().setXAxisDecimalPattern("#");
        chart.getStyler().setXAxisTickMarkSpacingHint(TICKS);
        chart.getStyler().setYAxisMin(0.0);
        chart.getStyler().setYAxisMax(PERCENT);
        double[] steps = IntStream.range(0, path.size()).asDoubleStream().toArray();
        for (int k = 0; k < command.parameters().size(); k++) {
            int parameter = k;
            chart.addSeries(command.parameters().get(k).name(), steps,
                path.stream().mapToDouble(places -> PERCENT * places[parameter]).toArray())
                .setMarker(SeriesMarkers.NONE);
        }
        Path svg = folder.resolve("tune.svg");
        Path png = folder.resolve("tune.png");
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(svg))) {
            ChartEncoder.saveChart(chart, out, "svg");
        }
        BitmapEncoder.saveBitmapWithDPI(chart, png.toString(), BitmapEncoder.BitmapFormat.PNG, DPI);
        return List.of(png, svg);
    }
}

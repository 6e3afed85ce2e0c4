package steward.lab.stability;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.style.CategoryStyler;
import steward.lab.chart.ChartColours;
import steward.lab.chart.ChartFiles;
import steward.lab.chart.Drawing;
import steward.lab.stability.crowds.TruePathCase;
import steward.lab.trial.Finding;

/** Draws how long a path is true, by the rung and the number of bodies. */
record TruePathPlot(List<StabilityRow> rows) implements Drawing {

    /** The picture for light and for dark pages. */
    static final String PNG = "true-path.png";
    static final String DARK_PNG = "true-path-dark.png";

    private static final int WIDTH = 520;
    private static final int CHART = 340;
    private static final int LINE = 22;
    private static final int SQUARE = 12;
    private static final int PLACE = 130;
    private static final int LEFT = 60;
    private static final int LETTERS = 13;
    private static final double LABELS = 1.06;
    private static final double FILLED = 0.9;
    private static final double ABOVE = 1.15;

    private static final List<Integer> BARS = List.of(0x9AA5B1, 0x56B4E9, 0xC04A00, 0x0072B2, 0x009E73, 0xA3578A);
    private static final List<Integer> DARK_BARS = List.of(0x768390, 0x9BD3F5, 0xFF9B54, 0x56B4E9, 0x2FC79B, 0xE0A3CB);

    private static final Pattern FIGURES = Pattern.compile("(\\d+) discs: (\\d+) impacts, (\\d+) for each");

    /**
     * Turns for which the path of some discs is true.
     *
     * @param impacts of all discs together
     * @param each    of each disc
     */
    record Figure(int discs, int impacts, int each) { }

    /** The figures of a finding, by the number of discs. */
    static List<Figure> figures(Finding seen) {
        return FIGURES.matcher(seen.text()).results().map(found -> new Figure(Integer.parseInt(found.group(1)),
            Integer.parseInt(found.group(2)), Integer.parseInt(found.group(3)))).toList();
    }

    /** The rows of the case among others. */
    static List<StabilityRow> of(List<StabilityRow> all) {
        return all.stream().filter(row -> row.name().equals(TruePathCase.NAME)
            && !figures(row.seen()).isEmpty()).toList();
    }

    /**
     * Writes both pictures into a folder, replacing older ones; nothing if the case was not run.
     *
     * @throws IOException if one cannot be written
     */
    static void write(List<StabilityRow> all, Path folder) throws IOException {
        if (!of(all).isEmpty()) {
            for (ChartColours colours : ChartColours.both()) {
                ChartFiles.png(new TruePathPlot(of(all)), colours, folder.resolve(colours.isDark() ? DARK_PNG : PNG));
            }
        }
    }

    @Override
    public int width() {
        return WIDTH;
    }

    @Override
    public int height() {
        return CHART + LINE * (1 + (rows.size() - 1) / perLine()) + LINE / 2;
    }

    @Override
    public void paint(Graphics2D pen, ChartColours colours) {
        CategoryChart chart = new CategoryChartBuilder().width(WIDTH).height(CHART)
            .xAxisTitle("discs in a box").yAxisTitle("true impacts of each disc").build();
        style(chart.getStyler(), colours);
        double most = 1;
        for (int k = 0; k < rows.size(); k++) {
            List<Figure> figures = figures(rows.get(k).seen());
            Color colour = bar(k, colours);
            chart.addSeries(rows.get(k).rung(), figures.stream().map(Figure::discs).map(String::valueOf).toList(),
                figures.stream().map(Figure::each).toList()).setFillColor(colour);
            most = Math.max(most, figures.stream().mapToInt(Figure::each).max().orElse(0));
        }
        chart.getStyler().setYAxisMax(ABOVE * most);
        chart.paint(pen, WIDTH, CHART);
        legend(pen, colours);
    }

    private static Color bar(int k, ChartColours colours) {
        List<Integer> bars = colours.isDark() ? DARK_BARS : BARS;
        return new Color(bars.get(k % bars.size()));
    }

    private static int perLine() {
        return (WIDTH - LEFT) / PLACE;
    }

    /** That of XChart is cut off where its names do not fit into a line. */
    private void legend(Graphics2D pen, ChartColours colours) {
        pen.setFont(ChartFiles.font(Font.PLAIN, LETTERS));
        for (int k = 0; k < rows.size(); k++) {
            int x = LEFT + k % perLine() * PLACE;
            int y = CHART + (1 + k / perLine()) * LINE;
            pen.setColor(bar(k, colours));
            pen.fillRect(x, y - SQUARE, SQUARE, SQUARE);
            pen.setColor(colours.ink());
            pen.drawString(rows.get(k).rung(), x + SQUARE + SQUARE / 2, y);
        }
    }

    private static void style(CategoryStyler style, ChartColours colours) {
        ChartFiles.style(style, colours, LETTERS);
        style.setLegendVisible(false);
        style.setAvailableSpaceFill(FILLED);
        style.setLabelsVisible(true);
        style.setLabelsPosition(LABELS);
        style.setLabelsFont(ChartFiles.font(Font.PLAIN, LETTERS - 2));
        style.setLabelsFontColorAutomaticEnabled(false);
        style.setLabelsFontColor(colours.ink());
        style.setPlotGridVerticalLinesVisible(false);
        style.setYAxisMin(0.0);
        style.setLocale(Locale.ROOT);
    }
}

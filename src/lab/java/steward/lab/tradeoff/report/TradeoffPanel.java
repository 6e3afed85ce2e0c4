package steward.lab.tradeoff.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import steward.lab.chart.ChartColours;
import steward.lab.chart.ChartFiles;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/** Panel of the trade-off's picture for one scene: its rungs by cost and error, with the spread of the cost. */
record TradeoffPanel(XYChart chart, Axes axes, ChartColours colours) {

    /** An error of 0, and any smaller one, is drawn here: there is no zero on a logarithmic axis. In u. */
    static final double FLOOR = 1e-15;

    private static final String STEP = "step/";
    private static final double MOST = 1e9;
    private static final int MARK = 7;
    private static final float THIN = 0.8f;
    private static final float BAR = 2.4f;
    private static final int LETTERS = 12;
    /** Steps have their number so many decades above and below their mark, in turn. */
    private static final double NUMBER_OFF = 0.9;
    /**
     * Names of rungs with exact times stand one under the other, at this share of the axis, below the marks of steps:
     * the first at this error, each next one so many decades lower.
     */
    private static final double NAMES_AT = 0.8;
    private static final double FIRST_NAME = -5.5;
    private static final double NEXT_NAME = -2.2;
    /** About half the width of a letter, as a share of the axis. */
    private static final double HALF_LETTER = 0.009;
    /** How far apart ticks are, about, in pixels. */
    private static final int TICKS = 110;

    /** The range of all panels, in decades: XChart's logarithmic axes draw too many lines for this many decades. */
    record Axes(double least, double most, double lowest, double highest) {

        static Axes of(List<TradeoffRow> rows) {
            double least = rows.stream().mapToDouble(row -> Math.log10(row.ratioLow())).min().orElse(0);
            double most = rows.stream().mapToDouble(row -> Math.log10(row.ratioHigh())).max().orElse(0);
            double highest = rows.stream().mapToDouble(TradeoffPanel::error).max().orElse(0);
            return new Axes(Math.min(-0.5, least - 0.1), Math.max(1.5, most + 0.1), Math.log10(FLOOR) - 0.5,
                Math.ceil(highest) + 1);
        }

        /** The place at a share of the way along the cost. */
        double at(double share) {
            return least + (most - least) * share;
        }
    }

    static XYChart of(TradeoffResult result, String scene, Axes axes, ChartColours colours) {
        XYChart chart = new XYChartBuilder().width(1).height(1).xAxisTitle("cost of a turn, times that of double")
            .yAxisTitle("error of 99% of the turns, in u").build();
        TradeoffPanel panel = new TradeoffPanel(chart, axes, colours);
        panel.style(chart.getStyler());
        List<TradeoffRow> rows = result.of(scene);
        double demand = Math.log10(TradeoffRow.DEMAND);
        panel.line("demand", axes.least, demand, axes.most, demand, colours.ink())
            .setLineStyle(new BasicStroke(THIN, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {3, 3},
                0));
        panel.names(rows, result.chosen(scene));
        for (TradeoffRow row : rows) {
            panel.line("spread " + row.rung(), Math.log10(row.ratioLow()), error(row), Math.log10(row.ratioHigh()),
                error(row), panel.colour(row)).setLineStyle(new BasicStroke(BAR));
        }
        panel.points("steps", rows.stream().filter(TradeoffPanel::isStep).toList(), colours.steps(),
            SeriesMarkers.CIRCLE);
        panel.points("exact times", rows.stream().filter(row -> !isStep(row)).toList(), colours.events(),
            SeriesMarkers.SQUARE);
        return chart;
    }

    /** Names of exact times are in the order of their errors, so that few of their lines cross. */
    private void names(List<TradeoffRow> rows, TradeoffRow chosen) {
        double y = FIRST_NAME;
        for (TradeoffRow row : rows.stream().filter(row -> !isStep(row)).sorted(Comparator.comparingDouble(
                TradeoffPanel::error).reversed().thenComparing(TradeoffPanel::cost, Comparator.reverseOrder()))
                .toList()) {
            String name = row.shortName() + (row == chosen ? ", chosen" : "");
            line("leader " + row.rung(), cost(row), error(row), axes.at(NAMES_AT - HALF_LETTER * (1 + name.length())),
                y, colours.faint()).setLineStyle(new BasicStroke(THIN));
            chart.addAnnotation(new AnnotationText(name, axes.at(NAMES_AT), y, false));
            y += NEXT_NAME;
        }
        double off = NUMBER_OFF;
        for (TradeoffRow row : rows.stream().filter(TradeoffPanel::isStep).toList()) {
            chart.addAnnotation(new AnnotationText(row.rung().replace(STEP, "") + (row == chosen ? ", chosen" : ""),
                cost(row), error(row) + off, false));
            off = -off;
        }
    }

    private XYSeries line(String name, double x1, double y1, double x2, double y2, Color colour) {
        XYSeries line = chart.addSeries(name, new double[] {x1, x2}, new double[] {y1, y2});
        line.setMarker(SeriesMarkers.NONE).setLineColor(colour);
        return line;
    }

    private void points(String name, List<TradeoffRow> rows, Color colour, Marker marker) {
        if (!rows.isEmpty()) {
            XYSeries points = chart.addSeries(name, rows.stream()
                .mapToDouble(TradeoffPanel::cost).toArray(),
                rows.stream().mapToDouble(TradeoffPanel::error).toArray());
            points.setMarker(marker).setMarkerColor(colour);
            points.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
        }
    }

    private Color colour(TradeoffRow row) {
        return isStep(row) ? colours.steps() : colours.events();
    }

    private static boolean isStep(TradeoffRow row) {
        return row.rung().startsWith(STEP);
    }

    /** In decades. */
    private static double error(TradeoffRow row) {
        return Math.log10(Math.max(FLOOR, Math.min(row.most99(), MOST)));
    }

    /** In decades. */
    private static double cost(TradeoffRow row) {
        return Math.log10(row.costRatio());
    }

    private void style(XYStyler style) {
        ChartFiles.style(style, colours, LETTERS);
        style.setAnnotationTextFont(ChartFiles.font(Font.PLAIN, LETTERS));
        style.setAnnotationTextFontColor(colours.ink());
        style.setLegendVisible(false);
        style.setXAxisMin(axes.least);
        style.setXAxisMax(axes.most);
        style.setYAxisMin(axes.lowest);
        style.setYAxisMax(axes.highest);
        style.setMarkerSize(MARK);
        style.setLocale(Locale.ROOT);
        style.setXAxisTickMarkSpacingHint(TICKS);
        style.setYAxisTickMarkSpacingHint(TICKS / 3);
        style.setXAxisTickLabelsFormattingFunction(decade -> number(decade));
        style.setYAxisTickLabelsFormattingFunction(decade -> decade <= Math.log10(FLOOR) ? "0"
            : "1e" + Math.round(decade));
    }

    /** The number that a tick stands for, with two digits. */
    private static String number(double decade) {
        return new BigDecimal(Math.pow(10, decade)).round(new MathContext(2)).stripTrailingZeros().toPlainString();
    }
}

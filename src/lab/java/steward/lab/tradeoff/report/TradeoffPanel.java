package steward.lab.tradeoff.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/** One scene of the picture: its rungs by cost and error, with the spread of the cost. */
final class TradeoffPanel {

    /** An error of 0, and any smaller one, is drawn here: there is no zero on a logarithmic axis. In u. */
    static final double FLOOR = 1e-15;

    private static final double MOST = 1e9;
    /** Rungs that cost more than so many times the usual one are left out: their errors are known from the others. */
    static final double MOST_COST = 30;
    private static final int MARK = 6;
    private static final float THIN = 0.8f;
    private static final float BAR = 2.4f;
    private static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    /**
     * Names stand right of all marks with exact times, at this share of the axis, so many decades above or below their
     * mark, and below the marks of steps.
     */
    private static final double NAMES_AT = 0.76;
    /** About half the width of a letter, as a share of the axis. */
    private static final double HALF_LETTER = 0.0125;
    private static final double NAME_OFF = 1.4;
    private static final double HIGHEST_NAME = -2.8;
    /** How far apart ticks are, about, in pixels. */
    private static final int TICKS = 110;

    private final XYChart chart;
    private final TradeoffColours colours;
    private final Axes axes;

    /** The range of all panels, in decades: XChart's logarithmic axes draw too many lines for this many decades. */
    record Axes(double least, double most, double lowest, double highest) {

        static Axes of(List<TradeoffRow> rows) {
            double least = rows.stream().mapToDouble(row -> cost(row, row.cost().low())).min().orElse(0);
            double highest = rows.stream().mapToDouble(TradeoffPanel::error).max().orElse(0);
            return new Axes(Math.min(-1, Math.floor(least)), Math.log10(MOST_COST), Math.log10(FLOOR) - 0.5,
                Math.ceil(highest));
        }

        /** The place at a share of the way along the cost. */
        double at(double share) {
            return least + (most - least) * share;
        }
    }

    private TradeoffPanel(XYChart chart, Axes axes, TradeoffColours colours) {
        this.chart = chart;
        this.axes = axes;
        this.colours = colours;
    }

    static XYChart of(TradeoffResult result, String scene, Axes axes, TradeoffColours colours) {
        TradeoffRow usual = result.row(scene, TradeoffRow.DEFAULT_RUNG);
        XYChart chart = new XYChartBuilder().width(1).height(1).title(scene
            + (usual == null ? "" : " (" + TradeoffPage.time(usual.cost().nanosPerTurn()) + ")")).build();
        TradeoffPanel panel = new TradeoffPanel(chart, axes, colours);
        panel.style(chart.getStyler());
        List<TradeoffRow> rows = result.of(scene).stream().filter(row -> row.costRatio() <= MOST_COST).toList();
        double demand = Math.log10(TradeoffRow.DEMAND);
        panel.line("demand", axes.least, demand, axes.most, demand, colours.ink())
            .setLineStyle(new BasicStroke(THIN, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {3, 3},
                0));
        panel.names(usual, result.chosen(scene));
        for (TradeoffRow row : rows) {
            panel.line("spread " + row.rung(), cost(row, row.cost().low()), error(row), cost(row, row.cost().high()),
                error(row), panel.colour(row)).setLineStyle(new BasicStroke(BAR));
        }
        panel.points("steps", rows.stream().filter(TradeoffPanel::isStep).toList(), colours.steps(),
            SeriesMarkers.CIRCLE);
        panel.points("exact times", rows.stream().filter(row -> !isStep(row)).toList(), colours.events(),
            SeriesMarkers.SQUARE);
        return chart;
    }

    /** The name of the rung with the larger error stands above its mark, that of the other below. */
    private void names(TradeoffRow usual, TradeoffRow chosen) {
        if (usual != null) {
            boolean above = chosen == null || error(usual) >= error(chosen);
            name(usual, usual == chosen ? ", chosen" : "", above);
        }
        if (chosen != null && chosen != usual) {
            name(chosen, ", chosen", usual == null || error(chosen) > error(usual));
        }
    }

    private void name(TradeoffRow row, String more, boolean above) {
        double y = above ? Math.min(HIGHEST_NAME, error(row) + NAME_OFF)
            : Math.max(Math.log10(FLOOR), error(row) - NAME_OFF);
        String name = row.rung().replace("event/", "") + more;
        line("leader " + row.rung(), cost(row, row.cost().nanosPerTurn()), error(row),
            axes.at(NAMES_AT - HALF_LETTER * name.length()), y, colours.faint()).setLineStyle(new BasicStroke(THIN));
        chart.addAnnotation(new AnnotationText(name, axes.at(NAMES_AT), y, false));
    }

    private XYSeries line(String name, double x1, double y1, double x2, double y2, Color colour) {
        XYSeries line = chart.addSeries(name, new double[] {x1, x2}, new double[] {y1, y2});
        line.setMarker(SeriesMarkers.NONE).setLineColor(colour);
        return line;
    }

    private void points(String name, List<TradeoffRow> rows, Color colour, Marker marker) {
        if (!rows.isEmpty()) {
            XYSeries points = chart.addSeries(name, rows.stream()
                .mapToDouble(row -> cost(row, row.cost().nanosPerTurn())).toArray(),
                rows.stream().mapToDouble(TradeoffPanel::error).toArray());
            points.setMarker(marker).setMarkerColor(colour);
            points.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
        }
    }

    private Color colour(TradeoffRow row) {
        return isStep(row) ? colours.steps() : colours.events();
    }

    private static boolean isStep(TradeoffRow row) {
        return row.rung().startsWith("step/");
    }

    /** In decades. */
    private static double error(TradeoffRow row) {
        return Math.log10(Math.max(FLOOR, Math.min(row.most99(), MOST)));
    }

    /** A time of the row as a multiple of the time of the usual rung, in decades. */
    private static double cost(TradeoffRow row, double nanos) {
        return Math.log10(row.costRatio() * nanos / row.cost().nanosPerTurn());
    }

    private void style(XYStyler style) {
        style.setChartBackgroundColor(colours.background());
        style.setPlotBackgroundColor(colours.background());
        style.setPlotBorderColor(colours.grid());
        style.setChartFontColor(colours.ink());
        style.setAxisTickLabelsColor(colours.ink());
        style.setAxisTickMarksColor(colours.grid());
        style.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 13));
        style.setChartTitleBoxVisible(false);
        style.setAxisTickLabelsFont(SMALL);
        style.setAnnotationTextFont(SMALL);
        style.setAnnotationTextFontColor(colours.ink());
        style.setLegendVisible(false);
        style.setPlotGridLinesColor(colours.grid());
        style.setPlotGridLinesStroke(new BasicStroke(THIN));
        style.setChartPadding(4);
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

package steward.lab.tradeoff.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.lab.tradeoff.TradeoffHeadings;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/**
 * Published pages of the measured trade-off, in {@code docs}: page and table are of one run, every sentence follows
 * from the columns, and columns agree with each other. A page that was changed by hand fails: {@code steward tradeoff
 * --out docs --overwrite} makes it anew.
 */
class PublishedTradeoffTest {

    private static final Path DOCS = Path.of("docs");
    private static final Pattern WRITTEN = Pattern.compile("Written by `steward tradeoff` on ([0-9-]+): (.*)\\.\n");
    private static final Pattern HEADINGS = Pattern.compile(
        "\\| (random|axis-aligned) \\| ([0-9,]+) \\| ([0-9,]+) \\| ([0-9.]+) ns \\| ([0-9.]+) ns \\|\n");

    private static TradeoffResult published(String page) throws IOException {
        Matcher written = WRITTEN.matcher(page);
        assertTrue(written.find(), "when and where it was measured");
        List<TradeoffHeadings> headings = new ArrayList<>();
        for (Matcher row = HEADINGS.matcher(page); row.find();) {
            headings.add(new TradeoffHeadings(row.group(1), whole(row.group(2)), whole(row.group(3)),
                Double.parseDouble(row.group(4)), Double.parseDouble(row.group(5))));
        }
        return new TradeoffResult(written.group(2), written.group(1),
            TradeoffTables.rows(Files.readString(DOCS.resolve(TradeoffReport.CSV))), headings);
    }

    private static long whole(String text) {
        return Long.parseLong(text.replace(",", ""));
    }

    @Test
    void thePageIsWhatTheTableSays() throws IOException {
        String page = Files.readString(DOCS.resolve(TradeoffReport.PAGE));
        assertEquals(TradeoffPage.text(published(page)), page);
    }

    /** A ratio is that of two times of the table; medians lie in their spread; every rung has JVMs of its own. */
    @Test
    void theColumnsAgreeWithEachOther() throws IOException {
        TradeoffResult result = published(Files.readString(DOCS.resolve(TradeoffReport.PAGE)));
        for (TradeoffRow row : result.rows()) {
            double usual = result.row(row.scene(), TradeoffRow.DEFAULT_RUNG).cost().nanosPerTurn();
            assertEquals(row.cost().nanosPerTurn() / usual, row.costRatio(), 1e-12, row.toString());
            assertTrue(row.cost().low() <= row.cost().nanosPerTurn()
                && row.cost().nanosPerTurn() <= row.cost().high(), row.toString());
            assertTrue(row.jvms() >= 3, row.toString());
        }
    }

    private static TradeoffRow row(String scene, String rung, double nanos, double error, int wrong) {
        return new TradeoffRow(scene, rung, 100, 50, 3, 21,
            new TradeoffRow.Cost(nanos, nanos, nanos, nanos, 0), nanos / 80, 0, error, error, wrong, 0, 0, 9, 8, 0, 400,
            true);
    }

    /** A sentence that the figures do not bear out is not there. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "30 | 0 | 0 | 2 | The server's results, Any other scene, Where a graze decides, A search",
        "95 | 0 | 0 | 2 | The server's results, Any other scene, Where a graze decides",
        "30 | 9 | 0 | 2 | The server's results, Where a graze decides, A search",
        "30 | 0 | 2 | 2 | The server's results, Any other scene, A search"})
    void aSentenceStandsOnlyWhereTheFiguresBearItOut(double step, int wrongInRaces, int exactWrong, int othersWrong,
                                                     String sentences) {
        List<TradeoffRow> rows = new ArrayList<>();
        for (String scene : List.of(TradeoffPage.RACE, TradeoffPage.GRAZING)) {
            boolean race = scene.equals(TradeoffPage.RACE);
            rows.add(row(scene, "step/1", step, 100, 3));
            rows.add(row(scene, "event/official", 90, 1e-5, 1));
            rows.add(row(scene, "event/double", 80, 1e-5, race ? wrongInRaces : othersWrong));
            rows.add(row(scene, "event/compensated", 100, 1e-5, othersWrong));
            rows.add(row(scene, "event/exact", 120, 0, exactWrong));
        }
        String page = TradeoffPage.text(new TradeoffResult("m", "2030-01-02", rows, List.of(
            new TradeoffHeadings("random", 10, 0, 20, 30), new TradeoffHeadings("axis-aligned", 10, 0, 20, 30))));
        List<String> found = Pattern.compile("(?m)^[1-5]\\. \\*\\*([^*]+)\\*\\*").matcher(page).results()
            .map(match -> match.group(1)).toList();
        assertEquals(sentences, String.join(", ", found), page.toLowerCase(Locale.ROOT));
    }
}

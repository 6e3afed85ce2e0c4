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
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/**
 * Published pages of the measured trade-off, in {@code docs}: page and table are of one run, every sentence follows
 * from the columns, and columns agree with each other. How the page must be is left in {@code build/pages}; after
 * {@code steward tradeoff --out docs --overwrite} date and machine in it are those of {@code tradeoff.json}.
 */
class PublishedTradeoffTest {

    private static final Path DOCS = Path.of("docs");
    private static final String PAGE = "tradeoff.md";
    private static final Pattern WRITTEN = Pattern.compile("Written by `steward tradeoff` on ([0-9-]+): (.*)\\.\n");

    private static TradeoffResult published(String page) throws IOException {
        Matcher written = WRITTEN.matcher(page);
        assertTrue(written.find(), "when and where it was measured");
        return new TradeoffResult(written.group(2), written.group(1),
            TradeoffTables.rows(Files.readString(DOCS.resolve(TradeoffReport.CSV))));
    }

    /** How the page must be is left in {@code build/pages}. */
    @Test
    void thePageIsWhatTheTableSays() throws IOException {
        String page = Files.readString(DOCS.resolve(PAGE));
        String expected = TradeoffPage.text(published(page));
        Files.createDirectories(Path.of("build/pages"));
        Files.writeString(Path.of("build/pages", PAGE), expected);
        assertEquals(expected, page);
    }

    /** Each scene of the first table leads to its full table, and that to its panel. */
    @Test
    void everyLinkLeadsToAHeading() throws IOException {
        String page = Files.readString(DOCS.resolve(PAGE));
        List<String> headings = page.lines().filter(line -> line.startsWith("#"))
            .map(line -> "#" + TradeoffAdvice.anchor(line.replaceFirst("#+ ", ""))).toList();
        List<String> links = Pattern.compile("\\((#[^)]+)\\)").matcher(page).results().map(link -> link.group(1))
            .distinct().toList();
        assertTrue(headings.containsAll(links), links + " among " + headings);
        for (String scene : published(page).scenes()) {
            assertTrue(links.contains("#" + TradeoffAdvice.anchor(scene)), scene);
        }
    }

    /** A ratio is that of two times of the table, and within its range; every rung has JVMs of its own,
     * unless the page says that it was made in haste. */
    @Test
    void theColumnsAgreeWithEachOther() throws IOException {
        String page = Files.readString(DOCS.resolve(PAGE));
        boolean quick = page.contains("These figures may not be quoted");
        TradeoffResult result = published(page);
        for (TradeoffRow row : result.rows()) {
            double usual = result.row(row.scene(), TradeoffRow.DEFAULT_RUNG).cost().nanosPerTurn();
            assertEquals(row.cost().nanosPerTurn() / usual, row.costRatio(), 1e-12, row.toString());
            assertTrue(row.cost().low() <= row.cost().nanosPerTurn()
                && row.cost().nanosPerTurn() <= row.cost().high(), row.toString());
            assertTrue(row.ratioLow() <= row.costRatio() && row.costRatio() <= row.ratioHigh(), row.toString());
            assertTrue(quick || row.jvms() >= 3 && row.states() >= 20, row.toString());
        }
    }

    private static TradeoffRow row(String scene, String rung, double nanos, double error, int wrong) {
        return new TradeoffRow(scene, rung, 100, 50, 3, 21,
            new TradeoffRow.Cost(nanos, nanos, nanos, nanos, 0), nanos / 80, nanos / 100,
            nanos / 70, 0, error, error, wrong, 0, 0, 9, 8, 0, 400,
            true);
    }

    private static List<TradeoffRow> scene(double officialHigh, int doubleWrong) {
        List<TradeoffRow> rows = new ArrayList<>();
        rows.add(row("bowl", "step/1", 30, 1, 3));
        TradeoffRow official = row("bowl", "event/official", 60, 1e-5, 0);
        rows.add(new TradeoffRow("bowl", official.rung(), 100, 50, 3, 21, official.cost(), 0.75, 0.7, officialHigh, 0,
            1e-5, 1e-5, 0, 0, 0, 9, 8, 0, 0, true));
        rows.add(row("bowl", "event/double", 80, 1e-6, doubleWrong));
        rows.add(row("bowl", "event/compensated", 82, 1e-7, 0));
        rows.add(row("bowl", "event/exact", 130, 0, 0));
        return rows;
    }

    /** The default is chosen unless another is cheaper in every JVM, or it decides wrongly; steps never meet it. */
    @ParameterizedTest
    @CsvSource({"0.9, 0, official", "1.1, 0, double", "0.9, 1, official", "1.1, 1, official"})
    void theTableNamesTheDefaultUnlessAnotherSuits(double officialHigh, int doubleWrong, String rung) {
        TradeoffResult result = new TradeoffResult("m", "2030-01-02", scene(officialHigh, doubleWrong));
        assertEquals("event/" + rung, result.chosen("bowl").rung());
        String page = TradeoffPage.text(result);
        assertTrue(page.indexOf("| [bowl](#bowl) | `" + rung + "` | 0 of 50 | ") < page.indexOf("Written by"), page);
        assertTrue(page.contains("`steward tradeoff --quick --scene bowl --scene my-scene.json`"), page);
    }

    /** Steps beyond the front are said to be: here from 2 on, since only 1 is on it. */
    @Test
    void stepsThatAreNeverOnTheFrontAreNamed() {
        List<TradeoffRow> rows = new ArrayList<>(scene(0.9, 0));
        rows.add(1, beaten("step/2"));
        rows.add(2, beaten("step/4"));
        String page = TradeoffPage.text(new TradeoffResult("m", "2030-01-02", rows));
        assertTrue(page.contains("**`step/2` and more** are never on the front"), page);
        assertTrue(page.contains("` on bowl has the widest range of the rungs that cost at least a tenth of `double`"),
            page);
    }

    private static TradeoffRow beaten(String rung) {
        TradeoffRow row = row("bowl", rung, 90, 1, 3);
        return new TradeoffRow("bowl", rung, 100, 50, 3, 21, row.cost(), row.costRatio(), row.ratioLow(),
            row.ratioHigh(), 0, 1, 1, 3, 0, 0, 9, 8, 0, 0, false);
    }

    /** A sentence that the figures do not bear out is not there. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "30 | 0 | 0 | 2 | The default, The server's results, If a graze decides, A search, A price is a range",
        "95 | 0 | 0 | 2 | The default, The server's results, If a graze decides, A price is a range",
        "30 | 9 | 0 | 2 | The server's results, If a graze decides, A search, A price is a range",
        "30 | 0 | 2 | 2 | The default, The server's results, A search, A price is a range"})
    void aSentenceStandsOnlyWhereTheFiguresBearItOut(double step, int wrongInRaces, int exactWrong, int othersWrong,
                                                     String sentences) {
        List<TradeoffRow> rows = new ArrayList<>();
        for (String scene : List.of(TradeoffAdvice.RACE, TradeoffAdvice.GRAZING)) {
            boolean race = scene.equals(TradeoffAdvice.RACE);
            rows.add(row(scene, "step/1", step, 100, 3));
            rows.add(row(scene, "event/official", 90, 1e-5, 1));
            rows.add(row(scene, "event/double", 80, 1e-5, race ? wrongInRaces : othersWrong));
            rows.add(row(scene, "event/compensated", 100, 1e-5, exactWrong));
            rows.add(row(scene, "event/exact", 120, 0, exactWrong));
        }
        String page = TradeoffPage.text(new TradeoffResult("m", "2030-01-02", rows));
        List<String> found = Pattern.compile("(?m)^[1-7]\\. \\*\\*([^*]+)\\*\\*").matcher(page).results()
            .map(match -> match.group(1)).toList();
        assertEquals(sentences, String.join(", ", found), page.toLowerCase(Locale.ROOT));
    }
}

package steward.lab.capacity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.lab.capacity.SaturationTable.Row;
import steward.machines.serve.RemoteGames;

/** The manual's figures of how many workers a league can serve follow from the prices that it prints. */
class CapacityDocsTest {

    private static final int WORKERS = 1000;
    private static final double PER_SECOND = 20;
    private static final String BEGIN = "<!-- capacity -->\n";

    private static String printed() throws IOException {
        String page = Files.readString(Path.of("docs/tables/capacity.md"));
        return page.substring(page.indexOf(BEGIN) + BEGIN.length(), page.indexOf("<!-- /capacity -->"));
    }

    private static double figure(String text, String pattern) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertTrue(matcher.find(), () -> "found nothing like " + pattern + " in " + text);
        return Double.parseDouble(matcher.group(1).replace(",", ""));
    }

    private static double price(String text, int row) {
        return figure(text, "(?m)^\\| " + Pattern.quote(CapacityText.PRICES.get(row)) + "[^|]*\\| ([0-9,]+) \\|$");
    }

    private static LeagueCosts costs(String text) {
        return new LeagueCosts(price(text, 0), price(text, 1), price(text, 2), price(text, 3),
            figure(text, "in ([0-9.]+)% of the games") / 100, price(text, 4), price(text, 5));
    }

    private static int processors(String text) {
        return (int) figure(text, "a machine with ([0-9]+) processors");
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 200})
    @Tag("slow")
    void aRowFollowsFromThePrices(int workers) throws IOException {
        String text = printed();
        String row = CapacityText.row(Row.of(costs(text), processors(text), workers, PER_SECOND, RemoteGames.MOST));
        assertTrue(text.contains("\n" + row + "\n"), () -> "found\n" + text + "\nexpected\n" + row);
    }

    @Test
    @Tag("campaign")
    void theTablesFollowFromThePrices() throws IOException {
        String text = printed();
        LeagueCosts costs = costs(text);
        List<String> lines = CapacityText.simulation(SaturationTable.of(costs, processors(text), WORKERS, PER_SECOND,
            RemoteGames.MOST, () -> { }));
        String expected = String.join("\n", lines);
        assertTrue(text.contains(expected), () -> "found\n" + text + "\nexpected\n" + expected);
        assertEquals(Math.rint(costs.total()), figure(text, "together, for a game on average \\| ([0-9,]+)"));
    }
}

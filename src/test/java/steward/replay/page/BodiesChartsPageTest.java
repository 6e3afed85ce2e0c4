package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.cli.Cli;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The page of a break: its charts have the numbers of {@code steward run}, and a ball in a pocket is gone. */
@Tag("slow")
class BodiesChartsPageTest extends PageTestCase {

    private static final String CHARTS = """
        const text = element => element?.textContent ?? '';
        const all = (selector, root = document) => [...root.querySelectorAll(selector)];
        return JSON.stringify(Object.fromEntries(all('.chart-card').map(card =>
          [text(card.querySelector('figcaption span')), all('.chart-values b', card).map(text)])));
        """;
    private static final String BODIES = "return JSON.stringify(steward.bodies().map(body => body.id))";
    /** Columns of a run by the chart that shows them. */
    private static final Map<String, String[]> COLUMNS = Map.of("Kinetic energy", new String[] {"energy"},
        "Momentum", new String[] {"momentumX", "momentumY"}, "Angular momentum", new String[] {"angularMomentum"},
        "Temperature", new String[] {"temperature"}, "Pressure", new String[] {"pressureWalls", "pressureVirial"},
        "Impacts", new String[] {"impacts"});

    /** Whole numbers above 100, at least two decimals below. */
    @Test
    void chartsHaveTheNumbersOfTheRun() {
        Path page = folder.resolve("break.html");
        assertEquals(0, Cli.run("run", "docs/scenes/break.json", "--seed", "1", "--view", page.toString()).status());
        Cli run = Cli.run("run", "docs/scenes/break.json", "--seed", "1", "--json").done();
        JsonNode rows = JsonMapper.shared().readTree(run.out()).get("rows");
        browser.open(page, "#t=0");
        int gone = 0;
        for (int turn : new int[] {3, 10, rows.size() - 1}) {
            browser.run("steward.seek(0, 1); steward.seek(arguments[0])", turn);
            JsonNode charts = JsonMapper.shared().readTree((String) browser.run(CHARTS));
            assertEquals(COLUMNS.keySet(), Set.copyOf(charts.propertyNames()));
            COLUMNS.forEach((title, columns) -> {
                for (int k = 0; k < columns.length; k++) {
                    double expected = rows.get(turn).get(columns[k]).asDouble();
                    String shown = charts.get(title).get(k).asString().replaceAll("[^0-9.e−-]", "").replace('−', '-');
                    assertEquals(expected, Double.parseDouble(shown), Math.abs(expected) >= 100 ? 0.51 : 0.0051,
                        title + " of turn " + turn);
                }
            });
            gone = 16 - JsonMapper.shared().readTree((String) browser.run(BODIES)).size();
        }
        assertEquals(3, gone);
    }
}

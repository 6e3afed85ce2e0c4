package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.replay.Recorded;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * All numbers of the page at ten moments of a match, every second of them within a turn: each is that of the moment, or
 * says of which turn it is, and is that of the replay.
 */
@Tag("slow")
class OneInstantPageTest extends PageTestCase {

    private static final int MOMENTS = 10;
    private static final double WITHIN = 0.66;
    /** Half of the last digit that a number of the state has, and of one that is grouped. */
    private static final double DIGIT = 0.00051;
    private static final double GROUPED = 0.0051;

    private List<JsonNode> lines;

    @Test
    void everyNumberOfMeanMaxIsOfTheMomentOrSaysOfWhich() {
        assertEveryNumberIsOfTheMoment("mean-max");
    }

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "search-race", "mean-max", "fantastic-bits", "poker-chip-race",
        "billiards"})
    @Tag("campaign")
    void everyNumberIsOfTheMomentOrSaysOfWhich(String name) {
        assertEveryNumberIsOfTheMoment(name);
    }

    private void assertEveryNumberIsOfTheMoment(String name) {
        GameSetup setup = TestScenes.open(name);
        Recorded match = Recorded.of(setup, 7,
            EveryScenePageTest.bots(setup.scene().gameId(), setup.scene().players()));
        lines = PageTestRaces.lines(match.bytes());
        browser.open(pages.page(match.bytes(), name), "#t=0");
        int last = lines.size() - 2;
        for (int k = 0; k < MOMENTS; k++) {
            double time = Math.min(last, k * last / (MOMENTS - 1) + (k % 2 == 0 ? 0 : WITHIN));
            browser.run("steward.seek(0, 1); steward.seek(arguments[0])", time);
            JsonNode page = JsonMapper.shared().readTree((String) browser.run(NUMBERS));
            String at = name + " at " + time + ": ";
            assertEquals((int) Math.floor(time), Integer.parseInt(page.get("clock").asString()), at + "clock");
            assertEquals(time == 0 ? "Start" : "Turn " + (int) Math.ceil(time), page.get("turn").asString(), at);
            assertEquals(time, page.get("time").asDouble(), 0.005, at);
            assertState(page, time, at);
            assertScores(name, page.get("scores"), state(time), at);
            assertCharts(page.get("charts"), time, at);
            assertSpeeds(page.get("speeds"), time, at);
        }
    }

    /** The state after the last turn that is whole. */
    private JsonNode state(double time) {
        int turn = (int) Math.floor(time);
        return turn == 0 ? lines.get(0).get("start").get("state") : lines.get(turn).get("outcome").get("state");
    }

    private JsonNode hash(double time) {
        int turn = (int) Math.floor(time);
        return turn == 0 ? lines.get(0).get("start").get("hash") : lines.get(turn).get("outcome").get("hash");
    }

    /** Every number of the table, and the hash; within a turn the caption says so, and places are between both ends. */
    private void assertState(JsonNode page, double time, String at) {
        boolean isWithin = time > Math.floor(time);
        String when = page.get("when").asString();
        String whole = time < 1 ? "at the start" : "at the end of turn " + (int) Math.floor(time);
        assertEquals(isWithin ? String.format(Locale.ROOT, "places at %.2f, the rest ", time) + whole : whole, when);
        assertEquals(hash(time).asString(), page.get("hash").asString(), at + "hash");
        int compared = 0;
        for (JsonNode body : state(time).get("bodies")) {
            JsonNode row = page.get("state").path(body.get("id").asString());
            JsonNode later = isWithin ? find(state(time + 1), body.get("id").asInt()) : body;
            if (isWithin && row.isMissingNode()) {
                continue;                                    // it ceases to be before the moment
            }
            for (var field : body.properties()) {
                boolean isPlace = isWithin && (field.getKey().equals("x") || field.getKey().equals("y"));
                if (!isPlace && field.getValue().isNumber() && !Set.of("id", "heading").contains(field.getKey())) {
                    compared++;
                    assertEquals(field.getValue().asDouble(), Double.parseDouble(row.get(field.getKey()).asString()),
                        DIGIT, at + body.get("id") + " " + field.getKey());
                }
            }
            boolean isStraight = isWithin && later != null
                && !lines.get((int) Math.ceil(time)).get("outcome").has("paths");
            if (isStraight) {
                double share = time - Math.floor(time);
                assertEquals(body.get("x").asDouble() * (1 - share) + later.get("x").asDouble() * share,
                    row.get("x").asDouble(), DIGIT, at + body.get("id") + " x");
            }
        }
        assertTrue(compared > 0, at + "nothing was compared");
    }

    private static JsonNode find(JsonNode state, int id) {
        for (JsonNode body : state.get("bodies")) {
            if (body.get("id").asInt() == id) {
                return body;
            }
        }
        return null;
    }

    /** What stands over the field for each player. */
    private static void assertScores(String game, JsonNode shown, JsonNode state, String at) {
        for (int player = 0; player < shown.size(); player++) {
            String text = shown.get(player).asString();
            int number = player;
            String expected = switch (game) {
                case "mad-pod-racing" -> IntStream.range(0, 4)
                    .filter(pod -> state.get("bodies").get(pod).get("player").asInt() == number)
                    .map(pod -> state.get("bodies").get(pod).get("passed").asInt()).max().orElseThrow() + " of ";
                case "search-race" -> state.get("bodies").get(0).get("passed").asInt() + " of ";
                case "mean-max" -> state.get("scores").get(player).asInt() + " water|"
                    + state.get("rages").get(player).asInt() + " rage";
                case "fantastic-bits" -> state.get("scores").get(player).asInt() + " goal";
                default -> "";
            };
            for (String part : expected.split("\\|")) {
                assertTrue(text.contains("|" + part), at + "player " + player + ": " + text + ", not " + part);
            }
        }
    }

    /** The values beside the titles of charts, which say of which turn they are. */
    private void assertCharts(JsonNode charts, double time, String at) {
        for (JsonNode chart : charts) {
            String title = chart.get("title").asString();
            boolean isOfTurn = List.of("Answer time", "Impacts", "Pressure").contains(title);
            assertEquals(isOfTurn ? "in " + (int) Math.ceil(time) : "after " + (int) Math.floor(time),
                chart.get("when").asString(), at + title);
            for (int k = 0; k < chart.get("values").size(); k++) {
                double expected = switch (title) {
                    case "Goals", "Water" -> state(time).get("scores").get(k).asDouble();
                    case "Rage" -> state(time).get("rages").get(k).asDouble();
                    case "Magic" -> state(time).get("magic").get(k).asDouble();
                    case "Speed" -> speed(time, k);
                    default -> Double.NaN;
                };
                String value = chart.get("values").get(k).asString();
                boolean isTold = !value.equals("–");     // the start tells no resources; who is eaten has no speed
                assertTrue(isTold || time < 1 || expected == 0, at + title + " is not told");
                if (!Double.isNaN(expected) && isTold) {
                    assertEquals(expected, Double.parseDouble(value.replace("\u2009", "")),
                        expected >= 100 ? 0.5 : GROUPED, at + title);
                }
            }
        }
    }

    /** The speed of a player's fastest body after the last whole turn. */
    private double speed(double time, int player) {
        double most = 0;
        for (JsonNode body : state(time).get("bodies")) {
            int owner = body.path("player").asInt(owner(body.get("id").asInt()));
            if (owner == player) {
                most = Math.max(most, Math.hypot(body.get("vx").asDouble(), body.get("vy").asDouble()));
            }
        }
        return most;
    }

    private int owner(int id) {
        for (JsonNode body : lines.get(0).get("drawing").get("bodies")) {
            if (body.get("id").asInt() == id) {
                return body.path("owner").asInt(-1);
            }
        }
        return -1;
    }

    /** At the end of a turn speeds are those of the state; within one without impacts those of its flight. */
    private void assertSpeeds(JsonNode speeds, double time, String at) {
        boolean isWithin = time > Math.floor(time);
        if (isWithin && lines.get((int) Math.ceil(time)).get("outcome").has("paths")) {
            return;
        }
        for (var row : speeds.properties()) {
            int id = Integer.parseInt(row.getKey());
            JsonNode body = find(state(time), id);
            JsonNode later = isWithin ? find(state(time + 1), id) : null;
            if (body == null || isWithin && later == null) {
                continue;
            }
            double expected = isWithin ? Math.hypot(later.get("x").asDouble() - body.get("x").asDouble(),
                later.get("y").asDouble() - body.get("y").asDouble())
                : Math.hypot(body.get("vx").asDouble(), body.get("vy").asDouble());
            assertEquals(expected, Double.parseDouble(row.getValue().asString().replace("\u2009", "")),
                expected >= 100 ? 0.5 : GROUPED, at + "speed of " + id);
        }
    }

    /** All numbers of the page, as text of JSON. */
    private static final String NUMBERS = """
        const text = element => element?.textContent ?? '';
        const all = (selector, root = document) => [...root.querySelectorAll(selector)];
        const rows = all('#state tr').map(row => [...row.children].map(text));
        const state = {};
        const isAcross = rows[1]?.[0] !== undefined && isNaN(rows[1][0]);
        rows.slice(1).forEach(([name, ...values]) => values.forEach((value, k) => {
          const [id, field] = isAcross ? [rows[0][k + 1], name] : [name, rows[0][k + 1]];
          (state[id] ??= {})[field] = value;
        }));
        const rest = Object.fromEntries(all('#state dt').map(term => [text(term), text(term.nextElementSibling)]));
        return JSON.stringify({
          clock: text(document.querySelector('.clock b')), turn: text(document.getElementById('turn-shown')),
          time: text(document.getElementById('time')), when: text(document.getElementById('state-when')), state,
          hash: rest.hash,
          scores: all('.score').map(cell => '|' + all('span', cell).map(text).join('|')),
          charts: all('.chart-card').map(card => ({ title: text(card.querySelector('figcaption span')),
            when: text(card.querySelector('.chart-values small')), values: all('.chart-values b', card).map(text) })),
          speeds: Object.fromEntries(all('.body-row').map(row =>
            [row.title.match(/ (\\d+);/)[1], text(row.querySelector('.speed-of'))])),
        });
        """;
}

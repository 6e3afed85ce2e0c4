package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.fantasticbits.Captain;
import steward.bots.meanmax.Marauder;
import steward.bots.pokerchiprace.Glutton;
import steward.bots.searchrace.Planner;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.scene.SceneFiles;
import tools.jackson.databind.JsonNode;

/** The page of a match of every shipped scene, as the program writes it: every body is seen where its state says. */
@Tag("slow")
class EveryScenePageTest extends PageTestCase {

    /** Turns that are played: enough to move and to meet. */
    private static final String BRIEF = "12";
    /** Shares of a body's pixels that it must have drawn, and that must have its colour: a hull is not all of it. */
    private static final double DRAWN = 0.3;
    private static final double COLOURED = 0.05;

    static Stream<String> scenes() {
        return SceneFiles.shipped().stream();
    }

    @ParameterizedTest
    @ValueSource(strings = {"cradle", "mean-max"})
    void aBodyIsSeenWhereItsStateSays(String name) {
        assertPageShows(name);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    @Tag("campaign")
    void everyBodyIsSeenWhereItsStateSays(String name) {
        assertPageShows(name);
    }

    private static void assertPageShows(String name) {
        String text = TestScenes.text(name).replaceFirst("\"maximumTurns\": \\d+", "\"maximumTurns\": " + BRIEF);
        GameSetup setup = TestScenes.TYPES.open(text, name);
        Recorded match = Recorded.of(setup, 7, bots(setup.scene().gameId(), setup.scene().players()));
        Path page = pages.page(match.bytes(), name, PageExtras.of(TestScenes.TYPES));
        List<JsonNode> lines = PageTestRaces.lines(match.bytes());
        browser.open(page, "#t=0");
        assertEquals("", browser.text("#notice"));
        browser.run("document.querySelectorAll('[data-show]:checked').forEach(box => box.click())");
        for (int turn : new int[] {0, lines.size() / 2, lines.size() - 2}) {
            JsonNode state = turn == 0 ? lines.get(0).get("start").get("state") : lines.get(turn).get("outcome")
                .get("state");
            assertEverybodyIsSeen(name, lines.get(0).get("drawing"), state.get("bodies"), turn);
        }
    }

    /** In the cradle four balls rest and one flies; what has a colour of its own keeps it. No pill waits for scores. */
    @Test
    void ballsHaveTheColourOfTheirSpeedAndTheTimelineTheirEnergy() {
        byte[] match = Recorded.of(TestScenes.open("cradle"), 7, List.of()).bytes();
        browser.open(pages.page(match, "Cradle"), "#t=9.5");
        assertEquals("2 true true true", browser.run("""
            const canvas = document.getElementById('field');
            const { left, top } = canvas.getBoundingClientRect();
            const colours = steward.bodies().filter(({ id }) => id > 0).map(({ x, y, radius }) =>
              canvas.getContext('2d').getImageData(x - left + 0.7 * radius, y - top, 1, 1).data.join());
            const marks = document.getElementById('marks');
            const strip = marks.getContext('2d').getImageData(marks.width / 2, 10, 40, 20).data;
            const has = player => {
              const wanted = steward.colourOf(player).match(/[0-9a-f]{2}/g).map(hex => parseInt(hex, 16));
              return strip.some((_, k) => k % 4 === 0
                && wanted.every((value, c) => Math.abs(value - strip[k + c]) < 9));
            };
            return [new Set(colours).size, colours[4] !== colours[0], has(1),
              document.getElementById('scores').offsetWidth < 150].join(' ');
            """));
    }

    /** Bots that play a game; a game without any here fails, and one without players has none. */
    static List<Bot> bots(String game, int players) {
        return Stream.generate(() -> switch (game) {
            case "pod-race" -> new PageTestBot();
            case "search-race" -> BundledBots.of(new Planner());
            case "mean-max" -> BundledBots.of(new Marauder());
            case "fantastic-bits" -> BundledBots.of(new Captain());
            case "poker-chip-race" -> BundledBots.of(new Glutton());
            default -> throw new AssertionError("no bot of " + game + " is known here");
        }).limit(players).map(Bot.class::cast).toList();
    }

    /** The middle of each body differs from the picture without bodies, and has its colour if it has one. */
    @SuppressWarnings("unchecked")
    private static void assertEverybodyIsSeen(String scene, JsonNode drawing, JsonNode bodies, int turn) {
        browser.seek(turn, 1);
        List<Map<String, Object>> seen = (List<Map<String, Object>>) browser.run(SEEN, bodies.toString(),
            drawing.toString());
        assertEquals(bodies.size(), seen.size());
        for (Map<String, Object> body : seen) {
            double drawn = ((Number) body.get("drawn")).doubleValue();
            double coloured = ((Number) body.get("coloured")).doubleValue();
            assertTrue(drawn > DRAWN && coloured > COLOURED, () -> scene + ", turn " + turn + ": " + body);
        }
    }

    /**
     * Per body of a state the shares of its pixels that it has drawn, and that have the colour of its owner or its own,
     * in the light or in the shade; 1 if it has neither. Its place on the canvas follows from the state and from the
     * corners of the field.
     */
    private static final String SEEN = """
        const [bodies, drawing] = [...arguments].map(text => JSON.parse(text));
        const canvas = document.getElementById('field');
        const [{ left, top }, corners] = [canvas.getBoundingClientRect(), steward.field()];
        const scale = (corners.right - corners.left) / drawing.field.width;
        const picture = () => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        const whole = picture();
        steward.hide('drawBody');
        const empty = picture();
        steward.hide('drawBody', false);
        const known = new Map((drawing.bodies ?? []).map(each => [each.id, each]));
        const pixelsOf = (x, y, radius) => {
          const found = [];
          for (let row = Math.ceil(y - radius); row <= y + radius; row++) {
            for (let column = Math.ceil(x - radius); column <= x + radius; column++) {
              if (Math.hypot(column - x, row - y) <= radius) found.push(4 * (row * canvas.width + column));
            }
          }
          return found;
        };
        return bodies.map(body => {
          const { owner, colour, radius } = { ...known.get(body.id), ...body };
          const player = body.player ?? owner;
          const x = corners.left - left + scale * (body.x - drawing.field.x);
          const y = corners.top - top + scale * (body.y - drawing.field.y);
          const isNobodys = player === undefined || player === null;
          if (isNobodys && (y < 0 || y > canvas.height)) return { drawn: 1, coloured: 1 };     // it comes and goes
          const pixels = pixelsOf(x, y, Math.max(1.5, scale * radius));
          const far = (k, wanted, light = 1) => Math.hypot(...[0, 1, 2].map(c => whole[k + c] - light * wanted[c]));
          const isNear = (k, wanted) => [1, 0.85, 0.7, 0.55, 0.4].some(light => far(k, wanted, light) < 60);
          const share = holds => pixels.filter(holds).length / pixels.length;
          const wanted = (colour ?? (isNobodys ? null : steward.colourOf(player)))
            ?.match(/[0-9a-f]{2}/g).map(hex => parseInt(hex, 16));
          return { id: body.id, x: body.x, y: body.y, drawn: share(k => far(k, empty.slice(k, k + 3)) > 6),
            coloured: wanted ? share(k => isNear(k, wanted)) : 1 };
        });
        """;
}

package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.bots.BundledBots;
import steward.bots.meanmax.Gatherer;
import steward.bots.meanmax.Marauder;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** The camera at rest: what matters of a match is in view, whatever happens, and no number covers a unit. */
@Tag("slow")
class CameraPageTest extends PageTestCase {

    /** Bots that ram each other throw their pods out of the field; seen at moments in and between turns. */
    @Test
    void aPodThatLeavesTheFieldStaysInViewAndIsNotUnderTheScores() {
        byte[] race = Recorded.of(TestScenes.open("mad-pod-racing"), 5,
            List.of(new SeededBot(1, 0.9), new SeededBot(2, 0.9))).bytes();
        browser.open(pages.page(race, "Ramming"), "#t=0");
        String found = (String) browser.run("""
            const canvas = document.getElementById('field').getBoundingClientRect();
            const top = document.getElementById('scores').getBoundingClientRect().bottom;
            const [hidden, left] = [[], []];
            for (let time = 0; time <= Math.min(steward.lastTurn(), 120); time += 4 / 3) {
              steward.seek(time, 1);
              const field = steward.field();
              for (const { id, x, y, radius } of steward.bodies()) {
                if (x < field.left || x > field.right || y < field.top || y > field.bottom) left.push(id);
                const isSeen = x - radius >= canvas.left && x + radius <= canvas.right && y - radius >= top
                  && y + radius <= canvas.bottom;
                if (!isSeen) hidden.push(`${time.toFixed(2)}: ${id} at ${x}, ${y}`);
              }
            }
            return left.length + ' ' + hidden.join('; ');
            """);
        assertTrue(Integer.parseInt(found.split(" ")[0]) > 8, "no pod leaves the field: " + found);
        assertEquals("", found.replaceFirst("\\d+ ", ""));
    }

    @Test
    void theArenaOfMeanMaxUsesTheHeightAndNoNumberCoversAUnit() {
        byte[] match = Recorded.of(TestScenes.open("mean-max"), 7, List.of(BundledBots.of(new Marauder()),
            BundledBots.of(new Gatherer()), BundledBots.of(new Gatherer()))).bytes();
        browser.open(pages.page(match, "Mean Max"), "#t=0");
        double share = browser.number("""
            (() => {
              const field = steward.field();
              const top = document.getElementById('scores').getBoundingClientRect().bottom;
              const arena = (field.bottom - field.top) * 12000 / 16000;
              return arena / (document.getElementById('field').getBoundingClientRect().bottom - top);
            })()""");
        assertTrue(share > 0.88 && share <= 1, "the arena has " + share + " of the height");
        assertEquals("", browser.run("""
            const { left, top } = document.getElementById('field').getBoundingClientRect();
            const found = [];
            let numbers = 0;
            for (let time = 0; time < 30; time += 0.4) {
              steward.seek(time, 1);
              for (const { words, x, y, half, high } of steward.numbers()) {
                numbers++;
                for (const body of steward.bodies()) {
                  const [dx, dy] = [Math.abs(body.x - left - x), Math.abs(body.y - top - y)];
                  if (Math.hypot(Math.max(0, dx - half), Math.max(0, dy - high)) < body.radius) {
                    found.push(`${time}: ${words} covers ${body.id}`);
                  }
                }
              }
            }
            return numbers > 20 ? found.join('; ') : `only ${numbers} numbers`;
            """));
    }

    /** A body without bounds: it goes farther than the view reaches, and an arrow at the edge says where. */
    @Test
    void whoIsFarAwayIsPointedAt() {
        browser.open(pages.live("Made up"), "");
        browser.run("arguments[0].forEach(line => steward.addTurn(line))", List.of("""
            {"type":"steward-replay","format":3,"game":"made-up","seed":"1","players":[{"name":"a"}],
             "drawing":{"field":{"x":0,"y":0,"width":100,"height":100},
              "bodies":[{"id":0,"owner":0,"radius":5,"label":"A"}]},
             "start":{"state":{"bodies":[{"id":0,"x":50,"y":50}]}}}""".replace("\n", ""), """
            {"type":"turn","turn":1,"commands":[null],
             "outcome":{"state":{"bodies":[{"id":0,"x":50,"y":-5000}]}}}""".replace("\n", "")));
        browser.run("steward.seek(1)");
        assertTrue(browser.is("""
            (() => {
              const canvas = document.getElementById('field');
              const { width } = canvas.getBoundingClientRect();
              const covered = document.getElementById('scores').offsetHeight + 18;
              const pixels = canvas.getContext('2d').getImageData(steward.bodies()[0].x - 20, covered, 40, 28).data;
              const wanted = steward.colourOf(0).match(/[0-9a-f]{2}/g).map(hex => parseInt(hex, 16));
              let alike = 0;
              for (let k = 0; k < pixels.length; k += 4) {
                if (Math.hypot(...wanted.map((value, c) => value - pixels[k + c])) < 40) alike++;
              }
              return width > 0 && alike > 40;
            })()"""));
    }
}

package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import steward.live.LiveRecording;
import steward.live.LiveServer;

/** The page that is given its turns one by one, in a real browser: a live match, and a game it does not know. */
class PageTestLive extends PageTestCase {

    /** Some turns, a wait, the others: the page waits too, and goes on. */
    @Test
    void turnsAppearAndTheCopyOutlivesTheServer() throws IOException, InterruptedException {
        byte[] replay = PageTestRaces.play(PageTestRaces.scene("duel"), 5);
        List<String> lines = new String(replay, StandardCharsets.UTF_8).lines().toList();
        LiveRecording recording = new LiveRecording();
        try (LiveServer server = LiveServer.start(null, 0, 200, "swift against steady", recording,
                PageExtras.NONE)) {
            browser.go(server.address().toString());
            browser.run("""
                const make = URL.createObjectURL;
                URL.createObjectURL = blob => {
                  blob.text().then(text => { window.kept = text; });
                  return make.call(URL, blob);
                };
                """);
            write(recording, lines.subList(0, 6));
            browser.await("5 turns do not appear", () -> browser.is("steward.lastTurn() === 5"));
            browser.await("they are not played", () -> browser.is("steward.time() === 5"));
            assertTrue(browser.is("steward.playing()"), "it waits for more");
            assertEquals("match.html", browser.run("return document.querySelector('.top a').getAttribute('href')"));
            assertTrue(browser.is("document.body.classList.contains('live')"));
            write(recording, lines.subList(6, lines.size()));
            recording.close();
            server.awaitDelivery(20_000, 20_000);
        }
        int last = lines.size() - 2;
        browser.await("the end does not appear", () -> browser.is("steward.lastTurn() === " + last));
        browser.await("no copy is kept", () -> browser.is("window.kept"));
        assertTrue(browser.is("!document.body.classList.contains('live')"));
        String link = (String) browser.run("const a = document.querySelector('a[download]'); "
            + "return a.download + a.href");
        assertTrue(link.startsWith("match.htmlblob:"), link);
        String kept = (String) browser.run("return window.kept");
        assertTrue(kept.endsWith("</html>\n") && kept.contains("<title>swift against steady</title>"));
        browser.run("steward.seek(steward.lastTurn())");
        assertTrue(browser.text("#ending").contains("wins"));
    }

    private static void write(LiveRecording recording, List<String> lines) {
        byte[] bytes = (String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8);
        recording.write(bytes, 0, bytes.length);
    }

    /** Nothing of this game is known: bodies come, grow and go, hit each other and walls of all kinds. */
    @Test
    void showsAGameItKnowsNothingOf() {
        browser.open(pages.live("Unknown"), "");
        addTurn("""
            {"type":"steward-replay","format":2,"game":"bubbles","seed":"1","timeFactor":null,
             "players":[{"name":"a","bot":"./a"},{"name":"b","bot":"./b"},{"name":"c","bot":"./c"}],
             "scene":{"name":"pond","time":{"firstAnswerMs":1000,"answerMs":50}},
             "drawing":{"field":{"x":-100,"y":-50,"width":200,"height":100},
              "walls":[{"type":"segment","ax":-50,"ay":0,"bx":-20,"by":30},
               {"type":"half-plane","x":90,"y":0,"insideX":-1,"insideY":0},{"type":"arena","x":0,"y":0,"radius":45}],
              "zones":[{"x":0,"y":0,"radius":10,"label":"goal"}],
              "bodies":[{"id":1,"kind":"bubble","radius":5,"owner":0,"label":"A"},{"id":2,"kind":"bubble","radius":5}]},
             "start":{"state":{"bodies":[{"id":1,"x":-40,"y":0,"radius":5},{"id":2,"x":40,"y":0,"radius":5}]},
              "hash":"00"}}
            """);
        addTurn("""
            {"type":"turn","turn":1,"commands":[{"go":1},null,"wait"],"faults":[null,"no answer",null],
             "outcome":{"impacts":[{"time":0.25,"a":1,"wall":0,"ax":-20,"ay":0,"bx":-25,"by":0,"impulse":3,"energy":0}],
              "paths":[{"id":1,"knots":[[0.25,-20,0]]},{"id":9,"knots":[]}],
              "events":[{"kind":"death","time":0.5,"body":2,"x":40,"y":20,"text":"popped"},
               {"kind":"birth","time":0.75,"body":9,"x":0,"y":-40}],
              "state":{"bodies":[{"id":1,"x":-20,"y":30,"radius":9},
               {"id":9,"x":10,"y":-40,"radius":2,"owner":2,"kind":"drop"}],"round":7},"hash":"01"}}
            """);
        browser.seek(1, 0.25);
        assertEquals(List.of("1 -20 0 6", "2 40 10 5"), places());
        browser.seek(1, 0.5);
        assertEquals(List.of("1 -20 10 7", "2 40 20 5"), places());
        browser.seek(1, 0.6);
        assertEquals(1, places().size(), "one has gone, the other has not come yet");
        browser.seek(1, 1);
        assertEquals(List.of("1 -20 30 9", "9 10 -40 2"), places());
        assertTrue(browser.text("#cards .card:nth-child(2)").contains("no answer"));
        assertTrue(browser.text("#cards .card:nth-child(1)").contains("{\"go\":1}"));
        assertTrue(browser.text("#state").contains("round"), browser.text("#state"));
        addTurn("""
            {"type":"turn","turn":2,"commands":[{"go":1},null,"wait"],
             "outcome":{"impacts":[{"time":0.5,"a":9,"b":1,"ax":0,"ay":0,"bx":11,"by":0,"impulse":3,"energy":0}],
              "state":{"bodies":[{"id":1,"x":-20,"y":30,"radius":9},
               {"id":9,"x":10,"y":-40,"radius":2,"owner":2,"kind":"drop"}]},"hash":"02"}}
            """);
        browser.seek(2, 1);
        assertEquals(2, browser.number("""
            (steward.impacts()[1].x - steward.field().left) * 200 / (steward.field().right - steward.field().left)
              - 100"""), 0.01, "a body that came later has its size");
        browser.seek(1, 1);
        assertFalse((Boolean) browser.run("return steward.addTurn('{\"type\":\"turn\",\"turn\":1}') ?? false"),
            "a turn that is there already is left out");
    }

    private static void addTurn(String line) {
        browser.run("steward.addTurn(arguments[0])", line);
    }

    /** Every body as "id x y radius", in whole units of the field. */
    @SuppressWarnings("unchecked")
    private static List<String> places() {
        Map<String, Object> field = (Map<String, Object>) browser.run("return steward.field()");
        double left = ((Number) field.get("left")).doubleValue();
        double top = ((Number) field.get("top")).doubleValue();
        double scale = (((Number) field.get("right")).doubleValue() - left) / 200;
        return ((List<Map<String, Object>>) browser.run("return steward.bodies()")).stream()
            .map(body -> body.get("id") + " " + units(body.get("x"), left, scale, 100) + " "
                + units(body.get("y"), top, scale, 50) + " " + units(body.get("radius"), 0, scale, 0)).toList();
    }

    private static long units(Object pixels, double zero, double scale, double origin) {
        return Math.round((((Number) pixels).doubleValue() - zero) / scale - origin);
    }

    /** Lines as they were said, the referee's own limits, and no field. */
    private static final List<String> GUEST = List.of("""
        {"type":"steward-replay","format":3,"game":"guest","seed":"7","timeFactor":2,"players":[{"name":"left"},\
        {"name":"right"}],"scene":{"name":"heap","game":"guest","players":2},\
        "drawing":{"field":{"x":0,"y":0,"width":1600,"height":900},"walls":[],"zones":[],"bodies":[]},\
        "start":{"state":{"bodies":[],"asked":1,"said":[{"block":"NEXT_PLAYER_INFO","lines":["0","0","70"]},\
        {"block":"NEXT_PLAYER_INPUT","lines":["20"]},\
        {"block":"NEXT_PLAYER_INFO","lines":["1 2","1000"]}]}}}""", """
        {"type":"turn","turn":1,"commands":[null,{"lines":["TAKE 3","AND <wait>"]}],\
        "times":{"answerNanos":[null,5000000]},"outcome":{"state":{"bodies":[],"asked":0,"said":[\
        {"block":"VIEW","lines":["KEY_FRAME 1","{\\"heap\\": 17}"]},{"block":"INFOS","lines":[]},\
        {"block":"TOOLTIP","lines":["three","1"]},{"block":"NEXT_PLAYER_INPUT","lines":["17","x"]},\
        {"block":"NEXT_PLAYER_INFO","lines":["0","1","50"]}]}}}""", """
        {"type":"turn","turn":2,"commands":[{"lines":["TAKE 1"]},null],"times":{"answerNanos":[1000000,null]},\
        "outcome":{"state":{"bodies":[],"said":[{"block":"SCORES","lines":["0 0","1 1"]}]}}}""");

    @Test
    void aGuestIsShownByItsLines() {
        browser.open(pages.live("A heap"), "");
        GUEST.forEach(line -> browser.run("steward.addTurn(arguments[0])", line));
        browser.run("steward.seek(1)");
        assertTrue(browser.is("document.body.classList.contains('drawingless')"), "there is nothing to draw");
        String cards = text("#cards");
        assertTrue(cards.contains("5.00 ms of 2000") && cards.contains("TAKE 3\nAND <wait>"), cards);
        assertEquals("askedleftVIEWKEY_FRAME 1\n{\"heap\": 17}TOOLTIPthree\n1NEXT_PLAYER_INPUT17\nx"
            + "NEXT_PLAYER_INFO0\n1\n50", text("#state"));
        browser.run("steward.seek(2)");
        assertTrue(text("#cards").contains("1.00 ms of 100"), text("#cards"));
        assertTrue(!text("#charts").contains("no deadlines"), text("#charts"));
    }

    private static String text(String selector) {
        return (String) browser.run("return document.querySelector(arguments[0]).textContent", selector);
    }
}

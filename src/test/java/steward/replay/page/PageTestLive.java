package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;

/** The page that is given its turns one by one, in a real browser: a live match, and a game it does not know. */
class PageTestLive extends PageTestCase {

    /** Half of the match, a wait, the other half: the page waits too, and goes on. */
    @Test
    void followsAMatchAsItIsPlayed() throws IOException {
        byte[] replay = PageTestRaces.play(PageTestRaces.scene("duel"), 5);
        List<String> lines = new String(replay, StandardCharsets.UTF_8).lines().toList();
        CountDownLatch secondHalf = new CountDownLatch(1);
        ExecutorService threads = Executors.newCachedThreadPool();
        HttpServer server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.setExecutor(threads);
        server.createContext("/", exchange -> {
            ByteArrayOutputStream page = new ByteArrayOutputStream();
            ReplayPage.writeLive(page, "Live", "feed", "match.html");
            exchange.getResponseHeaders().add("Content-Type", "text/html; charset=utf-8");
            exchange.sendResponseHeaders(200, page.size());
            exchange.getResponseBody().write(page.toByteArray());
            exchange.close();
        });
        server.createContext("/feed", exchange -> {
            exchange.getResponseHeaders().add("Content-Type", "text/event-stream");
            exchange.sendResponseHeaders(200, 0);
            try (OutputStream out = exchange.getResponseBody()) {
                send(out, lines.subList(0, 11));
                secondHalf.await();
                send(out, lines.subList(11, lines.size()));
            } catch (InterruptedException e) {
                throw new IOException(e);
            }
        });
        server.start();
        try {
            browser.go("http://" + server.getAddress().getHostString() + ":" + server.getAddress().getPort() + "/");
            browser.await("10 turns do not arrive", () -> browser.is("steward.lastTurn() === 10"));
            browser.await("they are not played", () -> browser.is("steward.time() === 10"));
            assertTrue(browser.is("steward.playing()"), "it waits for more");
            assertEquals("match.html", browser.run("return document.querySelector('.top a').getAttribute('href')"));
            secondHalf.countDown();
            browser.await("the end does not arrive", () -> browser.is("steward.lastTurn() === " + (lines.size() - 2)));
            browser.run("steward.seek(steward.lastTurn())");
            assertTrue(browser.text("#ending").contains("wins"));
        } finally {
            secondHalf.countDown();
            server.stop(0);
            threads.shutdownNow();
        }
    }

    private static void send(OutputStream out, List<String> lines) throws IOException {
        for (String line : lines) {
            out.write(("data: " + line + "\n\n").getBytes(StandardCharsets.UTF_8));
        }
        out.flush();
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
}

package steward.live;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.BindException;
import java.net.Socket;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.replay.Recorded;
import steward.replay.page.PageExtras;
import steward.replay.page.PageTestPages;

/** The server of a match that is being played, asked by real clients over the loopback interface. */
@Timeout(30)
class LiveServerTest {

    private static final List<String> LINES = Recorded.of("duel", 5).lines();

    private static final int VIEWERS = 16;

    private final LiveRecording recording = new LiveRecording();
    private LiveServer server;
    private Clients clients;

    @BeforeEach
    void start() throws IOException {
        server = LiveServer.start(null, 0, VIEWERS, "a against b", recording, PageExtras.NONE);
        clients = new Clients(server.address());
    }

    @AfterEach
    void stop() {
        clients.close();
        server.close();
    }

    private void write(List<String> lines) {
        for (String line : lines) {
            byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
            recording.write(bytes, 0, bytes.length);
        }
    }

    private String host() {
        return "Host: localhost:" + clients.port();
    }

    @Test
    void isOnTheLoopbackAddress() {
        assertTrue(server.isLoopback());
        assertTrue(server.address().toString().matches("http://127\\.0\\.0\\.1:\\d+/"), server.address()::toString);
    }

    @Test
    void thePageFollowsTheFeed() throws Exception {
        String page = clients.body("");
        assertTrue(page.contains("<title>a against b</title>"));
        assertTrue(page.contains("data-feed=\"feed\"") && page.contains("href=\"match.html\""));
    }

    @Test
    void twoViewersGetEachLineWhenItIsPlayedAndALateOneGetsAll() throws Exception {
        Clients.LiveFeed one = clients.feed();
        Clients.LiveFeed two = clients.feed();
        for (String line : LINES) {
            write(List.of(line));
            assertEquals(line, one.next());
            assertEquals(line, two.next());
        }
        recording.close();
        Clients.LiveFeed late = clients.feed();
        assertEquals(LINES, late.rest());
        assertEquals("end", late.ending());
        assertEquals(List.of(), one.rest());
        assertEquals("end", one.ending());
    }

    /** 40 MB are far more than all buffers between the two; the match must not wait for any of it. */
    @Test
    @Tag("slow")
    @Tag("campaign")
    void aViewerWhoReadsNothingHoldsNobodyUp() throws Exception {
        Clients.LiveFeed slow = clients.feed();
        Clients.LiveFeed quick = clients.feed();
        String line = "x".repeat(400_000);
        long start = System.nanoTime();
        for (int k = 0; k < 100; k++) {
            write(List.of(line));
        }
        long written = System.nanoTime() - start;
        recording.close();
        for (int k = 0; k < 100; k++) {
            assertEquals(line.length(), quick.next().length());
        }
        assertTrue(written < 3e9, () -> written + " ns");
        server.awaitDelivery(200, 0);
        for (int k = 0; k < 100; k++) {
            assertEquals(line.length(), slow.next().length());
        }
        server.awaitDelivery(20_000, 0);
    }

    @Test
    void onlyGetsAreAnswered() throws IOException {
        for (String method : List.of("POST", "PUT", "DELETE", "HEAD", "OPTIONS", "TRACE")) {
            String answer = clients.raw(method + " / HTTP/1.1", host(), "Content-Length: 0");
            assertTrue(answer.startsWith("HTTP/1.1 405 ") && answer.contains("Allow: GET"), answer);
        }
    }

    @Test
    void onlyKnownPathsAreThere() throws Exception {
        for (String path : List.of("x", "feed/", "feed/x", "index.html", "%66eed", "../etc/passwd", "match.html.")) {
            assertEquals(404, clients.rawStatus("GET /" + path + " HTTP/1.1", host()), path);
        }
        assertEquals(200, clients.rawStatus("GET /?x=y HTTP/1.1", host()));
    }

    @Test
    void requestsForAnotherNameAreRefused() throws IOException {
        for (String host : List.of("evil.example", "evil.example:" + clients.port(), "localhost:1")) {
            for (String path : List.of("/", "/feed", "/match.html")) {
                assertEquals(403, clients.rawStatus("GET " + path + " HTTP/1.1", "Host: " + host), host);
            }
        }
        assertEquals(403, clients.rawStatus("GET / HTTP/1.0"));
        assertEquals(200, clients.rawStatus("GET / HTTP/1.1", "Host: 127.0.0.1:" + clients.port()));
    }

    @Test
    @Tag("slow")
    void whoeverFindsAllPlacesTakenIsToldAndComesInWhenOneHasLeft() throws Exception {
        List<Clients.LiveFeed> feeds = new ArrayList<>();
        for (int k = 0; k < VIEWERS; k++) {
            feeds.add(clients.feed());
        }
        Clients.LiveFeed refused = clients.feed();
        assertEquals("All places are taken: 16 are watching, more are not admitted.", refused.next());
        assertEquals("refused", refused.ending());
        assertNull(refused.next());
        assertEquals(200, clients.status(""), "the page itself is there for everybody");
        feeds.get(3).close();
        write(LINES.subList(0, 1));
        String first = null;
        while (!LINES.get(0).equals(first)) {                // that one has gone is seen a moment later
            first = clients.feed().next();
        }
    }

    /** 8 MB are more than all buffers between the two. A browser connects again by itself, with the last id. */
    @Test
    @Tag("slow")
    void aViewerWhoReadsNothingIsDroppedAndToldWhenItComesAgain() throws Exception {
        LiveRecording lines = new LiveRecording();
        try (LiveServer impatient = LiveServer.start(null, 0, 2, "b", lines, PageExtras.NONE, 300_000_000);
             Clients others = new Clients(impatient.address())) {
            Clients.LiveFeed slow = others.feed();
            Clients.LiveFeed quick = others.feed();
            byte[] line = ("x".repeat(1 << 20) + "\n").getBytes(StandardCharsets.UTF_8);
            for (int k = 0; k < 8; k++) {
                lines.write(line, 0, line.length);
                assertEquals(1 << 20, quick.next().length());
            }
            String told = null;
            while (told == null || !told.startsWith("This page has read nothing for ")) {
                told = others.feed(slow.id()).next();        // until it is dropped, all places are taken
            }
            assertEquals(1 << 20, others.feed().next().length(), "without its number it is somebody new");
            lines.close();
            assertNull(quick.next());
            assertEquals("end", quick.ending());
        }
    }

    @Test
    void theCopyHoldsWhatHasBeenPlayed() throws Exception {
        assertEquals(404, clients.status("match.html"), "nothing has been played");
        write(LINES.subList(0, 5));
        String half = clients.body("match.html");
        assertTrue(half.contains("cut off after turn 4"), "it says where it ends");
        write(LINES.subList(5, LINES.size()));
        byte[] whole = (String.join("\n", LINES) + "\n").getBytes(StandardCharsets.UTF_8);
        assertArrayEquals(whole, PageTestPages.embedded(clients.body("match.html")));
    }

    @Test
    void theEndIsAwaitedOnlyForThoseWhoWatch() throws Exception {
        assertFalse(server.awaitViewer(1));
        long start = System.nanoTime();
        server.awaitDelivery(20_000, 20_000);
        Clients.LiveFeed feed = clients.feed();
        assertTrue(server.awaitViewer(0));
        write(LINES);
        recording.close();
        assertEquals(LINES, feed.rest());
        Thread copy = new Thread(() -> assertTrue(clients.body("match.html").contains("</html>")));
        copy.start();
        server.awaitDelivery(20_000, 20_000);
        assertTrue(System.nanoTime() - start < 10e9, "it has waited for nothing else");
        copy.join();
    }

    /** They are read one by one, and each may take two seconds: an honest request behind them was reset. */
    @Test
    void halfRequestsDoNotKeepOthersOut() throws IOException {
        List<Socket> half = new ArrayList<>();
        try {
            for (int k = 0; k < 200; k++) {
                Socket socket = new Socket("127.0.0.1", clients.port());
                half.add(socket);
                socket.getOutputStream().write("GET / HT".getBytes(StandardCharsets.US_ASCII));
            }
            assertEquals(200, clients.rawStatus("GET / HTTP/1.1", host()));
        } finally {
            for (Socket socket : half) {
                socket.close();
            }
        }
    }

    /** A policy in the page itself cannot say it: browsers ignore {@code frame-ancestors} there. */
    @Test
    void noOtherPageMayFrameIt() throws IOException {
        for (String path : List.of("/", "/match.html", "/nothing")) {
            String answer = clients.raw("GET " + path + " HTTP/1.1", host());
            assertTrue(answer.toLowerCase(Locale.ROOT).contains("content-security-policy: frame-ancestors 'none'"),
                answer);
        }
    }

    @Test
    void aPortThatIsTakenIsRefused() {
        assertThrows(BindException.class,
            () -> LiveServer.start(null, clients.port(), 1, "b", new LiveRecording(), PageExtras.NONE));
        assertThrows(UnknownHostException.class,
            () -> LiveServer.start("no such host", 0, 1, "b", recording, PageExtras.NONE));
    }

    @Test
    void onAllAddressesItIsShownByTheLoopbackOne() throws Exception {
        try (LiveServer open = LiveServer.start("0.0.0.0", 0, 1, "b", recording, PageExtras.NONE)) {
            assertFalse(open.isLoopback());
            assertEquals("127.0.0.1", open.address().getHost());
            try (Clients other = new Clients(open.address())) {
                assertEquals(200, other.status(""));
            }
        }
    }
}

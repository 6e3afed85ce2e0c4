package steward.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.league.page.LeaguePage;
import steward.replay.Recorded;
import steward.replay.page.PageExtras;
import steward.replay.page.PageTestCase;

/** Live pages in a real browser that are not admitted, or dropped: they say so, and a button connects again. */
@Tag("process")
@Tag("slow")
@Timeout(120)
class ViewersPageTest extends PageTestCase {

    private static final List<String> LINES = Recorded.of("duel", 5).lines();
    private static final String TAKEN = "All places are taken: 1 are watching, more are not admitted. Connect again";

    private static void write(LiveRecording recording, String line) {
        byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
        recording.write(bytes, 0, bytes.length);
    }

    @Test
    void aPageOfAMatchIsToldThatAllPlacesAreTaken() throws IOException {
        LiveRecording recording = new LiveRecording();
        write(recording, LINES.get(0));
        write(recording, LINES.get(1));
        try (LiveServer server = LiveServer.start(null, 0, 1, "b", recording, PageExtras.NONE);
             Clients first = new Clients(server.address())) {
            Clients.LiveFeed feed = first.feed();
            assertEquals(LINES.get(0), feed.next());
            browser.go(server.address().toString());
            browser.await("it is not told", () -> TAKEN.equals(browser.text("#notice")));
            assertTrue(browser.is("!document.body.classList.contains('live')"));
            feed.close();
            browser.await("it does not come in", () -> {
                browser.run("document.querySelector('#notice button')?.click()");
                return browser.is("steward.lastTurn() === 1 && document.getElementById('notice').hidden");
            });
        }
    }

    /** 20 MB are more than the buffers between the two. The part of the browser that reads from networks is stopped. */
    @Test
    @Tag("campaign")
    void aPageThatReadsNothingIsDroppedAndSaysSo() throws IOException, InterruptedException {
        LiveRecording recording = new LiveRecording();
        write(recording, LINES.get(0));
        write(recording, LINES.get(1));
        try (LiveServer server = LiveServer.start(null, 0, 1, "b", recording, PageExtras.NONE, 500_000_000)) {
            browser.go(server.address().toString());
            browser.await("a turn does not appear", () -> browser.is("steward.lastTurn() === 1"));
            signal("STOP");
            try {
                String line = LINES.get(2).replace("\"outcome\"", "\"padding\":\"" + "x".repeat(20 << 20)
                    + "\",\"outcome\"");
                write(recording, line);
                server.awaitDelivery(20_000, 0);
            } finally {
                signal("CONT");
            }
            browser.await("it is not told", () -> browser.text("#notice").equals(
                "This page has read nothing for 0 s and is no longer sent anything. Connect again"));
            browser.run("document.querySelector('#notice button').click()");
            browser.await("it does not come in", () -> browser.is("steward.lastTurn() === 2"));
            browser.await("it still says so", () -> browser.is("document.getElementById('notice').hidden"));
        }
    }

    private static void signal(String signal) throws IOException, InterruptedException {
        for (ProcessHandle each : ProcessHandle.current().descendants().toList()) {
            Path words = Path.of("/proc/" + each.pid() + "/cmdline");
            if (Files.exists(words) && Files.readString(words).contains("network.mojom.NetworkService")) {
                new ProcessBuilder("kill", "-" + signal, Long.toString(each.pid())).start().waitFor();
            }
        }
    }

    @Test
    void aPageOfALeagueIsToldThatAllPlacesAreTaken() throws IOException {
        byte[] page = LeaguePage.live("League", StatusServer.FEED);
        try (StatusServer server = StatusServer.start(null, 0, 1, page, path -> null);
             Clients first = new Clients(server.address())) {
            server.show("""
                {"scene":"duel","games":7,"repeats":0,"again":0,"without":0,"rate":2.5,"bots":[],"cross":[],\
                "path":{"versions":[],"points":[]},"list":[]}""");
            Clients.LiveFeed feed = first.feed();
            browser.go(server.address().toString());
            browser.await("it is not told", () -> TAKEN.equals(browser.text("#notice")));
            feed.close();
            browser.await("it does not come in", () -> {
                browser.run("document.querySelector('#notice button')?.click()");
                return browser.text("#scene").contains("7 games of duel")
                    && browser.is("document.body.classList.contains('live')");
            });
        }
    }
}

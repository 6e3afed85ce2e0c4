package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.live.LiveRecording;
import steward.live.LiveServer;

/** A match watched in a real browser while it is played, served as the program serves it. */
class PageTestWatch extends PageTestCase {

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
}

package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import steward.live.Clients;

/** {@code steward match --watch} as a whole. */
@Tag("process")
@Timeout(60)
class WatchTest extends ShellBotsCase {

    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private String[] match(String... more) {
        return Cli.words(List.of("match", "--scene", "duel", "--no-deadline", "--sandbox", "off", "--watch", "--bot",
            bots.driver("near", ShellBots.CHECKPOINT), "--bot", bots.driver("far", ShellBots.NOWHERE)), more);
    }

    /** Calls the program on a thread of its own; what it prints can be read as it comes. */
    private CompletableFuture<Integer> run(InputStream in, boolean terminal, OutputStream out, String... call) {
        return CompletableFuture.supplyAsync(() -> {
            try (out) {
                return Main.run(new Streams(in, terminal, out, err, false, false), call);
            } catch (IOException problem) {
                throw new IllegalStateException(problem);
            }
        });
    }

    @Test
    void itWaitsForTheFirstViewerAndEndsWhenAllHaveEverything() throws Exception {
        PipedInputStream pipe = new PipedInputStream(1 << 16);
        Path file = folder.resolve("x.jsonl");
        CompletableFuture<Integer> status = run(InputStream.nullInputStream(), false, new PipedOutputStream(pipe),
            match("--out", file.toString()));
        BufferedReader said = new BufferedReader(new InputStreamReader(pipe, StandardCharsets.UTF_8));
        assertEquals("Watch the match at", said.readLine());
        URI address = URI.create(said.readLine());
        assertEquals("Waiting for a browser, at most 60 seconds.", said.readLine());
        try (Clients clients = new Clients(address)) {
            assertTrue(clients.body("").contains("<title>near against far</title>"));
            assertFalse(Files.exists(file), "nothing is played before somebody watches");
            List<String> seen = clients.feed().rest();
            assertEquals(Files.readAllLines(file), seen);
            assertTrue(clients.body("match.html").contains("</html>"), "it can be saved still");
        }
        assertEquals(ExitStatus.DONE, status.get(20, TimeUnit.SECONDS), err::toString);
        assertTrue(said.readLine().startsWith("near wins: "));
        assertEquals("", err.toString(StandardCharsets.UTF_8));
    }

    @Test
    void enterPlaysWithoutAViewer() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int status = run(new ByteArrayInputStream(new byte[] {'\n'}), true, out, match()).get(30, TimeUnit.SECONDS);
        assertEquals(ExitStatus.DONE, status, err::toString);
        List<String> said = new ArrayList<>(out.toString(StandardCharsets.UTF_8).lines().toList());
        assertEquals("Waiting for a browser. Enter plays without one, Ctrl-C ends.", said.get(2));
        assertTrue(said.get(3).startsWith("near wins: "), said::toString);
    }

    @Test
    void jsonStaysAlone() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Path page = folder.resolve("x.html");
        run(new ByteArrayInputStream(new byte[] {'\n'}), true, out, match("--json", "--view", page.toString())).get();
        String json = out.toString(StandardCharsets.UTF_8);
        assertTrue(json.startsWith("{") && json.indexOf('\n') == json.length() - 1, json);
        List<String> said = err.toString(StandardCharsets.UTF_8).lines().toList();
        assertTrue(said.get(1).matches("http://127\\.0\\.0\\.1:\\d+/"), said::toString);
        assertEquals("Page: " + page, said.get(3));
        assertTrue(Files.readString(page).contains("</html>"));
    }

    @Test
    void aPortThatIsTakenIsFoundBeforeTheMatch() throws IOException {
        Path file = folder.resolve("x.jsonl");
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Cli cli = Cli.run(match("--port", Integer.toString(taken.getLocalPort()), "--out", file.toString()));
            assertEquals(ExitStatus.UNUSABLE, cli.status());
            assertEquals("steward: --watch: cannot listen on port " + taken.getLocalPort()
                + ": Address already in use\n", cli.err());
            assertEquals("", cli.out());
        }
        assertTrue(Files.notExists(file));
    }
}

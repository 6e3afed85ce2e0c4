package steward.live;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Semaphore;
import steward.replay.page.ReplayPage;

/**
 * Answers requests: the page, the match as server-sent events, and the match so far as a self-contained page. Anything
 * else is refused.
 */
final class LiveHandler implements HttpHandler {

    /** Address of the events, relative to the page. */
    static final String FEED = "feed";
    /** Address of the copy, relative to the page. */
    static final String COPY = "match.html";

    /** How many copies are made at the same time; others wait. */
    private static final int MOST_COPIES = 8;

    /**
     * How often a comment is sent while no line comes, in milliseconds: it shows whether the viewer is still connected.
     */
    private static final long HEARTBEAT_MS = 5000;
    private static final byte[] HEARTBEAT = bytes(":\n\n");
    private static final byte[] BEFORE_LINE = bytes("data: ");
    private static final byte[] AFTER_LINE = bytes("\n\n");
    private static final byte[] END = bytes("event: end\ndata:\n\n");

    private final AllowedHosts names;
    private final byte[] page;
    private final String title;
    private final LiveRecording recording;
    private final Viewers viewers;

    /** Each is made in memory. */
    private final Semaphore copies = new Semaphore(MOST_COPIES);

    LiveHandler(AllowedHosts names, byte[] page, String title, LiveRecording recording, Viewers viewers) {
        this.names = names;
        this.page = page;
        this.title = title;
        this.recording = recording;
        this.viewers = viewers;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @Override
    public void handle(HttpExchange exchange) throws IOException {
        try (exchange) {
            if (!HttpService.refuses(exchange, names)) {
                switch (String.valueOf(exchange.getRequestURI().getRawPath())) {
                    case "/" -> HttpService.send(exchange, HttpService.OK, HttpService.HTML, page);
                    case "/" + FEED -> feed(exchange);
                    case "/" + COPY -> copy(exchange);
                    default -> HttpService.refuse(exchange, HttpService.NOT_FOUND,
                        "There is nothing here; the match is at /.");
                }
            }
        }
    }

    private void feed(HttpExchange exchange) throws IOException {
        if (!viewers.enter()) {
            HttpService.refuse(exchange, HttpService.UNAVAILABLE, "Too many are watching already.");
            return;
        }
        boolean all = false;
        try {
            HttpService.describe(exchange, HttpService.EVENTS);
            exchange.sendResponseHeaders(HttpService.OK, 0);
            sendLines(exchange.getResponseBody());
            all = true;
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        } finally {
            viewers.leave(all);
        }
    }

    /** Sends the lines from the first to the last, as they are written, at the pace of the reader. */
    private void sendLines(OutputStream out) throws IOException, InterruptedException {
        out.write(HEARTBEAT);
        out.flush();
        int number = 0;
        for (;;) {
            byte[] line = recording.line(number, 0);
            if (line == LiveRecording.NOT_YET) {
                out.flush();
                line = recording.line(number, HEARTBEAT_MS);
            }
            if (line == null) {
                break;
            }
            if (line == LiveRecording.NOT_YET) {
                out.write(HEARTBEAT);
                continue;
            }
            out.write(BEFORE_LINE);
            out.write(line);
            out.write(AFTER_LINE);
            number++;
        }
        out.flush();
        sendEnd(out);
    }

    /** Sends the end. A page that has seen the result may have disconnected already: it has everything. */
    private static void sendEnd(OutputStream out) {
        try {
            out.write(END);
            out.close();
        } catch (IOException gone) {
            return;
        }
    }

    private void copy(HttpExchange exchange) throws IOException {
        boolean complete = recording.isComplete();
        byte[] replay = recording.replay();
        if (replay.length == 0) {
            HttpService.refuse(exchange, HttpService.UNAVAILABLE, "The match has not begun.");
            return;
        }
        copies.acquireUninterruptibly();
        try {
            ByteArrayOutputStream html = new ByteArrayOutputStream();
            ReplayPage.write(new ByteArrayInputStream(replay), "match", html, title);
            HttpService.send(exchange, HttpService.OK, HttpService.HTML, html.toByteArray());
        } finally {
            copies.release();
        }
        if (complete) {
            viewers.copied();
        }
    }
}

package steward.live;

import com.sun.net.httpserver.Headers;
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

    private static final String HTML = "text/html; charset=utf-8";
    private static final String TEXT = "text/plain; charset=utf-8";

    /** How many copies are made at the same time; others wait. */
    private static final int MOST_COPIES = 8;

    private static final int NO_BODY = -1;
    private static final int OK = 200;
    private static final int FORBIDDEN = 403;
    private static final int NOT_FOUND = 404;
    private static final int WRONG_METHOD = 405;
    private static final int UNAVAILABLE = 503;

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
            if (!names.accept(exchange.getRequestHeaders().getFirst("Host"))) {
                refuse(exchange, FORBIDDEN, "This server does not go by that name.");
            } else if (!exchange.getRequestMethod().equals("GET")) {
                exchange.getResponseHeaders().set("Allow", "GET");
                refuse(exchange, WRONG_METHOD, "There is only something to get here.");
            } else {
                switch (String.valueOf(exchange.getRequestURI().getRawPath())) {
                    case "/" -> send(exchange, OK, HTML, page);
                    case "/" + FEED -> feed(exchange);
                    case "/" + COPY -> copy(exchange);
                    default -> refuse(exchange, NOT_FOUND, "There is nothing here; the match is at /.");
                }
            }
        }
    }

    private static void refuse(HttpExchange exchange, int status, String why) throws IOException {
        send(exchange, status, TEXT, bytes(why + "\n"));
    }

    private static void send(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
        describe(exchange, type);
        boolean head = exchange.getRequestMethod().equals("HEAD");
        exchange.sendResponseHeaders(status, head ? NO_BODY : body.length);
        if (!head) {
            exchange.getResponseBody().write(body);
        }
    }

    /** Headers: the type as stated, no caching, no embedding in frames. */
    private static void describe(HttpExchange exchange, String type) {
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", type);
        headers.set("Cache-Control", "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        headers.set("X-Frame-Options", "DENY");
        // In the page's own policy, which is in a meta element, this would have no effect.
        headers.set("Content-Security-Policy", "frame-ancestors 'none'");
        headers.set("Referrer-Policy", "no-referrer");
        headers.set("Cross-Origin-Resource-Policy", "same-origin");
    }

    private void feed(HttpExchange exchange) throws IOException {
        if (!viewers.enter()) {
            refuse(exchange, UNAVAILABLE, "Too many are watching already.");
            return;
        }
        boolean all = false;
        try {
            describe(exchange, "text/event-stream");
            exchange.sendResponseHeaders(OK, 0);
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
            refuse(exchange, UNAVAILABLE, "The match has not begun.");
            return;
        }
        copies.acquireUninterruptibly();
        try {
            ByteArrayOutputStream html = new ByteArrayOutputStream();
            ReplayPage.write(new ByteArrayInputStream(replay), "match", html, title);
            send(exchange, OK, HTML, html.toByteArray());
        } finally {
            copies.release();
        }
        if (complete) {
            viewers.copied();
        }
    }
}

package steward.live;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/**
 * Serves a page and, to every open one, the newest state of what it shows, by server-sent events: who is slow misses
 * states in between, and delays no one. Other pages are found by their path. Access is read-only.
 *
 * <p>Caveat: there is no password, as with {@link LiveServer}.
 */
public final class StatusServer implements AutoCloseable {

    /** Address of the events, relative to the page. */
    public static final String FEED = "feed";

    private static final int MOST_VIEWERS = 16;
    /** How often a comment is sent while nothing changes, in milliseconds: it shows who is still connected. */
    private static final long HEARTBEAT_MS = 5000;
    private static final byte[] HEARTBEAT = bytes(":\n\n");
    private static final byte[] END = bytes("event: end\ndata:\n\n");

    private final HttpService service;
    private final Viewers viewers = new Viewers(MOST_VIEWERS);
    private byte[] state;
    private long number;
    private boolean over;

    private StatusServer(String host, int port, byte[] page, Function<String, byte[]> pages) throws IOException {
        service = HttpService.start(host, port, names -> handler(names, page, pages));
    }

    /**
     * Starts a server.
     *
     * @param host  name or address to listen on, or {@code null} for this machine alone (loopback)
     * @param port  to listen on, or 0 for any that is free
     * @param page  the page at {@code /}
     * @param pages other pages by their path without its first slash; gives {@code null} where there is none
     * @throws IOException if the host is not known or the port is taken
     */
    public static StatusServer start(String host, int port, byte[] page, Function<String, byte[]> pages)
            throws IOException {
        return new StatusServer(host, port, page, pages);
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private HttpHandler handler(AllowedHosts names, byte[] page, Function<String, byte[]> pages) {
        return exchange -> {
            try (exchange) {
                if (HttpService.refuses(exchange, names)) {
                    return;
                }
                String path = String.valueOf(exchange.getRequestURI().getRawPath());
                byte[] found = path.equals("/") ? page : path.equals("/" + FEED) ? null
                    : pages.apply(path.substring(1));
                if (path.equals("/" + FEED)) {
                    feed(exchange);
                } else if (found == null) {
                    HttpService.refuse(exchange, HttpService.NOT_FOUND, "There is nothing here; the page is at /.");
                } else {
                    HttpService.send(exchange, HttpService.OK, HttpService.HTML, found);
                }
            }
        };
    }

    private void feed(HttpExchange exchange) throws IOException {
        if (!viewers.enter()) {
            HttpService.refuse(exchange, HttpService.UNAVAILABLE, "Too many are watching already.");
            return;
        }
        try {
            HttpService.describe(exchange, HttpService.EVENTS);
            exchange.sendResponseHeaders(HttpService.OK, 0);
            OutputStream out = exchange.getResponseBody();
            out.write(HEARTBEAT);
            out.flush();
            sendStates(out);
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        } finally {
            viewers.leave(true);
        }
    }

    private void sendStates(OutputStream out) throws IOException, InterruptedException {
        long sent = 0;
        for (;;) {
            byte[] next;
            boolean last;
            synchronized (this) {
                long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(HEARTBEAT_MS);
                long left = HEARTBEAT_MS;
                while (number == sent && !over && left > 0) {
                    wait(left);
                    left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
                }
                next = number == sent ? HEARTBEAT : state;
                last = over;
                sent = number;
            }
            out.write(next);
            out.flush();
            if (last) {
                out.write(END);
                out.flush();
                return;
            }
        }
    }

    /** What is shown from now on: one line. */
    public synchronized void show(String line) {
        state = bytes("data: " + line + "\n\n");
        number++;
        notifyAll();
    }

    /** Nothing more follows. */
    public synchronized void end() {
        over = true;
        notifyAll();
    }

    /** Waits, for a limited time, until every viewer has the last state. */
    public void awaitDelivery(long mostMs) throws InterruptedException {
        viewers.awaitServed(mostMs);
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    public URI address() {
        return service.address();
    }

    /** Whether only this machine can reach it. */
    public boolean isLoopback() {
        return service.isLoopback();
    }

    /** Closes all connections. */
    @Override
    public void close() {
        end();
        service.close();
    }
}

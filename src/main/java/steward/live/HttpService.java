package steward.live;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/** A small read-only server for browsers, and what every answer of it has. */
final class HttpService implements AutoCloseable {

    static final String HTML = "text/html; charset=utf-8";
    static final String TEXT = "text/plain; charset=utf-8";
    static final String EVENTS = "text/event-stream";
    static final int OK = 200;
    static final int FORBIDDEN = 403;
    static final int NOT_FOUND = 404;
    static final int WRONG_METHOD = 405;
    static final int UNAVAILABLE = 503;

    private static final int NO_BODY = -1;
    private static final String REQUEST_LIMIT = "sun.net.httpserver.maxReqTime";
    /**
     * How many requests are read at the same time, one thread each. A request that stays incomplete keeps its thread
     * until the limit of time for it has passed, and one that waits for a thread meanwhile uses up its own time: with a
     * few threads, some dozens of half requests had an honest one reset.
     */
    private static final int MOST_REQUESTS = 1000;

    /** Of each of these threads, in bytes: the deepest calls are those that make a page. */
    private static final long STACK = 256 << 10;
    private static final long IDLE_THREAD_MS = 10_000;

    private final HttpServer server;
    private final ThreadPoolExecutor threads;

    private HttpService(HttpServer server) {
        this.server = server;
        threads = new ThreadPoolExecutor(0, MOST_REQUESTS, IDLE_THREAD_MS, TimeUnit.MILLISECONDS,
            new SynchronousQueue<>(), HttpService::daemon);
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(null, work, "live", STACK);
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Starts one.
     *
     * @param host    name or address to listen on, or {@code null} for this machine alone (loopback)
     * @param port    to listen on, or 0 for any that is free
     * @param handler made from the names by which the server may be called
     * @throws IOException if the host is not known or the port is taken
     */
    static HttpService start(String host, int port, Function<AllowedHosts, HttpHandler> handler)
            throws IOException {
        // Seconds until a request must be complete; read once by the JDK's server. Without it a few connections that
        // send half a request would block all others.
        if (System.getProperty(REQUEST_LIMIT) == null) {
            System.setProperty(REQUEST_LIMIT, "2");
        }
        InetAddress address = host == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(host);
        HttpService service = new HttpService(HttpServer.create(new InetSocketAddress(address, port), 0));
        AllowedHosts names = new AllowedHosts(host == null ? "localhost" : host,
            service.server.getAddress().getPort());
        service.server.setExecutor(service.threads);
        service.server.createContext("/", handler.apply(names));
        service.server.start();
        return service;
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    URI address() {
        InetAddress bound = server.getAddress().getAddress();
        InetAddress shown = bound.isAnyLocalAddress() ? InetAddress.getLoopbackAddress() : bound;
        String numeric = shown.getHostAddress().replaceFirst("%.*", "");
        String host = shown instanceof Inet6Address ? "[" + numeric + "]" : numeric;
        return URI.create("http://" + host + ":" + server.getAddress().getPort() + "/");
    }

    /** Whether only this machine can reach it. */
    boolean isLoopback() {
        return server.getAddress().getAddress().isLoopbackAddress();
    }

    /** Closes all connections. */
    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }

    /** Refuses a request under a foreign name, or that is more than a question; returns whether it did. */
    static boolean refuses(HttpExchange exchange, AllowedHosts names) throws IOException {
        if (!names.accept(exchange.getRequestHeaders().getFirst("Host"))) {
            refuse(exchange, FORBIDDEN, "This server does not go by that name.");
            return true;
        }
        if (!exchange.getRequestMethod().equals("GET")) {
            exchange.getResponseHeaders().set("Allow", "GET");
            refuse(exchange, WRONG_METHOD, "There is only something to get here.");
            return true;
        }
        return false;
    }

    static void refuse(HttpExchange exchange, int status, String why) throws IOException {
        send(exchange, status, TEXT, (why + "\n").getBytes(StandardCharsets.UTF_8));
    }

    static void send(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
        describe(exchange, type);
        boolean head = exchange.getRequestMethod().equals("HEAD");
        exchange.sendResponseHeaders(status, head ? NO_BODY : body.length);
        if (!head) {
            exchange.getResponseBody().write(body);
        }
    }

    /** Headers: the type as stated, no caching, no embedding in frames. */
    static void describe(HttpExchange exchange, String type) {
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
}

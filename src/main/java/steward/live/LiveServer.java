package steward.live;

import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import steward.replay.page.ReplayPage;

/**
 * Serves the page of a match that is being played, and the match line by line to every open page. Access is read-only,
 * by at most {@value #MOST_VIEWERS} viewers at the same time, each served by a thread of its own from the
 * {@link LiveRecording}, so that none can delay another or the match.
 *
 * <p>Caveat: there is no password. On an address other than the loopback one, every client that reaches this machine
 * can watch.
 */
public final class LiveServer implements AutoCloseable {

    private static final String REQUEST_LIMIT = "sun.net.httpserver.maxReqTime";

    /** How many can follow a match at the same time. */
    public static final int MOST_VIEWERS = 16;

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
    private final Viewers viewers = new Viewers(MOST_VIEWERS);

    private LiveServer(HttpServer server) {
        this.server = server;
        threads = new ThreadPoolExecutor(0, MOST_REQUESTS, IDLE_THREAD_MS, TimeUnit.MILLISECONDS,
            new SynchronousQueue<>(), LiveServer::daemon);
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(null, work, "live", STACK);
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Starts a server.
     *
     * @param host      name or address to listen on, or {@code null} for this machine alone (loopback)
     * @param port      to listen on, or 0 for any that is free
     * @param title     of the page, plain text
     * @param recording the recording that the match is written to
     * @throws IOException if the host is not known or the port is taken
     */
    public static LiveServer start(String host, int port, String title, LiveRecording recording) throws IOException {
        // Seconds until a request must be complete; read once by the JDK's server. Without it a few connections that
        // send half a request would block all others.
        if (System.getProperty(REQUEST_LIMIT) == null) {
            System.setProperty(REQUEST_LIMIT, "2");
        }
        InetAddress address = host == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(host);
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        ReplayPage.writeLive(page, title, LiveHandler.FEED, LiveHandler.COPY);
        LiveServer live = new LiveServer(HttpServer.create(new InetSocketAddress(address, port), 0));
        AllowedHosts names = new AllowedHosts(host == null ? "localhost" : host, live.server.getAddress().getPort());
        live.server.setExecutor(live.threads);
        live.server.createContext("/", new LiveHandler(names, page.toByteArray(), title, recording, live.viewers));
        live.server.start();
        return live;
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    public URI address() {
        InetAddress bound = server.getAddress().getAddress();
        InetAddress shown = bound.isAnyLocalAddress() ? InetAddress.getLoopbackAddress() : bound;
        String numeric = shown.getHostAddress().replaceFirst("%.*", "");
        String host = shown instanceof Inet6Address ? "[" + numeric + "]" : numeric;
        return URI.create("http://" + host + ":" + server.getAddress().getPort() + "/");
    }

    /** Whether only this machine can reach it. */
    public boolean isLoopback() {
        return server.getAddress().getAddress().isLoopbackAddress();
    }

    /** Waits for the first viewer; returns whether there is one. */
    public boolean awaitViewer(long mostMs) throws InterruptedException {
        return viewers.awaitFirst(mostMs);
    }

    /**
     * Waits until every viewer has the last line, and until their pages have fetched the copy that they keep, each for
     * a limited time.
     *
     * @param linesMs how long to wait for the lines, in milliseconds
     * @param copyMs  how long to wait for the copies, in milliseconds
     */
    public void awaitDelivery(long linesMs, long copyMs) throws InterruptedException {
        if (viewers.awaitServed(linesMs)) {
            viewers.awaitCopies(copyMs);
        }
    }

    /** Closes all connections. */
    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }
}

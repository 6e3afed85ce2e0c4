package steward.live;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
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

    /** How many can follow a match at the same time. */
    public static final int MOST_VIEWERS = 16;


    private final HttpService service;
    private final Viewers viewers;

    private LiveServer(HttpService service, Viewers viewers) {
        this.service = service;
        this.viewers = viewers;
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
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        ReplayPage.writeLive(page, title, LiveHandler.FEED, LiveHandler.COPY);
        Viewers viewers = new Viewers(MOST_VIEWERS);
        return new LiveServer(HttpService.start(host, port,
            names -> new LiveHandler(names, page.toByteArray(), title, recording, viewers)), viewers);
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    public URI address() {
        return service.address();
    }

    /** Whether only this machine can reach it. */
    public boolean isLoopback() {
        return service.isLoopback();
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
        service.close();
    }
}

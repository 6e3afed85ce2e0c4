package steward.live;

import java.io.IOException;
import java.net.URI;
import java.util.function.Function;

/**
 * Web server for a page whose data change: it sends every open page the newest state by server-sent events. A slow
 * viewer misses states in between and delays no one. Other pages are found by their path. Access is read-only.
 *
 * <p>Caveat: there is no password, as with {@link LiveServer}.
 */
public final class StatusServer implements AutoCloseable {

    /** Address of the events, relative to the page. */
    public static final String FEED = Site.FEED;

    private final HttpService service;
    private final Viewers viewers;
    private final Newest newest = new Newest();

    private StatusServer(String host, int port, int most, byte[] page, Function<String, byte[]> pages, boolean open)
            throws IOException {
        viewers = new Viewers(most);
        service = HttpService.start(host, port, new StatusSite(page, newest, pages, open), viewers,
            LiveServer.SILENT_NANOS);
    }

    /**
     * Starts a server.
     *
     * @param host  name or address to listen on, or {@code null} for this machine alone (loopback)
     * @param port  to listen on, or 0 for any that is free
     * @param most  how many viewers are admitted at the same time
     * @param page  the page at {@code /}
     * @param pages other pages by their path without its first slash; gives {@code null} where there is none; asked
     *              for one after the other
     * @throws IOException if the host is not known or the port is taken
     */
    public static StatusServer start(String host, int port, int most, byte[] page, Function<String, byte[]> pages)
            throws IOException {
        return new StatusServer(host, port, most, page, pages, false);
    }

    /**
     * Starts a server of a page and the files of a viewer that it shows in a sandboxed frame, on this machine and any
     * port. The frame has no origin, so whatever asks may read the files, which may reach this server alone; the page
     * is read by nobody else.
     */
    public static StatusServer ofViewer(byte[] page, Function<String, byte[]> files) throws IOException {
        return new StatusServer(null, 0, 1, page, files, true);
    }

    private record StatusSite(byte[] front, LiveFeed feed, Function<String, byte[]> pages, boolean isOpen)
        implements Site {

        @Override
        public byte[] page(String path) {
            return pages.apply(path);
        }
    }

    /** The newest state. */
    private static final class Newest implements LiveFeed {

        private volatile Runnable changed = () -> { };
        private Piece state;
        private boolean over;

        @Override
        public synchronized Piece piece(long position) {
            return state != null && position < state.next() ? state : over ? END : null;
        }

        @Override
        public synchronized boolean isComplete() {
            return over;
        }

        @Override
        public void onChange(Runnable listener) {
            changed = listener;
        }

        synchronized void show(String line) {
            state = new Piece(Answers.bytes("data: " + line + "\n\n"), state == null ? 1 : state.next() + 1);
            changed.run();
        }

        synchronized void end() {
            over = true;
            changed.run();
        }
    }

    /** Shows a state from now on: one line. */
    public void show(String line) {
        newest.show(line);
    }

    /** Nothing more follows. */
    public void end() {
        newest.end();
    }

    /** Waits, for a limited time, until every viewer has the last state. */
    public void awaitDelivery(long mostMs) throws InterruptedException {
        viewers.awaitServed(mostMs);
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    public URI address() {
        return service.address();
    }

    /** True if only this machine can reach it. */
    public boolean isLoopback() {
        return service.isLoopback();
    }

    @Override
    public void close() {
        end();
        service.close();
    }
}

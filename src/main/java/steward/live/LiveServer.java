package steward.live;

import java.io.IOException;
import java.net.URI;
import java.util.concurrent.TimeUnit;
import steward.replay.page.PageExtras;
import steward.replay.page.ReplayPage;

/**
 * Web server for a match while it is played. It serves the page, sends the match line by line to every open page, and
 * offers the match so far as a self-contained page. Access is read-only.
 *
 * <p>Caveat: there is no password. On any address but the loopback one, every client that reaches this machine can
 * watch.
 */
public final class LiveServer implements AutoCloseable {

    /** Viewers that can follow a page at the same time where nothing else is said. */
    public static final int USUAL_VIEWERS = 200;
    /** Viewers that {@code --viewers} may ask for. */
    public static final int MOST_VIEWERS = 10_000;
    /** How long a viewer may read nothing, in nanoseconds. */
    static final long SILENT_NANOS = TimeUnit.SECONDS.toNanos(10);

    /** Address of the copy, relative to the page. */
    private static final String COPY = "match.html";

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
     * @param most      how many viewers are admitted at the same time
     * @param title     of the page, plain text
     * @param recording the recording that the match is written to
     * @param extras    what the copy of the match has besides it
     * @throws IOException if the host is not known or the port is taken
     */
    public static LiveServer start(String host, int port, int most, String title, LiveRecording recording,
                                   PageExtras extras) throws IOException {
        return start(host, port, most, title, recording, extras, SILENT_NANOS);
    }

    static LiveServer start(String host, int port, int most, String title, LiveRecording recording, PageExtras extras,
                            long silentNanos) throws IOException {
        Viewers viewers = new Viewers(most);
        return new LiveServer(HttpService.start(host, port, new MatchSite(ReplayPage.live(title, Site.FEED, COPY),
            title, recording, extras, viewers), viewers, silentNanos), viewers);
    }

    /** The pages of a match. */
    private static final class MatchSite implements Site {

        private final byte[] front;
        private final String title;
        private final LiveRecording recording;
        private final PageExtras extras;
        private final Viewers viewers;
        /** The copy of the whole match, which all who have seen its end fetch. */
        private volatile byte[] whole;

        MatchSite(byte[] front, String title, LiveRecording recording, PageExtras extras, Viewers viewers) {
            this.front = front;
            this.title = title;
            this.recording = recording;
            this.extras = extras;
            this.viewers = viewers;
        }

        @Override
        public byte[] front() {
            return front;
        }

        @Override
        public LiveFeed feed() {
            return recording;
        }

        @Override
        public byte[] page(String path) {
            if (!path.equals(COPY)) {
                return null;
            }
            if (whole != null) {
                return whole;
            }
            boolean complete = recording.isComplete();
            byte[] replay = recording.replay();
            if (replay.length == 0) {
                return null;
            }
            byte[] copy = ReplayPage.of(replay, "match", title, extras);
            whole = complete ? copy : null;
            return copy;
        }

        @Override
        public void sent(byte[] page) {
            if (page == whole) {
                viewers.copied();
            }
        }
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    public URI address() {
        return service.address();
    }

    /** True if only this machine can reach it. */
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

    @Override
    public void close() {
        service.close();
    }
}

package steward.live;

import java.io.IOException;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ThreadLocalRandom;

/**
 * A small read-only HTTP server for browsers. One thread serves all connections without ever waiting for one of them; a
 * second makes pages that take their time. Viewers share the bytes that they are sent.
 *
 * <p>A viewer who reads nothing for some time, although there is something to read, is dropped. When its browser
 * connects again by itself, it is told so; it is recognised by its number, the id of the last event it knows.
 */
final class HttpService implements AutoCloseable {

    /** Connections besides those of viewers that are kept at a time; further ones are closed at once. */
    private static final int MOST_OTHERS = 1000;
    /** Distinct pages that are in memory at a time because somebody is being sent them. */
    private static final int MOST_PAGES = 8;
    /** Numbers of viewers that were dropped, the last ones. */
    private static final int MOST_DROPPED = 1000;
    /** Of the thread and, for each connection, of the system; in bytes. */
    private static final int BUFFER = 64 << 10;
    private static final long PERIOD_MS = 250;
    private static final long STOP_MS = 2000;

    private final ServerSocketChannel listening;
    private final Selector selector;
    private final Site site;
    private final AllowedHosts names;
    private final Viewers viewers;
    private final long silentNanos;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER);
    private final Queue<Runnable> made = new ConcurrentLinkedQueue<>();
    private final Queue<PageRequest> waiting = new ArrayDeque<>();
    private final ArrayDeque<Long> dropped = new ArrayDeque<>();
    private final Thread thread = daemon(this::serve, "live");
    /** Makes a page, or {@code null}. */
    private Thread maker;
    private long lastViewer = ThreadLocalRandom.current().nextLong(1L << 40);
    private long acceptsAgain = System.nanoTime();
    private volatile boolean closed;

    /** A page that somebody waits for. */
    private record PageRequest(Connection connection, String path) { }

    private HttpService(ServerSocketChannel listening, AllowedHosts names, Site site, Viewers viewers,
                        long silentNanos) throws IOException {
        this.listening = listening;
        this.names = names;
        this.site = site;
        this.viewers = viewers;
        this.silentNanos = silentNanos;
        selector = Selector.open();
        listening.configureBlocking(false);
        listening.register(selector, SelectionKey.OP_ACCEPT);
    }

    private static Thread daemon(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Starts one.
     *
     * @param host        name or address to listen on, or {@code null} for this machine alone (loopback)
     * @param port        to listen on, or 0 for any that is free
     * @param silentNanos how long a viewer may read nothing
     * @throws IOException if the host is not known or the port is taken
     */
    static HttpService start(String host, int port, Site site, Viewers viewers, long silentNanos) throws IOException {
        InetAddress address = host == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(host);
        ServerSocketChannel listening = ServerSocketChannel.open();
        try {
            listening.bind(new InetSocketAddress(address, port), MOST_OTHERS);
            HttpService service = new HttpService(listening, new AllowedHosts(host == null ? "localhost" : host,
                listening.socket().getLocalPort()), site, viewers, silentNanos);
            site.feed().onChange(service.selector::wakeup);
            service.thread.start();
            return service;
        } catch (IOException problem) {
            listening.close();
            throw problem;
        }
    }

    private void serve() {
        try {
            while (!closed) {
                selector.select(this::ready, PERIOD_MS);
                for (Runnable page = made.poll(); page != null; page = made.poll()) {
                    page.run();
                }
                long now = System.nanoTime();
                for (SelectionKey key : selector.keys()) {
                    if (key.attachment() instanceof Connection connection && key.isValid()) {
                        send(connection, now);
                    }
                }
                makeNext();
                listening.keyFor(selector).interestOps(now - acceptsAgain >= 0 ? SelectionKey.OP_ACCEPT : 0);
            }
        } catch (IOException | ClosedSelectorException broken) {
            closed = true;
        }
    }

    private void ready(SelectionKey key) {
        if (!(key.attachment() instanceof Connection connection)) {
            accept();
            return;
        }
        try {
            if (key.isWritable()) {
                connection.unblock();
            }
            if (key.isReadable()) {
                Request request = connection.read(buffer);
                if (request != null) {
                    answer(connection, request, System.nanoTime());
                }
            }
        } catch (IOException gone) {
            end(connection);
        }
    }

    private void accept() {
        try {
            for (SocketChannel channel = listening.accept(); channel != null; channel = listening.accept()) {
                if (selector.keys().size() > MOST_OTHERS + viewers.following()) {
                    channel.close();
                    continue;
                }
                channel.configureBlocking(false);
                channel.setOption(StandardSocketOptions.SO_SNDBUF, BUFFER);
                SelectionKey read = channel.register(selector, SelectionKey.OP_READ);
                read.attach(new Connection(channel, read, System.nanoTime()));
            }
        } catch (IOException full) {
            acceptsAgain = System.nanoTime() + PERIOD_MS * 1_000_000;   // no more files may be open
        }
    }

    private void answer(Connection connection, Request request, long now) {
        String[] words = request.words();
        if (words.length != 3 || !words[2].startsWith("HTTP/1.")) {
            connection.answer(now, Answers.refusal(Answers.BAD_REQUEST, "This is no request."));
        } else if (!names.accept(request.header("Host"))) {
            connection.answer(now, Answers.refusal(Answers.FORBIDDEN, "This server does not go by that name."));
        } else if (!words[0].equals("GET")) {
            connection.answer(now, Answers.refusal(Answers.WRONG_METHOD, "There is only something to get here."));
        } else {
            String path = words[1].replaceFirst("\\?.*", "");
            if (path.equals("/")) {
                connection.answer(now, Answers.head(Answers.OK, Answers.HTML, site.front().length), site.front());
            } else if (path.equals("/" + Site.FEED)) {
                follow(connection, request.header("Last-Event-ID"), now);
            } else {
                connection.await(now);
                waiting.add(new PageRequest(connection, path));
            }
        }
    }

    private void follow(Connection connection, String before, long now) {
        String why = null;
        if (dropped.stream().anyMatch(number -> Long.toString(number).equals(before))) {
            why = "This page has read nothing for " + silentNanos / 1_000_000_000
                + " s and is no longer sent anything.";
        } else if (!viewers.enter()) {
            why = "All places are taken: " + viewers.most() + " are watching, more are not admitted.";
        }
        if (why == null) {
            connection.follow(now, site.feed(), ++lastViewer);
        } else {
            connection.answer(now, Answers.head(Answers.OK, Answers.EVENTS, -1), Answers.refused(why));
        }
    }

    private void send(Connection connection, long now) {
        try {
            if (connection.isSilent(now, silentNanos)) {
                dropped.add(connection.viewer());
                if (dropped.size() > MOST_DROPPED) {
                    dropped.remove();
                }
                end(connection);
            } else if (!connection.send(buffer, now)) {
                end(connection);
            }
        } catch (IOException gone) {
            end(connection);
        }
    }

    private void end(Connection connection) {
        if (connection.viewer() != 0) {
            viewers.leave(connection.isSent());
        } else if (connection.page() != null && connection.isSent()) {
            site.sent(connection.page());
        }
        connection.close();
    }

    /** Has the next page made, unless too many are in memory. */
    private void makeNext() {
        if (maker != null || waiting.isEmpty() || selector.keys().stream().map(SelectionKey::attachment)
                .filter(Connection.class::isInstance).map(each -> ((Connection) each).page())
                .filter(page -> page != null).distinct().count() >= MOST_PAGES) {
            return;
        }
        PageRequest next = waiting.remove();
        maker = daemon(() -> {
            byte[] page = page(next.path().substring(1));
            made.add(() -> {
                maker = null;
                if (page == null) {
                    next.connection().answer(System.nanoTime(), Answers.refusal(Answers.NOT_FOUND,
                        "There is nothing here; the page is at /."));
                } else {
                    next.connection().answerPage(System.nanoTime(), site.isOpen()
                        ? Answers.openHead(next.path(), page.length)
                        : Answers.head(Answers.OK, Answers.type(next.path()), page.length), page);
                }
            });
            selector.wakeup();
        }, "live page");
        maker.start();
    }

    private byte[] page(String path) {
        try {
            return site.page(path);
        } catch (RuntimeException damaged) {
            return null;
        }
    }

    /** The address of the page; the loopback one if the server listens on all addresses. */
    URI address() {
        InetAddress bound = listening.socket().getInetAddress();
        InetAddress shown = bound.isAnyLocalAddress() ? InetAddress.getLoopbackAddress() : bound;
        String numeric = shown.getHostAddress().replaceFirst("%.*", "");
        String host = shown instanceof Inet6Address ? "[" + numeric + "]" : numeric;
        return URI.create("http://" + host + ":" + listening.socket().getLocalPort() + "/");
    }

    /** True if only this machine can reach it. */
    boolean isLoopback() {
        return listening.socket().getInetAddress().isLoopbackAddress();
    }

    @Override
    public void close() {
        closed = true;
        selector.wakeup();
        try {
            thread.join(STOP_MS);
            for (SelectionKey key : selector.keys()) {
                key.channel().close();
            }
            selector.close();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        } catch (IOException broken) {
            return;
        }
    }
}

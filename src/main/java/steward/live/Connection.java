package steward.live;

import java.io.IOException;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.concurrent.TimeUnit;

/**
 * One connection of the server: a request, then the pieces of its answer, as fast as the client reads them. Pieces are
 * shared by all connections, so that a slow client costs a position and little else. Used by one thread.
 */
final class Connection {

    /** So many bytes are made ready at most, beyond the piece that was begun. */
    private static final int AHEAD = 16 << 10;
    /** How long a request may take to arrive, and a client to close after its answer. */
    private static final long REQUEST_NANOS = TimeUnit.SECONDS.toNanos(2);
    /** How long an answer other than the feed may take: pages in memory are few. */
    private static final long PAGE_NANOS = TimeUnit.SECONDS.toNanos(60);
    /** How often a viewer is sent a comment while there is nothing else. */
    private static final long HEARTBEAT_NANOS = TimeUnit.SECONDS.toNanos(5);
    private static final byte[] HEARTBEAT = Answers.bytes(":\n\n");

    private final SocketChannel channel;
    private final SelectionKey key;
    private final ArrayDeque<byte[]> pieces = new ArrayDeque<>();
    private Request request = new Request();
    private LiveFeed feed;
    private long position;
    private long viewer;
    private byte[] page;
    /** Bytes of the first piece that have been sent. */
    private int offset;
    private int ready;
    private boolean blocked;
    private boolean answered;
    private boolean closing;
    private boolean inputEnded;
    private long due;
    private long lastSent;

    Connection(SocketChannel channel, SelectionKey key, long now) {
        this.channel = channel;
        this.key = key;
        due = now + REQUEST_NANOS;
        lastSent = now;
    }

    /** Number of the viewer, 0 for a client that is none. */
    long viewer() {
        return viewer;
    }

    /** The page that is being sent, or {@code null}. */
    byte[] page() {
        return page;
    }

    /**
     * Reads what has arrived.
     *
     * @return the request if this completes it, otherwise {@code null}
     * @throws IOException if the client is gone, or sends no request
     */
    Request read(ByteBuffer buffer) throws IOException {
        buffer.clear();
        int count = channel.read(buffer);
        if (count < 0) {
            inputEnded = true;
            if (request != null || feed != null || closing) {
                throw new IOException("gone");
            }
            key.interestOps(key.interestOps() & ~SelectionKey.OP_READ);
        }
        if (request == null || count <= 0) {
            return null;
        }
        request.add(buffer.flip());
        if (request.isTooLong()) {
            throw new IOException("too long");
        }
        Request complete = request.isComplete() ? request : null;
        request = complete == null ? request : null;
        return complete;
    }

    /** The client has room again. */
    void unblock() {
        blocked = false;
    }

    /** Answers with these bytes, and ends. */
    void answer(long now, byte[]... bytes) {
        due = now + PAGE_NANOS;
        lastSent = now;
        for (byte[] piece : bytes) {
            add(piece);
        }
        answered = true;
    }

    void answerPage(long now, byte[] head, byte[] bytes) {
        page = bytes;
        answer(now, head, bytes);
    }

    void follow(long now, LiveFeed followed, long number) {
        answer(now, Answers.head(Answers.OK, Answers.EVENTS, -1), Answers.bytes("id:" + number + "\n\n"));
        feed = followed;
        viewer = number;
    }

    /** Waits for a page that is being made. */
    void await(long now) {
        due = now + PAGE_NANOS;
    }

    private void add(byte[] piece) {
        if (piece.length > 0) {
            pieces.add(piece);
            ready += piece.length;
        }
    }

    /** True if the client has not read anything of what it should for so long. */
    boolean isSilent(long now, long nanos) {
        return viewer != 0 && blocked && now - lastSent > nanos;
    }

    /**
     * Sends what there is and the client has room for.
     *
     * @param buffer of this thread, outside the heap: else each write would be copied whole into one
     * @return false if the connection has done its duty, or has taken too long
     */
    boolean send(ByteBuffer buffer, long now) throws IOException {
        while (!blocked && !closing) {
            fill(now);
            if (ready == 0) {
                break;
            }
            buffer.clear();
            int from = offset;
            for (byte[] piece : pieces) {
                buffer.put(piece, from, Math.min(piece.length - from, buffer.remaining()));
                from = 0;
                if (!buffer.hasRemaining()) {
                    break;
                }
            }
            int offered = buffer.flip().remaining();
            int written = channel.write(buffer);
            blocked = written < offered;
            pass(written);
            lastSent = written > 0 ? now : lastSent;
        }
        int wanted = (inputEnded ? 0 : SelectionKey.OP_READ) | (blocked ? SelectionKey.OP_WRITE : 0);
        if (key.interestOps() != wanted) {
            key.interestOps(wanted);
        }
        if (answered && feed == null && ready == 0 && !closing) {
            closing = true;                                  // the client closes first: else it may lose the end
            due = now + REQUEST_NANOS;
            channel.shutdownOutput();
        }
        return !(closing && inputEnded) && (feed != null || now - due < 0);
    }

    private void fill(long now) {
        while (feed != null && ready < AHEAD) {
            LiveFeed.Piece next = feed.piece(position);
            if (next == null) {
                break;
            }
            add(next.bytes());
            position = next.next();
            if (next == LiveFeed.END) {
                feed = null;
                due = now + PAGE_NANOS;
            }
        }
        if (feed != null && ready == 0 && now - lastSent > HEARTBEAT_NANOS) {
            add(HEARTBEAT);
        }
    }

    private void pass(int written) {
        ready -= written;
        offset += written;
        while (!pieces.isEmpty() && offset >= pieces.peek().length) {
            offset -= pieces.poll().length;
        }
    }

    /** True if the client was sent everything: of a complete feed perhaps not the end, before which pages leave. */
    boolean isSent() {
        return answered && ready == 0 && (feed == null || feed.isComplete() && isAtEnd());
    }

    private boolean isAtEnd() {
        LiveFeed.Piece next = feed.piece(position);
        return next == null || next == LiveFeed.END;
    }

    /** Closes it, also for the system, which would go on to offer the rest. */
    void close() {
        try (channel) {
            if (!closing) {
                channel.setOption(StandardSocketOptions.SO_LINGER, 0);
            }
        } catch (IOException gone) {
            key.cancel();
        }
    }
}

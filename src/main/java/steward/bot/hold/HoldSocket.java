package steward.bot.hold;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * The referee's end of the socket to the first process of a bot's namespace, which stops the bot and lets it go on.
 * Each order is one byte, and the acknowledgement is the same byte. The launcher connects before it makes namespaces;
 * the connection is accepted with the first order, so that a bot which is never held costs only a file name. Not
 * thread-safe.
 */
public final class HoldSocket implements AutoCloseable {

    /** How long an acknowledgement may take: beside busy processes the other end waits for a processor. */
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(10);
    /** How long it is awaited without sleeping: on a free processor it comes sooner. */
    private static final long SPIN_NANOS = 100_000;
    private static final long NAP_NANOS = 50_000;

    private static final AtomicLong NUMBERS = new AtomicLong();

    private final Path path;
    private final ServerSocketChannel listening;
    private final ByteBuffer letter = ByteBuffer.allocateDirect(1);
    private SocketChannel connected;
    private volatile boolean broken;
    private volatile boolean silent;

    private HoldSocket(Path path, ServerSocketChannel listening) {
        this.path = path;
        this.listening = listening;
    }

    /**
     * Listens in a folder that only this user can enter.
     *
     * @return {@code null} where that is not possible: the path is too long, or the folder is gone
     */
    public static HoldSocket in(Path folder) {
        Path path = folder.resolve(Long.toString(NUMBERS.incrementAndGet(), Character.MAX_RADIX));
        try {
            ServerSocketChannel listening = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
            try {
                listening.configureBlocking(false);
                listening.bind(UnixDomainSocketAddress.of(path), 1);
                return new HoldSocket(path, listening);
            } catch (IOException problem) {
                listening.close();
                throw problem;
            }
        } catch (IOException | UnsupportedOperationException none) {
            return null;
        }
    }

    /** Returns where the launcher is to connect. */
    public Path path() {
        return path;
    }

    /**
     * Stops the bot, or lets it go on; returns when that is acknowledged.
     *
     * @return false if it is not: nobody has connected, the other end has gone, or it {@linkplain #isSilent is silent}
     */
    public boolean order(boolean stop) {
        if (broken) {
            return false;
        }
        try {
            if (connected == null) {
                connected = listening.accept();
                broken = connected == null;
                if (broken) {
                    return false;
                }
                connected.configureBlocking(false);
            }
            letter.clear().put((byte) (stop ? 'h' : 'c')).flip();
            broken = connected.write(letter) != 1;
            return !broken && isAcknowledged();
        } catch (IOException gone) {
            broken = true;
            return false;
        }
    }

    /** True if it cannot be used any more. */
    public boolean isBroken() {
        return broken;
    }

    /** True if the other end is there and did not acknowledge an order in time; no other order is given then. */
    public boolean isSilent() {
        return silent;
    }

    private boolean isAcknowledged() throws IOException {
        long begun = System.nanoTime();
        for (;;) {
            long waited = System.nanoTime() - begun;    // before the read: this thread may have been stopped meanwhile
            int count = connected.read(letter.clear());
            silent = count == 0 && waited > PATIENCE_NANOS;
            broken = count < 0 || silent;
            if (count > 0 || broken) {
                return !broken;
            }
            if (waited < SPIN_NANOS) {
                Thread.onSpinWait();
            } else {
                LockSupport.parkNanos(NAP_NANOS);
            }
        }
    }

    @Override
    public void close() {
        broken = true;
        try (listening; SocketChannel open = connected) {
            Files.deleteIfExists(path);
        } catch (IOException gone) {
            return;
        }
    }
}

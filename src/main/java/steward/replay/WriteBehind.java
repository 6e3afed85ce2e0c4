package steward.replay;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Output buffer that one thread of this JVM writes to the file, so that a match does not wait for a disk. The thread is
 * woken if it sleeps, and polls every {@value #PAUSE_MICROS} microseconds while there is work: a JVM that is killed
 * loses that much of a match at most. When the JVM exits in order, also by Ctrl-C, everything is written. At most
 * {@value #CAPACITY} bytes are buffered; when the buffer is full, the calling thread writes it to the file itself, as
 * do {@link #flush} and {@link #close}.
 *
 * <p>A failure to write is thrown by the next call, and remembered. One thread at a time may write.
 */
public class WriteBehind extends OutputStream {

    private static final int CAPACITY = 1 << 16;
    /** Buffers that wait for the next streams, at most. */
    private static final int MOST_KEPT = 16;
    private static final byte[] NOTHING = {};
    private static final int PAUSE_MICROS = 500;
    /** How long the thread looks for work before it sleeps, in pauses. */
    private static final int IDLE_PAUSES = 20;
    /** How long the end of the JVM waits for a write that is under way, in milliseconds. */
    private static final long PATIENCE_MS = 1000;

    private final OutputStream file;
    /** Held while writing to the file. */
    private final ReentrantLock writing = new ReentrantLock();
    private byte[] waiting = Writer.shared().buffer();
    private int count;
    private byte[] spare = Writer.shared().buffer();
    private volatile IOException problem;
    private boolean closed;

    /** @param file unbuffered is best; closed by {@link #close} */
    public WriteBehind(OutputStream file) {
        this.file = file;
        Writer.shared().add(this);
    }

    @Override
    public void write(int one) throws IOException {
        write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
        check();
        while (!take(bytes, from, length)) {
            drain();
            check();
        }
        Writer.shared().wake();
    }

    private synchronized boolean take(byte[] bytes, int from, int length) {
        if (count > 0 && count + length > CAPACITY) {
            return false;
        }
        if (count + length > waiting.length) {
            waiting = Arrays.copyOf(waiting, Math.max(2 * waiting.length, count + length));
        }
        System.arraycopy(bytes, from, waiting, count, length);
        count += length;
        return true;
    }

    /** Everything that was written is in the file, or the problem is thrown. */
    @Override
    public void flush() throws IOException {
        drain();
        check();
        file.flush();
    }

    @Override
    public void close() throws IOException {
        if (closed) {
            return;
        }
        closed = true;
        try (file) {
            flush();
        } catch (IOException found) {
            problem = problem == null ? found : problem;
            throw found;
        } finally {
            Writer.shared().remove(this);
            giveBack();
        }
    }

    private synchronized void giveBack() {
        Writer.shared().keep(waiting);
        Writer.shared().keep(spare);
        waiting = NOTHING;
        spare = NOTHING;
    }

    /** The first failure to write, or {@code null}. */
    protected final IOException failure() {
        return problem;
    }

    private void check() throws IOException {
        IOException found = problem;
        if (found != null) {
            throw new IOException(found.getMessage(), found);
        }
    }

    /** Writes the buffered bytes; returns whether there were any. */
    private boolean drain() {
        writing.lock();
        try {
            return drainLocked();
        } finally {
            writing.unlock();
        }
    }

    private boolean drainLocked() {
        byte[] bytes;
        int length;
        synchronized (this) {
            bytes = waiting;
            length = count;
            waiting = spare;
            spare = bytes;
            count = 0;
        }
        if (length > 0 && problem == null) {
            try {
                file.write(bytes, 0, length);
            } catch (IOException found) {
                problem = found;
            } catch (RuntimeException found) {
                problem = new IOException(found.toString(), found);
            }
        }
        return length > 0;
    }

    /** As {@link #drain}, unless another thread is writing. */
    private boolean drainUnlessBusy() {
        if (!writing.tryLock()) {
            return true;
        }
        try {
            return drainLocked();
        } finally {
            writing.unlock();
        }
    }

    /** At the end of the JVM. */
    private void drainPatiently() throws InterruptedIOException {
        try {
            if (writing.tryLock(PATIENCE_MS, TimeUnit.MILLISECONDS)) {
                drainLocked();                         // the lock is kept, so that no more is written
            }
        } catch (InterruptedException interrupted) {
            throw new InterruptedIOException();
        }
    }

    /** The thread, the streams whose buffers it writes, and buffers of streams that were closed. */
    private static final class Writer implements Runnable {

        private final Deque<byte[]> buffers = new ArrayDeque<>();
        private volatile WriteBehind[] open = {};
        private volatile boolean asleep;
        private volatile Thread thread;

        private static final class Shared {
            static final Writer INSTANCE = start();

            private static Writer start() {
                Writer writer = new Writer();
                Thread thread = new Thread(writer, "steward-writer");
                thread.setDaemon(true);
                writer.thread = thread;
                thread.start();
                Runtime.getRuntime().addShutdownHook(new Thread(writer::end, "steward-writer-end"));
                return writer;
            }
        }

        static Writer shared() {
            return Shared.INSTANCE;
        }

        synchronized byte[] buffer() {
            return buffers.isEmpty() ? new byte[1 << 13] : buffers.pop();
        }

        synchronized void keep(byte[] buffer) {
            if (buffer.length > 0 && buffer.length <= CAPACITY && buffers.size() < MOST_KEPT) {
                buffers.push(buffer);
            }
        }

        synchronized void add(WriteBehind stream) {
            WriteBehind[] more = Arrays.copyOf(open, open.length + 1);
            more[open.length] = stream;
            open = more;
        }

        synchronized void remove(WriteBehind stream) {
            open = Arrays.stream(open).filter(each -> each != stream).toArray(WriteBehind[]::new);
        }

        void wake() {
            if (asleep) {
                asleep = false;
                LockSupport.unpark(thread);
            }
        }

        @Override
        public void run() {
            int idle = 0;
            for (;;) {
                idle = work() ? 0 : idle + 1;
                if (idle < IDLE_PAUSES) {
                    LockSupport.parkNanos(this, TimeUnit.MICROSECONDS.toNanos(PAUSE_MICROS));
                    continue;
                }
                asleep = true;                         // set first, then checked again: no work is missed
                if (!work()) {
                    LockSupport.park(this);
                }
                asleep = false;
                idle = 0;
            }
        }

        private boolean work() {
            boolean any = false;
            for (WriteBehind stream : open) {
                any |= stream.drainUnlessBusy();
            }
            return any;
        }

        private void end() {
            try {
                for (WriteBehind stream : open) {
                    stream.drainPatiently();
                }
            } catch (InterruptedIOException interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }
}

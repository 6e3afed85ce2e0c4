package steward.replay.page;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Output stream that flushes instead of closing the underlying one, so that a writer can be closed and more can follow.
 */
public final class UnclosedOutputStream extends FilterOutputStream {

    /** @param out is flushed, not closed */
    public UnclosedOutputStream(OutputStream out) {
        super(out);
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
        out.write(bytes, from, count);
    }

    @Override
    public void close() throws IOException {
        flush();
    }
}

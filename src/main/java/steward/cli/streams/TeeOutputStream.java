package steward.cli.streams;

import java.io.IOException;
import java.io.OutputStream;

/** Output stream that writes everything to two others and closes neither. */
public final class TeeOutputStream extends OutputStream {

    private final OutputStream first;
    private final OutputStream second;

    /**
     * @param first  is written first
     * @param second gets nothing that could not be written to the first
     */
    public TeeOutputStream(OutputStream first, OutputStream second) {
        this.first = first;
        this.second = second;
    }

    @Override
    public void write(int one) throws IOException {
        first.write(one);
        second.write(one);
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
        first.write(bytes, from, count);
        second.write(bytes, from, count);
    }

    @Override
    public void flush() throws IOException {
        first.flush();
        second.flush();
    }
}

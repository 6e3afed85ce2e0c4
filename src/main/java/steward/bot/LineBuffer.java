package steward.bot;

import java.io.OutputStream;
import java.util.Arrays;

/** Reusable byte buffer for lines, which can be read in place. Not thread-safe. */
public final class LineBuffer extends OutputStream {

    private byte[] bytes = new byte[4096];
    private int size;

    /** The bytes themselves, valid up to {@link #size} and until something is written. */
    public byte[] bytes() {
        return bytes;
    }

    /** Returns how many bytes have been written since the last {@link #reset}. */
    public int size() {
        return size;
    }

    public void reset() {
        size = 0;
    }

    @Override
    public void write(int one) {
        makeRoom(1);
        bytes[size++] = (byte) one;
    }

    @Override
    public void write(byte[] source, int from, int count) {
        makeRoom(count);
        System.arraycopy(source, from, bytes, size, count);
        size += count;
    }

    private void makeRoom(int count) {
        if (count > bytes.length - size) {
            bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, Math.addExact(size, count)));
        }
    }
}

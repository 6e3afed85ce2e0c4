package steward.machines.check;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.zip.Deflater;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** Gzip compression of texts, with a bound on the unpacked size: a small archive may stand for an endless text. */
public final class GzipText {

    /** How long a replay may be, in bytes: some hundred times that of a long match. */
    public static final int LONGEST = 64 << 20;

    /** Bytes that are taken at once. */
    private static final int BUFFER = 1 << 13;
    /** Room for a usual text, in bytes: it grows where that is not enough. */
    private static final int USUAL = 1 << 16;

    private GzipText() { }

    public static byte[] compressed(byte[] bytes) {
        return compressed(bytes, bytes.length);
    }

    static byte[] compressed(byte[] bytes, int count) {
        return compressed(bytes, count, Deflater.DEFAULT_COMPRESSION);
    }

    /** Compresses so many of the bytes faster and not as short: for data that is sent once. */
    static byte[] quickly(byte[] bytes, int count) {
        return compressed(bytes, count, Deflater.BEST_SPEED);
    }

    private static byte[] compressed(byte[] bytes, int count, int level) {
        ByteArrayOutputStream out = new ByteArrayOutputStream(count / 4 + 64);
        try (GZIPOutputStream gzip = new Levelled(out, level)) {
            gzip.write(bytes, 0, count);
        } catch (IOException inMemory) {
            throw new UncheckedIOException(inMemory);
        }
        return out.toByteArray();
    }

    /**
     * All that is in it.
     *
     * @throws IOException if it is damaged, or longer than {@link #LONGEST}
     */
    public static byte[] bytes(byte[] compressed) throws IOException {
        return bytes(compressed, LONGEST);
    }

    /**
     * All that is in it.
     *
     * @param most bytes that it may have
     * @throws IOException if it is damaged or has more
     */
    public static byte[] bytes(byte[] compressed, int most) throws IOException {
        byte[] bytes = new byte[USUAL];
        int count = 0;
        try (InputStream in = new Bounded(new GZIPInputStream(new ByteArrayInputStream(compressed), BUFFER), most)) {
            for (int read = 0; read >= 0; read = in.read(bytes, count, bytes.length - count)) {
                count += read;
                if (count == bytes.length) {
                    bytes = Arrays.copyOf(bytes, (int) Math.min(2L * count, most + 1L));
                }
            }
        }
        return Arrays.copyOf(bytes, count);
    }

    /** Compresses more or less well. */
    private static final class Levelled extends GZIPOutputStream {

        Levelled(OutputStream out, int level) throws IOException {
            super(out, BUFFER);
            def.setLevel(level);
        }
    }

    /** Ends with an error after so many bytes. */
    private static final class Bounded extends FilterInputStream {

        private final int most;
        private long count;

        Bounded(InputStream in, int most) {
            super(in);
            this.most = most;
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] bytes, int from, int length) throws IOException {
            int read = super.read(bytes, from, length);
            count += Math.max(0, read);
            if (count > most) {
                throw new IOException("more than " + most + " bytes when unpacked");
            }
            return read;
        }
    }
}

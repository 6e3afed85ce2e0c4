package steward.machines.check;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.zip.Deflater;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** Gzip compression of texts, with a bound on the unpacked size: a small archive may stand for an endless text. */
public final class GzipText {

    /** How long a replay may be, in bytes: some hundred times that of a long match. */
    public static final int LONGEST = 64 << 20;

    /** Bytes that are taken at once. */
    private static final int BUFFER = 1 << 13;

    private GzipText() { }

    public static byte[] compressed(byte[] bytes) {
        return compressed(bytes, bytes.length, Deflater.DEFAULT_COMPRESSION);
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
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(compressed), BUFFER)) {
            byte[] bytes = in.readNBytes(most + 1);
            if (bytes.length > most) {
                throw new IOException("more than " + most + " bytes when unpacked");
            }
            return bytes;
        }
    }

    /** Compresses more or less well. */
    private static final class Levelled extends GZIPOutputStream {

        Levelled(OutputStream out, int level) throws IOException {
            super(out, BUFFER);
            def.setLevel(level);
        }
    }
}

package steward.json;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import steward.numerics.ShortestDecimal;
import tools.jackson.core.SerializableString;
import tools.jackson.core.io.NumberOutput;

/**
 * Buffer for a JSON value written byte by byte, for the frequent values of a turn, some of which are written several
 * times. {@link tools.jackson.core.JsonGenerator#writeRawValue(SerializableString)} copies its bytes. The caller
 * ensures that it is valid JSON. Numbers are written as by {@link JsonNumbers}. Reused from value to value without
 * allocating; not thread-safe.
 *
 * <p>Caveat: the methods for quoted text, which only field names need, throw.
 */
public final class RawJson implements SerializableString {

    /** The maximum number of characters of a long, with its sign. */
    private static final int MOST_OF_LONG = 20;
    private static final byte[] TRUE = text("true");
    private static final byte[] FALSE = text("false");
    private static final byte[] NULL = text("null");

    private final char[] digits = new char[ShortestDecimal.MAXIMUM_LENGTH];
    private byte[] bytes = new byte[256];
    private int size;

    /** The bytes of a constant text, such as {@code ,"x":}. */
    public static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** Starts a new value with the bytes of another. */
    public RawJson begin(RawJson other) {
        size = 0;
        return add(other.bytes, other.size);
    }

    /** Starts a new value with a text. */
    public RawJson begin(byte[] text) {
        size = 0;
        return add(text);
    }

    /** Adds text as it is. */
    public RawJson add(byte[] text) {
        return add(text, text.length);
    }

    /** Adds one ASCII character as it is. */
    public RawJson add(char one) {
        makeRoom(1);
        bytes[size++] = (byte) one;
        return this;
    }

    private RawJson add(byte[] text, int count) {
        makeRoom(count);
        System.arraycopy(text, 0, bytes, size, count);
        size += count;
        return this;
    }

    public RawJson add(boolean value) {
        return add(value ? TRUE : FALSE);
    }

    public RawJson add(long value) {
        if (value == Long.MIN_VALUE) {
            return add(text(Long.toString(value)));
        }
        makeRoom(MOST_OF_LONG);
        if (value < 0) {
            bytes[size++] = '-';
        }
        long magnitude = Math.abs(value);
        size += digits(magnitude);
        int place = size;
        for (; magnitude > Integer.MAX_VALUE; magnitude /= 10) {
            bytes[--place] = (byte) ('0' + magnitude % 10);
        }
        int rest = (int) magnitude;                    // dividing an int is cheaper
        do {
            int shorter = rest / 10;
            bytes[--place] = (byte) ('0' + rest - 10 * shorter);
            rest = shorter;
        } while (rest > 0);
        return this;
    }

    private static int digits(long magnitude) {
        int count = 1;
        for (long power = 10; count < MOST_OF_LONG - 1 && magnitude >= power; power *= 10) {
            count++;
        }
        return count;
    }

    /**
     * Adds a finite number.
     *
     * @throws IllegalStateException if it is infinite or NaN
     */
    public RawJson add(double value) {
        if (JsonNumbers.isWhole(value)) {
            return add((long) value);
        }
        int count = ShortestDecimal.write(JsonNumbers.finite(value), digits);
        if (count == ShortestDecimal.UNSUPPORTED) {
            return add(text(NumberOutput.toString(value, true)));
        }
        makeRoom(count);
        for (int k = 0; k < count; k++) {
            bytes[size + k] = (byte) digits[k];
        }
        size += count;
        return this;
    }

    /** Adds a finite number, or null for NaN. */
    public RawJson addOrNull(double value) {
        return Double.isNaN(value) ? add(NULL) : add(value);
    }

    private void makeRoom(int count) {
        if (count > bytes.length - size) {
            bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, Math.addExact(size, count)));
        }
    }

    @Override
    public String getValue() {
        return new String(bytes, 0, size, StandardCharsets.UTF_8);
    }

    @Override
    public int charLength() {
        return getValue().length();
    }

    @Override
    public byte[] asUnquotedUTF8() {
        return Arrays.copyOf(bytes, size);
    }

    @Override
    public int appendUnquotedUTF8(byte[] buffer, int offset) {
        if (size > buffer.length - offset) {
            return -1;
        }
        System.arraycopy(bytes, 0, buffer, offset, size);
        return size;
    }

    @Override
    public int appendUnquoted(char[] buffer, int offset) {
        String text = getValue();
        if (text.length() > buffer.length - offset) {
            return -1;
        }
        text.getChars(0, text.length(), buffer, offset);
        return text.length();
    }

    @Override
    public int writeUnquotedUTF8(OutputStream out) throws IOException {
        out.write(bytes, 0, size);
        return size;
    }

    @Override
    public int putUnquotedUTF8(ByteBuffer buffer) {
        if (size > buffer.remaining()) {
            return -1;
        }
        buffer.put(bytes, 0, size);
        return size;
    }

    @Override
    public char[] asQuotedChars() {
        throw noText();
    }

    @Override
    public byte[] asQuotedUTF8() {
        throw noText();
    }

    @Override
    public int appendQuotedUTF8(byte[] buffer, int offset) {
        throw noText();
    }

    @Override
    public int appendQuoted(char[] buffer, int offset) {
        throw noText();
    }

    @Override
    public int writeQuotedUTF8(OutputStream out) {
        throw noText();
    }

    @Override
    public int putQuotedUTF8(ByteBuffer buffer) {
        throw noText();
    }

    private static UnsupportedOperationException noText() {
        return new UnsupportedOperationException("a value in JSON is no text to be quoted");
    }
}

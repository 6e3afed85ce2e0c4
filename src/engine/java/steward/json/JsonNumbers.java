package steward.json;

import java.util.function.IntUnaryOperator;
import steward.numerics.ShortestDecimal;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.SerializableString;
import tools.jackson.core.StreamWriteFeature;
import tools.jackson.core.json.JsonFactory;

/**
 * Writer of the numbers of frames and replays: the shortest decimal that reads back as the same double, whole numbers
 * without a fraction. The text must not depend on the JDK (whose own conversion changed in 19). Jackson writes it, or,
 * without allocating, {@link ShortestDecimal}, whose text is the same.
 */
public final class JsonNumbers {

    /** Doubles up to this are exact integers, and so is their conversion to long: 2^53. */
    private static final double EXACT = 0x1p53;

    /** The factory that every frame and replay is written with; a generator may stay open over many lines. */
    public static final JsonFactory FACTORY = JsonFactory.builder()
        .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
        .rootValueSeparator((SerializableString) null)
        .build();

    private static final int HEX_DIGITS = 16;
    private static final char[] HEX = "0123456789abcdef".toCharArray();

    /** A buffer for digits, per thread. */
    private static final ThreadLocal<char[]> DIGITS =
        ThreadLocal.withInitial(() -> new char[ShortestDecimal.MAXIMUM_LENGTH]);

    private JsonNumbers() { }

    /** A field with a finite number. */
    public static void write(JsonGenerator out, String name, double value) {
        out.writeName(name);
        write(out, value);
    }

    /** A field with a finite number. */
    public static void write(JsonGenerator out, SerializableString name, double value) {
        out.writeName(name);
        write(out, value);
    }

    /** A field with a whole number. */
    public static void write(JsonGenerator out, SerializableString name, int value) {
        out.writeName(name);
        out.writeNumber(value);
    }

    /** A field that is true or false. */
    public static void write(JsonGenerator out, SerializableString name, boolean value) {
        out.writeName(name);
        out.writeBoolean(value);
    }

    /**
     * A finite number; -0.0 keeps its sign.
     *
     * @throws IllegalStateException if it is infinite or NaN: no frame and no replay may ever hold that
     */
    public static void write(JsonGenerator out, double value) {
        if (isWhole(value)) {
            out.writeNumber((long) value);
            return;
        }
        char[] digits = DIGITS.get();
        int count = ShortestDecimal.write(finite(value), digits);
        if (count == ShortestDecimal.UNSUPPORTED) {
            out.writeNumber(value);
        } else {
            out.writeNumber(digits, 0, count);
        }
    }

    /** True if a number is written without a fraction: -0.0 is not, for the sake of its sign. */
    static boolean isWhole(double value) {
        long whole = (long) value;
        return whole == value && Math.abs(value) <= EXACT && (whole != 0 || 1 / value > 0);
    }

    /** The number itself. @throws IllegalStateException if it is not finite */
    static double finite(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalStateException("the number " + value + " cannot be written: the state is damaged");
        }
        return value;
    }

    /** A field with an array of whole numbers, one for each index from 0. */
    public static void writeAll(JsonGenerator out, String name, int count, IntUnaryOperator number) {
        out.writeArrayPropertyStart(name);
        for (int k = 0; k < count; k++) {
            out.writeNumber(number.applyAsInt(k));
        }
        out.writeEndArray();
    }

    /** A field with an array of finite numbers. */
    public static void writeAll(JsonGenerator out, String name, double... numbers) {
        out.writeArrayPropertyStart(name);
        for (double number : numbers) {
            write(out, number);
        }
        out.writeEndArray();
    }

    /** A field with a finite number, or null for NaN. */
    public static void writeOrNull(JsonGenerator out, String name, double value) {
        out.writeName(name);
        writeOrNull(out, value);
    }

    /** A finite number, or null for NaN. */
    public static void writeOrNull(JsonGenerator out, double value) {
        if (Double.isNaN(value)) {
            out.writeNull();
        } else {
            write(out, value);
        }
    }

    /** A 64-bit hash as a string, see {@link steward.numerics.StateHash#toHex}. */
    public static void writeHash(JsonGenerator out, long hash) {
        char[] digits = DIGITS.get();
        for (int k = 0; k < HEX_DIGITS; k++) {
            digits[k] = HEX[(int) (hash >>> 4 * (HEX_DIGITS - 1 - k)) & 0xF];
        }
        out.writeString(digits, 0, HEX_DIGITS);
    }
}

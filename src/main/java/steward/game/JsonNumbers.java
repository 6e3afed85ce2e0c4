package steward.game;

import tools.jackson.core.JsonGenerator;
import tools.jackson.core.StreamWriteFeature;
import tools.jackson.core.json.JsonFactory;

/**
 * Numbers in frames and replays: the shortest decimal that reads back as the same double, whole numbers without a
 * fraction. The text must not depend on the JDK (whose own conversion changed in 19), so Jackson's is used.
 */
public final class JsonNumbers {

    /** Doubles up to this are exact integers, and so is their conversion to long: 2^53. */
    private static final double EXACT = 0x1p53;

    /** The factory that every frame and replay is written with. */
    public static final JsonFactory FACTORY = JsonFactory.builder()
        .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
        .build();

    private JsonNumbers() {
    }

    /** A field with a finite number. */
    public static void write(JsonGenerator out, String name, double value) {
        out.writeName(name);
        write(out, value);
    }

    /**
     * A finite number; -0.0 keeps its sign.
     *
     * @throws IllegalStateException if it is infinite or NaN: no frame and no replay may ever hold that
     */
    public static void write(JsonGenerator out, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalStateException("the number " + value + " cannot be written: the state is damaged");
        }
        long whole = (long) value;
        if (whole == value && Math.abs(value) <= EXACT && (whole != 0 || 1 / value > 0)) {
            out.writeNumber(whole);
        } else {
            out.writeNumber(value);
        }
    }

    /** A field with a finite number, or null for NaN. */
    public static void writeOrNull(JsonGenerator out, String name, double value) {
        if (Double.isNaN(value)) {
            out.writeNullProperty(name);
        } else {
            write(out, name, value);
        }
    }
}

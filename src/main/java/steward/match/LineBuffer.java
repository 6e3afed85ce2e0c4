package steward.match;

import java.io.ByteArrayOutputStream;

/** Bytes of lines that can be read in place. */
public final class LineBuffer extends ByteArrayOutputStream {

    LineBuffer() {
        super(4096);
    }

    /** The bytes themselves, valid up to {@code size()}. */
    public byte[] bytes() {
        return buf;
    }
}

package steward.codingame;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The two streams between the old referee and its tool, line by line. */
final class OldRefereeLines {

    /** The longest line that is read, in bytes: what a bot of ours may write. */
    static final int LONGEST = 64 * 1024;

    private final InputStream in;
    private final OutputStream out;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private boolean ended;
    private boolean tooLong;
    private int number;

    OldRefereeLines(InputStream in, OutputStream out) {
        this.in = new BufferedInputStream(in);
        this.out = new BufferedOutputStream(out);
    }

    /** Writes text; a tool that has ended is noticed by the next read. */
    void write(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        write(bytes, bytes.length);
    }

    void write(byte[] bytes, int length) {
        try {
            out.write(bytes, 0, length);
        } catch (IOException gone) {
            ended = true;
        }
    }

    void flush() {
        try {
            out.flush();
        } catch (IOException gone) {
            ended = true;
        }
    }

    /** The next line without its line end, what is beyond {@link #LONGEST} left out; {@code null} at the end. */
    byte[] read() {
        line.reset();
        tooLong = false;
        try {
            for (int b = ended ? -1 : in.read(); b != '\n'; b = in.read()) {
                if (b < 0) {
                    ended = true;
                    return null;
                }
                if (line.size() < LONGEST) {
                    line.write(b);
                } else {
                    tooLong |= b != '\r';
                }
            }
        } catch (IOException problem) {
            ended = true;
            return null;
        }
        number++;
        byte[] bytes = line.toByteArray();
        boolean carriageReturn = bytes.length > 0 && bytes[bytes.length - 1] == '\r';
        return carriageReturn ? Arrays.copyOf(bytes, bytes.length - 1) : bytes;
    }

    /** True if the last line read was longer than {@link #LONGEST}. */
    boolean tooLong() {
        return tooLong;
    }

    /** True if nothing more can be read. */
    boolean ended() {
        return ended;
    }

    /** Returns how many lines have been read. */
    int number() {
        return number;
    }
}

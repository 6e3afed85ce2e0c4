package steward.text;

import java.io.ByteArrayOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Output stream that protects a terminal from control characters of bots, files and command lines. Characters that
 * {@link TextFormat#isUnsafe} names become question marks. Line feed, tab, carriage return, backspace and sequences
 * that begin with escape and {@code [} are passed on, since colours and progress are made of them. Texts from outside
 * go through {@link TextFormat#plain}, which leaves none of these but line feed and tab.
 */
public final class TerminalOutputStream extends FilterOutputStream {

    private static final int ESCAPE = 0x1b;
    private static final int DELETE = 0x7f;
    /** First bytes in UTF-8 of the characters in question: of U+0080 to U+00BF, U+0600 to U+063F, U+2000 to U+2FFF. */
    private static final byte C1 = (byte) 0xc2;
    private static final byte ARABIC = (byte) 0xd8;
    private static final byte THREE_BYTES = (byte) 0xe2;
    private static final int LONGEST = 3;
    /** Leading bits of the further bytes of a character: {@code 10}. */
    private static final int CONTINUATION_BITS = 0xc0;
    private static final int CONTINUATION = 0x80;

    /** The bytes of a character, or an escape, that is not complete yet. */
    private final byte[] held = new byte[LONGEST];
    private int count;
    /** Part of the bytes being written that may pass: the terminal gets it at once. */
    private final ByteArrayOutputStream passed = new ByteArrayOutputStream();

    public TerminalOutputStream(OutputStream terminal) {
        super(terminal);
    }

    @Override
    public void write(int each) throws IOException {
        write(new byte[] {(byte) each}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int from, int length) throws IOException {
        passed.reset();
        for (int k = from; k < from + length; k++) {
            look(bytes[k] & 0xff);
        }
        passed.writeTo(out);
    }

    private void look(int next) {
        if (count > 0 && held[0] == ESCAPE) {
            count = 0;
            passed.write(next == '[' ? ESCAPE : '?');
        } else if (count > 0 && (next & CONTINUATION_BITS) == CONTINUATION) {
            held[count++] = (byte) next;
            if (count == (held[0] == THREE_BYTES ? LONGEST : LONGEST - 1)) {
                releaseCharacter();
            }
            return;
        } else {
            release();
        }
        if (next == ESCAPE || next == (C1 & 0xff) || next == (ARABIC & 0xff) || next == (THREE_BYTES & 0xff)) {
            held[count++] = (byte) next;
        } else {
            passed.write(isUnsafe(next) ? '?' : next);
        }
    }

    /** Of ASCII; the bytes of longer characters are none of its controls. */
    private static boolean isUnsafe(int next) {
        return next == DELETE || next < ' ' && next != '\n' && next != '\t' && next != '\r' && next != '\b';
    }

    private void releaseCharacter() {
        if (TextFormat.isUnsafe(new String(held, 0, count, StandardCharsets.UTF_8).charAt(0))) {
            held[0] = '?';
            count = 1;
        }
        release();
    }

    private void release() {
        passed.write(held, 0, count);
        count = 0;
    }
}

package steward.guest;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import steward.text.TextFormat;

/**
 * Reader of blocks of lines from a referee's output, with a bound, so that a flood becomes a fault and cannot fill the
 * memory.
 */
final class BlockReader {

    /** Bytes that a referee may say between two words of its host: an SDK says at most 1 MiB of view. */
    static final int MOST = 16 << 20;
    private static final int MOST_LINES = 200_000;
    private static final int BUFFER = 1 << 16;
    private static final int SHOWN = 80;

    private final InputStream in;
    private final byte[] buffer = new byte[BUFFER];
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private int from;
    private int to;
    private int read;
    private int count;

    BlockReader(InputStream in) {
        this.in = in;
    }

    /**
     * Returns all blocks up to the first that {@link RefereeBlock.Name#isLast() ends} the referee's turn to speak.
     *
     * @throws EOFException if the stream ends before
     * @throws RefereeFault if it says anything else than blocks, or too much
     */
    List<RefereeBlock> next() throws IOException {
        List<RefereeBlock> blocks = new ArrayList<>();
        read = 0;
        count = 0;
        RefereeBlock.Name name;
        do {
            String first = line();
            Matcher head = RefereeBlock.HEAD.matcher(first);
            if (!head.matches()) {
                throw new RefereeFault("said '" + TextFormat.plain(TextFormat.beginning(first, SHOWN))
                    + "', expected a block such as [[VIEW] 3]");
            }
            name = RefereeBlock.Name.valueOf(head.group(1));
            List<String> lines = new ArrayList<>();
            for (int left = Integer.parseInt(head.group(2)); left > 0; left--) {
                lines.add(line());
            }
            blocks.add(new RefereeBlock(name, lines));
        } while (!name.isLast());
        return blocks;
    }

    /** The next line without its end. */
    private String line() throws IOException {
        line.reset();
        if (++count > MOST_LINES) {
            throw new RefereeFault("said more than " + MOST_LINES + " lines at a time");
        }
        for (;;) {
            for (int at = from; at < to; at++) {
                if (buffer[at] == '\n') {
                    line.write(buffer, from, at - from);
                    from = at + 1;
                    String text = line.toString(StandardCharsets.UTF_8);
                    return text.endsWith("\r") ? text.substring(0, text.length() - 1) : text;
                }
            }
            line.write(buffer, from, to - from);
            from = 0;
            to = Math.max(0, in.read(buffer, 0, BUFFER));
            read += to;
            if (read > MOST) {
                throw new RefereeFault("said more than " + (MOST >> 20) + " MiB at a time");
            }
            if (to == 0) {
                throw new EOFException();
            }
        }
    }
}

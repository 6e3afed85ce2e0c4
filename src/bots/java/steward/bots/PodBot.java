package steward.bots;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * A bot for the pod race that uses JSON lines: a setup line, then a line per turn, each answered with one line, then
 * an end line. It can be called with lines, or {@link #run} as a program. One instance plays one match.
 */
public abstract class PodBot {

    private static final int LINE_FEED = '\n';

    private final JsonFactory json = new JsonFactory();
    private final FrameReader frame = new FrameReader();
    private final Commands commands = new Commands();
    private final Strategy strategy;

    private byte[] bytes = new byte[4096];
    private int filled;

    PodBot(Strategy strategy) {
        this.strategy = strategy;
    }

    /**
     * The first line of a match.
     *
     * @throws tools.jackson.core.JacksonException if it is not a setup frame
     */
    public final void setup(String line) {
        try (JsonParser in = json.createParser(ObjectReadContext.empty(), line)) {
            frame.read(in);
        }
    }

    /**
     * One turn.
     *
     * @return the answer, without line end
     * @throws tools.jackson.core.JacksonException if it is not a turn frame
     */
    public final String turn(String line) {
        try (JsonParser in = json.createParser(ObjectReadContext.empty(), line)) {
            frame.read(in);
        }
        return decide().toString();
    }

    private StringBuilder decide() {
        strategy.decide(frame.race, frame.pods, commands);
        return commands.answer(frame.pods, frame.race.player);
    }

    /** Plays one match over the standard streams; returns at the end frame or at the end of input. */
    final void run() throws IOException {
        run(new FileInputStream(FileDescriptor.in), new FileOutputStream(FileDescriptor.out));
    }

    /** Plays one match; each answer is one write, so that a stream without a buffer needs no flush. */
    final void run(InputStream in, OutputStream out) throws IOException {
        int scanned = 0;
        while (true) {
            while (scanned < filled && bytes[scanned] != LINE_FEED) {
                scanned++;
            }
            if (scanned < filled) {
                if (answerLine(scanned, out) == FrameReader.Type.END) {
                    return;
                }
                filled -= scanned + 1;
                System.arraycopy(bytes, scanned + 1, bytes, 0, filled);
                scanned = 0;
                continue;
            }
            if (filled == bytes.length) {
                bytes = Arrays.copyOf(bytes, 2 * filled);
            }
            int count = in.read(bytes, filled, bytes.length - filled);
            if (count < 0) {
                return;
            }
            filled += count;
        }
    }

    private FrameReader.Type answerLine(int length, OutputStream out) throws IOException {
        FrameReader.Type type;
        try (JsonParser in = json.createParser(ObjectReadContext.empty(), bytes, 0, length)) {
            type = frame.read(in);
        }
        if (type == FrameReader.Type.TURN) {
            out.write(decide().append('\n').toString().getBytes(StandardCharsets.ISO_8859_1));
            out.flush();
        }
        return type;
    }
}

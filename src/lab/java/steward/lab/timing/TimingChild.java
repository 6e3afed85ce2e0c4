package steward.lab.timing;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.function.Function;

/**
 * Other JVM of a timing: it reads its job, then obeys until its input ends, which it also does when the first JVM is no
 * more.
 *
 * <p>The job comes first. Then each word is a byte and its arguments: {@link #WARM_UP} with the seconds at least and at
 * most, answered by whether times are steady; {@link #ROUND} with the seconds at least, answered by nanoseconds and
 * bytes of a turn. Every answer begins with {@link #DONE}, or with {@link #FAILED} and a message instead.
 */
public final class TimingChild {

    static final byte WARM_UP = 1;
    static final byte ROUND = 2;
    static final byte DONE = 3;
    static final byte FAILED = 4;

    private TimingChild() { }

    /**
     * Serves until the input ends.
     *
     * @param open makes the turns that a job is about
     * @throws IOException if the other JVM cannot be reached
     */
    public static void serve(InputStream input, OutputStream output, Function<RungJob, TimedWork> open)
        throws IOException {
        DataInputStream in = new DataInputStream(new BufferedInputStream(input));
        try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(output))) {
            try {
                TimedPlace place = new WorkTimer(open.apply(RungJob.read(in)));
                out.writeByte(DONE);
                for (;;) {
                    out.flush();
                    answer(in.readByte(), in, out, place);
                }
            } catch (EOFException over) {
                return;
            } catch (Exception | LinkageError problem) {
                out.writeByte(FAILED);
                out.writeUTF(problem.toString());
            }
        }
    }

    private static void answer(byte word, DataInputStream in, DataOutputStream out, TimedPlace place)
        throws Exception {
        if (word == WARM_UP) {
            boolean steady = place.warmUp(in.readDouble(), in.readDouble());
            out.writeByte(DONE);
            out.writeBoolean(steady);
        } else {
            Stretch stretch = place.round(in.readDouble());
            out.writeByte(DONE);
            out.writeDouble(stretch.nanos());
            out.writeDouble(stretch.bytes());
        }
    }
}

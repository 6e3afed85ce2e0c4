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
 * Loop of the other JVM of a timing: it reads its job, then obeys orders until its input ends. The input also ends when
 * the first JVM does.
 *
 * <p>The job comes first. Then each order is a byte and its arguments: {@link #WARM_UP} with the seconds at least and
 * at most, {@link #ROUND} with the seconds at least. Every answer, also to the job, is {@link #DONE} with the
 * nanoseconds and bytes of a turn (0 if none was measured), or {@link #FAILED} with a message.
 */
public final class TimingChild {

    static final byte WARM_UP = 1;
    static final byte ROUND = 2;
    static final byte DONE = 3;
    static final byte FAILED = 4;
    private static final Stretch NONE = new Stretch(0, 0);

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
                for (Stretch measured = NONE;; measured = obey(in.readByte(), in, place)) {
                    out.writeByte(DONE);
                    out.writeDouble(measured.nanos());
                    out.writeDouble(measured.bytes());
                    out.flush();
                }
            } catch (EOFException over) {
                return;
            } catch (Exception | LinkageError problem) {
                out.writeByte(FAILED);
                out.writeUTF(problem.toString());
            }
        }
    }

    private static Stretch obey(byte word, DataInputStream in, TimedPlace place) throws Exception {
        if (word == ROUND) {
            return place.round(in.readDouble());
        }
        place.warmUp(in.readDouble(), in.readDouble());
        return NONE;
    }
}

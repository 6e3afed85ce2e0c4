package steward.lab.timing;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * Other JVM of a timing: it reads its job, then obeys until its input ends, which it also does when the first JVM is no
 * more.
 *
 * <p>The job comes first: its length in bytes, then these. Then each word is a byte and its arguments: {@link #WARM_UP}
 * with the seconds at least and at most, answered by whether times are steady; {@link #ROUND} with the seconds at
 * least, answered by nanoseconds and bytes of a turn. Every answer begins with {@link #DONE}, or with {@link #FAILED}
 * and a message instead.
 */
public final class TimingChild {

    static final byte WARM_UP = 1;
    static final byte ROUND = 2;
    static final byte DONE = 3;
    static final byte FAILED = 4;

    private TimingChild() { }

    /** Makes the turns that a job is about. */
    @FunctionalInterface
    public interface Job {

        /** @throws IOException if the job cannot be read */
        TimedTurns open(DataInputStream job) throws IOException;
    }

    /**
     * Serves until the input ends.
     *
     * @throws IOException if the other JVM cannot be reached
     */
    public static void serve(InputStream input, OutputStream output, Job job) throws IOException {
        DataInputStream in = new DataInputStream(new BufferedInputStream(input));
        try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(output))) {
            TimedPlace place = open(in, out, job);
            while (place != null) {
                answer(in.readByte(), in, out, place);
                out.flush();
            }
        } catch (EOFException over) {
            return;
        }
    }

    private static TimedPlace open(DataInputStream in, DataOutputStream out, Job job) throws IOException {
        byte[] bytes = in.readNBytes(in.readInt());
        try {
            TimedPlace place = new TurnTimer(job.open(new DataInputStream(new ByteArrayInputStream(bytes))));
            out.writeByte(DONE);
            return place;
        } catch (IOException | RuntimeException | LinkageError problem) {
            out.writeByte(FAILED);
            out.writeUTF(problem.toString());
            return null;
        } finally {
            out.flush();
        }
    }

    private static void answer(byte word, DataInputStream in, DataOutputStream out, TimedPlace place)
        throws IOException {
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

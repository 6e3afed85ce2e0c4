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
 * <p>The job comes first. Then each order is two numbers, the seconds at least and at most of a warm-up, or the seconds
 * at least of a round and NaN. Every answer, also to the job, is {@code true} with the nanoseconds and bytes of a turn
 * in the latest round (0 if none was measured), or {@code false} with a message.
 */
public final class TimingChild {

    private TimingChild() { }

    /** @param most NaN to order a round */
    static void order(DataOutputStream to, double least, double most) throws IOException {
        to.writeDouble(least);
        to.writeDouble(most);
    }

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
                Stretch measured = new Stretch(0, 0);
                while (true) {
                    out.writeBoolean(true);
                    out.writeDouble(measured.nanos());
                    out.writeDouble(measured.bytes());
                    out.flush();
                    double least = in.readDouble();
                    double most = in.readDouble();
                    if (Double.isNaN(most)) {
                        measured = place.round(least);
                    } else {
                        place.warmUp(least, most);
                    }
                }
            } catch (EOFException over) {
                return;
            } catch (Exception | LinkageError problem) {
                out.writeBoolean(false);
                out.writeUTF(problem.toString());
            }
        }
    }
}

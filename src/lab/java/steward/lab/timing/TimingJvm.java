package steward.lab.timing;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/**
 * Separate JVM that times one kind of turns, so that it shares no compiled code and no profile with another kind. It
 * runs the same Java on the same class path as this one, with the JVM's own choice of compilers, and ends when its
 * input does, so it does not outlive this one.
 */
final class TimingJvm implements TimedPlace {

    private static final int PATIENCE_SECONDS = 10;
    /** Time for this JVM to end when Ctrl-C ends both, before it complains of the other. */
    private static final int ENDING_MS = 300;
    private static final int SAID = 2000;

    private final Process process;
    private final DataOutputStream out;
    private final DataInputStream in;

    /**
     * Starts the other JVM.
     *
     * @param main the class whose main method serves as {@link TimingChild}
     * @throws IllegalStateException if it cannot be started, or does not understand its job
     */
    TimingJvm(Class<?> main, RungJob job) {
        try {
            process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC", "-XX:-UsePerfData", "-cp", System.getProperty("java.class.path"), main.getName())
                .start();
        } catch (IOException problem) {
            throw new IllegalStateException("a JVM for timing cannot be started: " + problem.getMessage(), problem);
        }
        out = new DataOutputStream(new BufferedOutputStream(process.getOutputStream()));
        in = new DataInputStream(new BufferedInputStream(process.getInputStream()));
        ask(job::write);
    }

    boolean isAlive() {
        return process.isAlive();
    }

    /** Message to the other JVM. */
    private interface Question {

        void write(DataOutputStream to) throws IOException;
    }

    private Stretch ask(Question question) {
        try {
            question.write(out);
            out.flush();
            if (!in.readBoolean()) {
                throw new IOException(in.readUTF());
            }
            return new Stretch(in.readDouble(), in.readDouble());
        } catch (IOException problem) {
            String said = said();
            close();
            throw new IllegalStateException("the JVM for timing has failed: "
                + (problem.getMessage() == null ? "it has ended" : problem.getMessage())
                + (said.isEmpty() ? "" : "; it said: " + said), problem);
        }
    }

    /** Returns the beginning of its standard error. */
    private String said() {
        try {
            process.getOutputStream().close();
        } catch (IOException gone) {
            // Then it has ended, and what it said can be read all the same.
        }
        try {
            TimeUnit.MILLISECONDS.sleep(ENDING_MS);
            return process.waitFor(1, TimeUnit.SECONDS)
                ? new String(process.getErrorStream().readNBytes(SAID), StandardCharsets.UTF_8).strip() : "";
        } catch (IOException problem) {
            return "";
        } catch (InterruptedException interruption) {
            Thread.currentThread().interrupt();
            return "";
        }
    }

    @Override
    public void warmUp(double least, double most) {
        ask(to -> TimingChild.order(to, least, most));
    }

    @Override
    public Stretch round(double least) {
        return ask(to -> TimingChild.order(to, least, Double.NaN));
    }

    @Override
    public void close() {
        try {
            process.getOutputStream().close();
        } catch (IOException gone) {
            // Then it has ended already.
        }
        try {
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (InterruptedException interruption) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}

package steward.cli.shared;

import java.io.BufferedOutputStream;
import java.io.Console;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import steward.text.TextFormat;

/**
 * What a command reads, and where it writes: UTF-8 whatever the locale says, since frames are printed byte for byte.
 * The standard output is buffered; {@link PrintStream#flush} shows what has come so far.
 */
public final class Streams {

    private static final String LINUX_DESCRIPTORS = "/proc/self/fd/";

    private final InputStream in;
    private final boolean inTerminal;
    private final Watched watched;
    private final PrintStream out;
    private final PrintStream err;
    private final boolean outTerminal;
    private final boolean errTerminal;

    /** Without an input. */
    public Streams(OutputStream out, OutputStream err, boolean outTerminal, boolean errTerminal) {
        this(InputStream.nullInputStream(), false, out, err, outTerminal, errTerminal);
    }

    /**
     * @param inTerminal  whether a person types {@code in}
     * @param outTerminal whether a person reads {@code out} as it comes
     * @param errTerminal likewise for {@code err}
     */
    public Streams(InputStream in, boolean inTerminal, OutputStream out, OutputStream err, boolean outTerminal,
            boolean errTerminal) {
        this.in = in;
        this.inTerminal = inTerminal;
        watched = new Watched(out);
        this.out = new PrintStream(new BufferedOutputStream(watched, 1 << 13), false, StandardCharsets.UTF_8);
        this.err = new PrintStream(err, true, StandardCharsets.UTF_8);
        this.outTerminal = outTerminal;
        this.errTerminal = errTerminal;
    }

    /** Those of the process. */
    public static Streams standard() {
        return new Streams(new FileInputStream(FileDescriptor.in), isTerminal(0),
            new FileOutputStream(FileDescriptor.out), new FileOutputStream(FileDescriptor.err), isTerminal(1),
            isTerminal(2));
    }

    /** Java only tells whether input and output both are terminals; Linux tells it of each. */
    private static boolean isTerminal(int descriptor) {
        Path link = Path.of(LINUX_DESCRIPTORS + descriptor);
        if (!Files.isSymbolicLink(link)) {
            return consoleIsTerminal();
        }
        try {
            String target = Files.readSymbolicLink(link).toString();
            return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty") || target.equals("/dev/console");
        } catch (IOException problem) {
            return false;
        }
    }

    /** From Java 22 on there is a console in any case, and it can be asked. */
    private static boolean consoleIsTerminal() {
        try {
            return System.console() != null && (boolean) Console.class.getMethod("isTerminal").invoke(System.console());
        } catch (ReflectiveOperationException older) {
            return true;
        }
    }

    /** What a person types, or a file or pipe; to be read by one at a time. */
    public InputStream in() {
        return in;
    }

    public boolean inTerminal() {
        return inTerminal;
    }

    /** For results. */
    public PrintStream out() {
        return out;
    }

    /** For errors, warnings and progress. */
    public PrintStream err() {
        return err;
    }

    public boolean outTerminal() {
        return outTerminal;
    }

    public boolean errTerminal() {
        return errTerminal;
    }

    /** Whether nobody takes the output any more ({@code | head}), so that there is no need to go on. */
    public boolean outEnded() {
        return watched.problem != null;
    }

    /** Why the output could not be written, or {@code null}; a reader that has gone is no problem. */
    public String outProblem() {
        out.flush();
        return watched.problem == null || watched.problem.contains("Broken pipe") ? null : watched.problem;
    }

    /** A warning: the program goes on. */
    public void warn(String message) {
        err.println("steward: warning: " + TextFormat.plain(message));
    }

    /** Remembers the first failure, which a print stream does not tell. */
    private static final class Watched extends FilterOutputStream {

        private volatile String problem;

        Watched(OutputStream out) {
            super(out);
        }

        @Override
        public void write(byte[] bytes, int from, int count) throws IOException {
            try {
                out.write(bytes, from, count);
            } catch (IOException failure) {
                problem = problem == null ? String.valueOf(failure.getMessage()) : problem;
                throw failure;
            }
        }
    }
}

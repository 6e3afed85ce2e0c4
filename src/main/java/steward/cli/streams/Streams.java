package steward.cli.streams;

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
import java.time.Instant;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import steward.text.TerminalOutputStream;
import steward.text.TextFormat;

/**
 * Input, outputs and hooks of a command. A command takes nothing else from its process but environment and folder, so
 * that a client can stand in for the process. The encoding is UTF-8 in every locale, because frames are printed byte
 * for byte. The standard output is buffered; {@link PrintStream#flush} writes it out.
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
    private final EndHooks hooks;
    private final Set<String> warned;

    /** Streams without an input. */
    public Streams(OutputStream out, OutputStream err, boolean outTerminal, boolean errTerminal) {
        this(InputStream.nullInputStream(), false, out, err, outTerminal, errTerminal);
    }

    /**
     * @param inTerminal  whether {@code in} is a terminal
     * @param outTerminal whether {@code out} is a terminal
     * @param errTerminal likewise for {@code err}
     */
    public Streams(InputStream in, boolean inTerminal, OutputStream out, OutputStream err, boolean outTerminal,
            boolean errTerminal) {
        this(in, inTerminal, out, err, outTerminal, errTerminal, EndHooks.OF_PROCESS);
    }

    /** As above, of a command that may end without its process. */
    public Streams(InputStream in, boolean inTerminal, OutputStream out, OutputStream err, boolean outTerminal,
            boolean errTerminal, EndHooks hooks) {
        this(in, inTerminal, out, err, outTerminal, errTerminal, hooks, ConcurrentHashMap.newKeySet());
    }

    private Streams(InputStream in, boolean inTerminal, OutputStream out, OutputStream err, boolean outTerminal,
            boolean errTerminal, EndHooks hooks, Set<String> warned) {
        this.hooks = hooks;
        this.warned = warned;
        this.in = in;
        this.inTerminal = inTerminal;
        watched = new Watched(outTerminal ? new TerminalOutputStream(out) : out);
        this.out = new PrintStream(new BufferedOutputStream(watched, 1 << 13), false, StandardCharsets.UTF_8);
        this.err = new PrintStream(errTerminal ? new TerminalOutputStream(err) : err, true, StandardCharsets.UTF_8);
        this.outTerminal = outTerminal;
        this.errTerminal = errTerminal;
    }

    private Streams(Streams from, PrintStream err) {
        in = from.in;
        inTerminal = from.inTerminal;
        watched = from.watched;
        out = from.out;
        outTerminal = from.outTerminal;
        this.err = err;
        errTerminal = false;
        hooks = from.hooks;
        warned = from.warned;
    }

    /** Returns streams whose standard output goes nowhere, for a command that prints JSON in place of its table. */
    public Streams withoutOutput() {
        return new Streams(in, inTerminal, OutputStream.nullOutputStream(), err, false, errTerminal, hooks, warned);
    }

    /** Returns these streams with a log for errors: each line has its time, and is an object of JSON if so wanted. */
    public Streams logging(boolean json) {
        return new Streams(this, new PrintStream(new EventStream(err, json, Instant::now), true,
            StandardCharsets.UTF_8));
    }

    public static Streams standard() {
        return new Streams(new FileInputStream(FileDescriptor.in), isTerminal(0),
            new FileOutputStream(FileDescriptor.out), new FileOutputStream(FileDescriptor.err), isTerminal(1),
            isTerminal(2));
    }

    /** Java only tells whether input and output are both terminals; Linux tells it for each. */
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

    /** From Java 22 on there is always a console, which tells whether it is a terminal. */
    private static boolean consoleIsTerminal() {
        try {
            return System.console() != null && (boolean) Console.class.getMethod("isTerminal").invoke(System.console());
        } catch (ReflectiveOperationException older) {
            return true;
        }
    }

    /** The typed input, or a file or pipe; to be read by one reader at a time. */
    public InputStream in() {
        return in;
    }

    public boolean inTerminal() {
        return inTerminal;
    }

    /** Hooks that are started when the command is ended from outside. */
    public EndHooks hooks() {
        return hooks;
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

    public Colour outColour() {
        return Colour.of(outTerminal);
    }

    public Colour errColour() {
        return Colour.of(errTerminal);
    }

    /** True if the output has no reader any more ({@code | head}), so that the command can stop. */
    public boolean outEnded() {
        return watched.problem != null;
    }

    /** Returns why the output could not be written, or {@code null}; a reader that has closed it is no problem. */
    public String outProblem() {
        out.flush();
        return watched.problem == null || watched.problem.contains("Broken pipe") ? null : watched.problem;
    }

    /** Prints a warning, once however often it is given, and nothing for {@code null}; the program goes on. */
    public void warn(String message) {
        if (message != null && warned.add(message)) {
            err.println("steward: " + errColour().warning("warning:") + " " + TextFormat.plain(message));
        }
    }

    /** Keeps the first failure, which a print stream does not report. */
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

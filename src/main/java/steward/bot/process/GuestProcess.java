package steward.bot.process;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.TimeUnit;
import steward.bot.FaultMessages;
import steward.bot.isolation.Launch;

/**
 * Process with the isolation and limits of a bot but a format of its own: the referee program of a guest. Its reader
 * has the streams; a blocked read or write ends when the process is closed.
 */
public final class GuestProcess {

    /** How long a process may take to exit after closing its output, in milliseconds, to be reported as exited. */
    private static final long EXIT_MS = 1000;

    private final ProcessGroup group;
    private final StderrFile stderr;

    private GuestProcess(ProcessGroup group, StderrFile stderr) {
        this.group = group;
        this.stderr = stderr;
    }

    /** Starts a program. @throws IOException if the system refuses it */
    public static GuestProcess start(Launch launch) throws IOException {
        Sentinel.shared().start();
        StderrFile stderr = StderrFile.create();
        try {
            return new GuestProcess(ProcessGroup.start(launch, stderr), stderr);
        } catch (IOException problem) {
            stderr.close();
            throw problem;
        } finally {
            stderr.unlink();
        }
    }

    public OutputStream input() {
        return group.process().getOutputStream();
    }

    public InputStream output() {
        return group.process().getInputStream();
    }

    /** Bounds the file of its stderr; to be called now and then while the program works. */
    public void bound() {
        stderr.bound();
    }

    /** Returns its stderr since the last call, bounded; {@code null} when nothing. */
    public String stderr() {
        return stderr.collect(true);
    }

    /** Describes the end of its output: its exit status if it has exited. */
    public String ending() {
        return group.awaitExit(TimeUnit.MILLISECONDS.toNanos(EXIT_MS))
            ? FaultMessages.exited(group.process().exitValue()) : "closed its output before answering";
    }

    /** Kills whatever is left of it, from any thread. */
    public void close() {
        group.kill();
        stderr.close();
    }
}

package steward.bot.process;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import steward.bot.command.ProgramFinder;

/**
 * A bot's process and its descendants: a session and process group of its own, made by {@code setsid}, so that one
 * signal reaches a wrapper script together with its children. Without {@code setsid}, the process and its descendants.
 *
 * <p>Caveat: a process that leaves the group on purpose is found only while its parents are alive.
 */
final class ProcessGroup {

    /** How long a killed process may take to disappear before its group is checked again, in milliseconds. */
    private static final long DYING_MS = 200;

    private final Process process;

    /** Equivalent to {@link Process} for signals, but it never uses the streams and so cannot block. */
    private final ProcessHandle handle;
    private final String target;
    private boolean killed;

    private ProcessGroup(Process process, boolean grouped) {
        this.process = process;
        handle = process.toHandle();
        target = (grouped ? "-" : "") + process.pid();
    }

    /** The prefix of a command that gives it a session of its own; empty where that is not possible. */
    static List<String> ownSession() {
        return Setsid.WORDS;
    }

    private static final class Setsid {
        static final List<String> WORDS = find();

        private static List<String> find() {
            Path program = ProgramFinder.find("setsid");
            return program == null ? List.of() : List.of(program.toString());
        }
    }

    /**
     * Starts a program with pipes for its input and output.
     *
     * @throws IOException when it could not be started
     */
    static ProcessGroup start(List<String> command, StderrFile stderr) throws IOException {
        List<String> words = new ArrayList<>(ownSession());
        words.addAll(command);
        Process process = new ProcessBuilder(words)
            .redirectError(ProcessBuilder.Redirect.appendTo(stderr.file())).start();
        ProcessGroup group = new ProcessGroup(process, !ownSession().isEmpty());
        Sentinel.shared().watch(group.target);
        return group;
    }

    /** The first process, leader of the group. */
    Process process() {
        return process;
    }

    /** Waits for the first process to exit; returns whether it has. */
    boolean awaitExit(long nanos) {
        try {
            return process.waitFor(nanos, TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return !process.isAlive();
        }
    }

    /** Kills all remaining processes; the second call does nothing. */
    synchronized void kill() {
        if (killed) {
            return;
        }
        killed = true;
        Sentinel sentinel = Sentinel.shared();
        boolean running = process.isAlive();
        if (!running && ProcessHandle.of(process.pid()).isPresent()) {
            // The number now belongs to another process, so the group no longer exists: nothing is left.
            sentinel.forget(target);
            return;
        }
        List<ProcessHandle> descendants = running ? handle.descendants().toList() : List.of();
        boolean found = sentinel.kill(target);
        handle.destroyForcibly();
        descendants.forEach(ProcessHandle::destroyForcibly);
        if (running && !found && awaitExit(TimeUnit.MILLISECONDS.toNanos(DYING_MS))) {
            // Killed before the group was made, or while it was being made.
            sentinel.kill(target);
        }
    }
}

package steward.bot.process;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import steward.bot.FaultMessages;
import steward.bot.hold.HoldSocket;
import steward.bot.isolation.ControlGroup;
import steward.bot.isolation.Launch;
import steward.bot.isolation.ProcessTree;

/**
 * Process group of a bot, made by {@code setsid}, so that one signal reaches a wrapper script together with its
 * children. Without {@code setsid}, it is the process and its descendants. In a sandbox the group holds the processes
 * that wait outside and the first process of the bot's PID namespace, whose end ends everything in it.
 *
 * <p>Caveat: without a sandbox a process that leaves the group on purpose is found only while its parents are alive.
 */
final class ProcessGroup {

    /** How long a killed process may take to disappear before its group is checked again, in milliseconds. */
    private static final long DYING_MS = 200;

    private final Process process;

    /** Equivalent to {@link Process} for signals, but it never uses the streams and so cannot block. */
    private final ProcessHandle handle;
    private final String target;
    private final ControlGroup controlGroup;
    private final HoldSocket holdSocket;
    /** {@code null} where nothing limits memory, or a control group does. */
    private MemoryWatch memory;
    private boolean killed;

    private ProcessGroup(Process process, boolean grouped, ControlGroup controlGroup, HoldSocket holdSocket) {
        this.process = process;
        this.controlGroup = controlGroup;
        this.holdSocket = holdSocket;
        handle = process.toHandle();
        target = (grouped ? "-" : "") + process.pid();
    }

    /**
     * Starts a program with pipes for its input and output.
     *
     * @throws IOException when it could not be started
     */
    static ProcessGroup start(Launch launch, StderrFile stderr) throws IOException {
        ControlGroup controlGroup = ControlGroup.forBot(launch.isolation());
        HoldSocket holdSocket = launch.holdsByInit() ? HoldFolder.shared().socket() : null;
        Process process;
        try {
            process = launch.builder(controlGroup, holdSocket == null ? null : holdSocket.path())
                .redirectError(ProcessBuilder.Redirect.appendTo(stderr.file())).start();
        } catch (IOException problem) {
            if (controlGroup != null) {
                controlGroup.remove();
            }
            if (holdSocket != null) {
                holdSocket.close();
            }
            throw problem;
        }
        ProcessGroup group = new ProcessGroup(process, !Launch.ownSession().isEmpty(), controlGroup, holdSocket);
        Sentinel.shared().watch(group.target);
        long most = launch.isolation().limits().memory();
        group.memory = most == 0 || controlGroup != null && controlGroup.limits() ? null : new MemoryWatch(group, most);
        return group;
    }

    /** The first process, leader of the group. */
    Process process() {
        return process;
    }

    /** All processes that are there now, as this machine numbers them; the first process is the first. */
    List<Long> processes() {
        return ProcessTree.of(process.pid());
    }

    /** CPU time of all that was ever in its control group, in nanoseconds; -1 if there is none. */
    long cpu() {
        return controlGroup == null ? -1 : controlGroup.cpu();
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

    /** True if all of the bot can be stopped: by the first process of its namespace, or its control group. */
    boolean canPause() {
        return holdSocket != null && !holdSocket.isBroken() || controlGroup != null;
    }

    /** Fault for which nothing more can be asked of the bot, but for its end; {@code null} if there is none. */
    String fault() {
        return holdSocket != null && holdSocket.isSilent() ? FaultMessages.LOST
            : memory == null ? null : memory.fault();
    }

    /**
     * Stops the bot, or lets it go on, and returns when that is done: by the first process of its namespace, or its
     * control group, or else its process group, and then not those that have left it.
     */
    synchronized void pause(boolean stop) {
        if (killed || holdSocket != null && holdSocket.order(stop)
                || controlGroup != null && controlGroup.pause(stop)) {
            return;
        }
        Sentinel.shared().pause(target, stop);
    }

    /** Stops the bot unless it has been asked by now. */
    synchronized void pauseIf(BooleanSupplier waiting) {
        if (waiting.getAsBoolean()) {
            pause(true);
        }
    }

    /** Kills all remaining processes; the second call does nothing. */
    synchronized void kill() {
        if (killed) {
            return;
        }
        killed = true;
        killAll();
        if (holdSocket != null) {
            holdSocket.close();
        }
        if (controlGroup != null) {
            DaemonThreadPool.run(controlGroup::remove);
        }
        if (memory != null) {
            memory.end();
        }
    }

    private void killAll() {
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

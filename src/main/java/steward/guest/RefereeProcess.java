package steward.guest;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import steward.bot.ErrorLine;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.DaemonThreadPool;
import steward.bot.process.GuestProcess;
import steward.text.TextFormat;

/**
 * Running referee program that is asked in blocks and answers in blocks, within a limit of real time. Any other
 * behaviour is a {@link RefereeFault} with the end of its stderr; afterwards the process is dead.
 */
final class RefereeProcess {

    /** Milliseconds between two looks at the stderr of a referee that computes. */
    private static final long LOOK_MS = 100;
    private static final int STDERR_LINES = 10;
    private static final int STDERR_WIDTH = 300;

    private final List<String> command;
    private final Isolation isolation;
    private final GuestProcess process;
    private final BlockReader reader;
    private volatile int limitMs;
    private volatile boolean closed;

    private RefereeProcess(List<String> command, Isolation isolation, GuestProcess process, int limitMs) {
        this.command = command;
        this.isolation = isolation;
        this.process = process;
        this.limitMs = limitMs;
        reader = new BlockReader(process.output());
    }

    /** Starts a referee, kept apart as a bot is, but for limits of memory, which a JVM does not bear. */
    static RefereeProcess start(List<String> command, Isolation isolation, int limitMs) {
        Launch launch = new Launch(command, isolation.withoutMemoryLimit().holding(HoldPolicy.NEVER), List.of());
        try {
            return new RefereeProcess(command, isolation, GuestProcess.start(launch), limitMs);
        } catch (IOException problem) {
            throw new RefereeFault("cannot be started: " + problem.getMessage());
        }
    }

    /** True if it was started so. */
    boolean isOf(List<String> otherCommand, Isolation otherIsolation) {
        return command.equals(otherCommand) && isolation.equals(otherIsolation);
    }

    /** Sets the limit of each answer, in milliseconds: the next game may be of another scene. */
    void limit(int ms) {
        limitMs = ms;
    }

    /** Says blocks and returns those of the answer. */
    List<RefereeBlock> exchange(String blocks) {
        FutureTask<List<RefereeBlock>> task = new FutureTask<>(() -> {
            try {
                process.input().write(blocks.getBytes(StandardCharsets.UTF_8));
                process.input().flush();
            } catch (IOException gone) {
                // It has ended or closed its input; what it said before counts, and reading shows the rest.
            }
            return reader.next();
        });
        DaemonThreadPool.run(task);
        List<RefereeBlock> answer = await(task);
        RefereeBlock last = answer.get(answer.size() - 1);
        if (last.name() == RefereeBlock.Name.FAIL) {
            throw fault("failed: " + String.join(" | ", last.lines()));
        }
        return answer;
    }

    private List<RefereeBlock> await(FutureTask<List<RefereeBlock>> task) {
        for (long waited = 0; waited < limitMs; waited += LOOK_MS) {
            try {
                return task.get(Math.min(LOOK_MS, limitMs - waited), TimeUnit.MILLISECONDS);
            } catch (TimeoutException working) {
                process.bound();
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
                throw fault("was interrupted");
            } catch (ExecutionException failed) {
                throw fault(failed.getCause() instanceof RefereeFault found ? found.getCause().getMessage()
                    : closed ? "was ended" : process.ending());
            }
        }
        throw fault("said nothing for " + limitMs + " ms that ends its turn to speak");
    }

    /** The fault with the end of stderr; the process is killed. */
    RefereeFault fault(String problem) {
        String said = closed ? null : process.stderr();
        close();
        if (said == null || said.isBlank()) {
            return new RefereeFault(problem + "; it wrote nothing to its stderr");
        }
        List<String> lines = said.lines().filter(line -> !line.isBlank()).toList();
        int error = ErrorLine.index(lines);
        int from = Math.max(0, error < 0 ? lines.size() - STDERR_LINES : Math.min(lines.size() - STDERR_LINES, error));
        return new RefereeFault(problem + "; its stderr: " + String.join(" | ",
            lines.subList(from, Math.min(lines.size(), from + STDERR_LINES)).stream()
                .map(line -> TextFormat.plain(TextFormat.beginning(line.strip(), STDERR_WIDTH))).toList()));
    }

    /** Drops what it has written to its stderr: the game is over. */
    void forgetStderr() {
        process.stderr();
    }

    /** Kills it, from any thread. */
    synchronized void close() {
        if (!closed) {
            closed = true;
            process.close();
        }
    }
}

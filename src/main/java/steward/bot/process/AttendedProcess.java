package steward.bot.process;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import steward.bot.Answer;
import steward.bot.AnswerReader;
import steward.bot.FaultMessages;
import steward.bot.Player;
import steward.bot.command.Program;

/**
 * Bot program that a person attends to, perhaps with a debugger: no deadline, no watchdog, no session of its own. Its
 * input and output are connected to the referee; the terminal is left as it is. Stderr is left too if that is wanted;
 * otherwise it is passed on, and after the end of the input only as much as {@link #showRest} is asked for.
 *
 * <p>Caveat: it ends only by itself, by its user, or by {@link #kill}.
 */
public final class AttendedProcess implements Player {

    /** Bytes that are kept of what comes after the end of its input. */
    private static final int MOST_REST = 1 << 16;
    private static final long REST_MS = 500;

    private final String name;
    private final Process process;
    private final OutputStream input;
    private final AnswerReader output;
    private byte[] queued = {};
    private volatile boolean finished;
    private final OutputStream stderr;
    private final ByteArrayOutputStream rest = new ByteArrayOutputStream();
    private final CountDownLatch passed = new CountDownLatch(1);

    private AttendedProcess(String name, Process process, OutputStream stderr) {
        this.name = name;
        this.process = process;
        this.stderr = stderr;
        input = process.getOutputStream();
        output = new AnswerReader(process.getInputStream());
    }

    /**
     * Starts a program.
     *
     * @param name    its name in messages
     * @param stderr  to which its stderr is passed on; {@code null} leaves it as it is
     * @throws IOException when it could not be started
     */
    public static AttendedProcess start(String name, Program program, OutputStream stderr) throws IOException {
        Process process = new ProcessBuilder(program.words()).directory(program.folder().toFile())
            .redirectError(stderr == null ? ProcessBuilder.Redirect.INHERIT : ProcessBuilder.Redirect.PIPE).start();
        AttendedProcess attended = new AttendedProcess(name, process, stderr);
        if (stderr != null) {
            DaemonThreadPool.run(attended::passOn);
        }
        return attended;
    }

    private void passOn() {
        byte[] bytes = new byte[1 << 13];
        try (InputStream in = process.getErrorStream()) {
            for (int count = in.read(bytes); count >= 0; count = in.read(bytes)) {
                if (!finished) {
                    stderr.write(bytes, 0, count);
                    stderr.flush();
                } else if (rest.size() < MOST_REST) {
                    rest.write(bytes, 0, count);
                }
            }
        } catch (IOException gone) {
            return;
        } finally {
            passed.countDown();
        }
    }

    /** Passes on what it wrote to stderr behind the end of its input; for one that has ended by itself. */
    public void showRest() throws InterruptedException {
        if (stderr != null && passed.await(REST_MS, TimeUnit.MILLISECONDS)) {
            try {
                rest.writeTo(stderr);
                stderr.flush();
            } catch (IOException gone) {
                return;
            }
        }
    }

    /** The number of the process, to attach a debugger to it. */
    public long pid() {
        return process.pid();
    }

    public CompletableFuture<?> ended() {
        return process.onExit();
    }

    /** Waits for the process to end; returns whether it has ended. */
    public boolean awaitEnd(long mostMs) throws InterruptedException {
        return process.waitFor(mostMs, TimeUnit.MILLISECONDS);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void tell(byte[] lines, int length) {
        byte[] more = new byte[queued.length + length];
        System.arraycopy(queued, 0, more, 0, queued.length);
        System.arraycopy(lines, 0, more, queued.length, length);
        queued = more;
    }

    /** The limit is ignored. */
    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        tell(frame, length);
        send();
        long start = System.nanoTime();
        AnswerReader.Outcome outcome = output.await(answerLines);
        answer.setNanos(System.nanoTime() - start);
        switch (outcome) {
            case COMPLETE -> output.take(answerLines, answer);
            case TOO_LONG -> answer.setFault(FaultMessages.tooLong(AnswerReader.LINE_LIMIT));
            default -> answer.setFault(endText());
        }
        return outcome == AnswerReader.Outcome.COMPLETE ? Ending.ANSWERED : Ending.FAULT;
    }

    private void send() {
        try {
            input.write(queued);
            input.flush();
        } catch (IOException gone) {
            // The process has ended or closed its input; reading its output shows which.
            return;
        } finally {
            queued = new byte[0];
        }
    }

    /** The fault after the end of the output; a program under a debugger may still exist. */
    private String endText() {
        try {
            return awaitEnd(TimeUnit.SECONDS.toMillis(1)) ? FaultMessages.exited(process.exitValue())
                : "closed its output before answering";
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return "closed its output before answering";
        }
    }

    /** Sends the last lines and closes its input; the process may keep running. */
    @Override
    public void finish(byte[] lines, int length) {
        if (finished) {
            return;
        }
        finished = true;
        if (lines != null) {
            tell(lines, length);
        }
        DaemonThreadPool.run(() -> {
            send();
            try {
                input.close();
            } catch (IOException gone) {
                return;
            }
        });
    }

    /** Asks the process and its descendants to end, and kills those still alive after the given time. */
    public void kill(long graceMs) throws InterruptedException {
        List<ProcessHandle> descendants = process.descendants().toList();
        process.destroy();
        descendants.forEach(ProcessHandle::destroy);
        awaitEnd(graceMs);
        process.destroyForcibly();
        descendants.forEach(ProcessHandle::destroyForcibly);
    }
}

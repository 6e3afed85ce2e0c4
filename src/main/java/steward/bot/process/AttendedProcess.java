package steward.bot.process;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.AnswerReader;
import steward.bot.FaultMessages;
import steward.bot.Player;

/**
 * A bot program that a person looks after, perhaps with a debugger: no deadline, no watchdog, no session of its own.
 * Its input and output are ours; its stderr and its terminal are left as they are.
 *
 * <p>Caveat: nothing ends it but itself, its person, or {@link #kill}.
 */
public final class AttendedProcess implements Player {

    private final String name;
    private final Process process;
    private final OutputStream input;
    private final AnswerReader output;
    private byte[] queued = {};
    private boolean finished;

    private AttendedProcess(String name, Process process) {
        this.name = name;
        this.process = process;
        input = process.getOutputStream();
        output = new AnswerReader(process.getInputStream());
    }

    /**
     * Starts a program.
     *
     * @param name    how people call it
     * @param command the program and its arguments
     * @throws IOException when it could not be started
     */
    public static AttendedProcess start(String name, List<String> command) throws IOException {
        return new AttendedProcess(name,
            new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start());
    }

    /** The number of the process, for whoever wants to attach to it. */
    public long pid() {
        return process.pid();
    }

    /** Completes when the process has ended. */
    public CompletableFuture<?> ended() {
        return process.onExit();
    }

    /** Waits for the process to end; whether it has. */
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

    /** The limit is not heeded. */
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
            // It has ended or closed its input; its output says the rest.
            return;
        } finally {
            queued = new byte[0];
        }
    }

    /** Its output has ended; a program under a debugger may be there still. */
    private String endText() {
        try {
            return awaitEnd(TimeUnit.SECONDS.toMillis(1)) ? FaultMessages.exited(process.exitValue())
                : "closed its output before answering";
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return "closed its output before answering";
        }
    }

    /** It always comes back, or never. */
    @Override
    public void onAbandoned(Consumer<Answer> continuation) {
        // Nobody is abandoned.
    }

    /** Says the last lines and closes its input; it may go on for as long as it likes. */
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

    /** Asks it and all that it has started to end, and kills what has not after the time. */
    public void kill(long graceMs) throws InterruptedException {
        List<ProcessHandle> descendants = process.descendants().toList();
        process.destroy();
        descendants.forEach(ProcessHandle::destroy);
        awaitEnd(graceMs);
        process.destroyForcibly();
        descendants.forEach(ProcessHandle::destroyForcibly);
    }
}

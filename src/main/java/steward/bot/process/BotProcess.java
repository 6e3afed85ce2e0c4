package steward.bot.process;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.AnswerLines;
import steward.bot.Faults;
import steward.bot.LineBuffer;
import steward.bot.Player;
import steward.bot.command.BotCommand;

/**
 * A bot program: reads its frames from its input and writes its answers to its output, line by line.
 *
 * <p>The process starts with the first {@link #ask}. The asking thread itself writes and reads, blocked for as long as
 * it takes; one watchdog for all bots kills the process group at the deadline, which ends the blocked call. A call
 * that has not come back {@value #ABANDON_AFTER_MS} ms after that, because some process outside the group holds the
 * pipe, is abandoned, see {@link Player#onAbandoned}; abandoned threads stay behind, so let daemon threads ask.
 *
 * <p>The bot is its first process: when that has exited, nothing that it left behind is listened to. A bot that
 * closes its input may still answer. After a fault the bot is killed at once.
 *
 * <p>Caveats: processes that leave the group on purpose, and have lost their parents, survive. An answer that is
 * there before it was asked for counts as given at once.
 */
public final class BotProcess implements Player {

    /** The time that a bot has by default to exit by itself at the end, in milliseconds. */
    public static final long DEFAULT_GRACE_MS = 100;

    private static final long ABANDON_AFTER_MS = 100;

    /** How long a process that has closed its output may take to exit, in milliseconds, to be one that exited. */
    private static final long EXIT_MS = 200;

    /** How long the last lines may take to be written, in milliseconds. */
    private static final long FAREWELL_MS = 100;

    private static final String BROKEN_OFF = "asked again after its end";

    /** How much of a faulty answer is shown, in bytes. */
    private static final int SHOWN = 1024;

    private final String name;
    private final List<String> command;
    private final long graceMs;
    private final Alarm alarm = new Alarm();
    private final Deadline deadline = new Deadline(Watchdog.shared(), alarm);
    private volatile Consumer<Answer> continuation;

    private final LineBuffer queued = new LineBuffer();

    private StderrFile stderr;
    private OutputStream input;
    private AnswerLines output;

    /** Set when all of the above are there. */
    private volatile ProcessGroup group;

    /** The question that is being asked: what it may take, from when, how many lines, and whether it was written. */
    private long limit;
    private long clock;
    private int wanted;
    private boolean written;

    /** Says the last lines. */
    private volatile FutureTask<Void> writer;

    private volatile String lastWords;

    /** No more questions. */
    private volatile boolean over;

    /** Another thread is stuck with the streams, which are then its own. */
    private boolean abandoned;

    /**
     * A bot that is started when it is asked for the first time.
     *
     * @param name    how people call it
     * @param command the program and its arguments, as from {@link BotCommand#resolve}
     */
    public BotProcess(String name, List<String> command) {
        this(name, command, DEFAULT_GRACE_MS);
    }

    /**
     * As {@link #BotProcess(String, List)}.
     *
     * @param graceMs how long it may take to exit by itself at the end, in milliseconds, before it is killed
     * @throws IllegalArgumentException when there is no command, or the time is negative
     */
    public BotProcess(String name, List<String> command, long graceMs) {
        if (command.isEmpty()) {
            throw new IllegalArgumentException("player " + name + " has an empty command");
        }
        if (!(graceMs >= 0)) {
            throw new IllegalArgumentException("player " + name + " has a time to exit of " + graceMs + " ms");
        }
        this.name = name;
        this.command = List.copyOf(command);
        this.graceMs = graceMs;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void onAbandoned(Consumer<Answer> next) {
        continuation = next;
    }

    @Override
    public void tell(byte[] lines, int length) {
        queued.write(lines, 0, length);
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        if (over) {
            return fault(answer, BROKEN_OFF);
        }
        boolean first = group == null;
        wanted = answerLines;
        limit = Math.max(1, limitNanos);
        written = false;
        if (first) {
            String problem = start();
            if (problem != null) {
                return fault(answer, problem);
            }
        } else {
            clock = Watchdog.now();
        }
        long asked = clock;
        long due = due();
        deadline.arm(due);
        send(frame, length);
        clock = first ? asked : Watchdog.now();
        written = true;
        long later = due();
        if (deadline.postpone(due, later)) {
            AnswerLines.Outcome outcome = output.await(answerLines);
            return conclude(deadline.complete(later), outcome, answer);
        }
        clock = asked;
        written = false;
        return conclude(false, AnswerLines.Outcome.ENDED, answer);
    }

    /** The call has come back: in time, or because the watchdog has ended it, or after having been abandoned. */
    private Ending conclude(boolean inTime, AnswerLines.Outcome outcome, Answer answer) {
        long waited = Watchdog.now() - clock;
        if (!inTime && !deadline.claim()) {
            output.close();
            closeInput();
            return Ending.ABANDONED;
        }
        boolean cut = !inTime && !alarm.leaderGone;
        if (cut) {
            waited = deadline.passedAt() - clock;
        }
        answer.setNanos(waited);
        if (cut || waited > limit) {
            boolean complete = outcome == AnswerLines.Outcome.COMPLETE;
            return fault(answer, lateText(waited, complete ? wanted : output.come(), output.loose()));
        }
        if (outcome == AnswerLines.Outcome.COMPLETE) {
            output.take(wanted, answer);
            answer.setExtraLines(output.extra());
            answer.setStderr(stderr.collect(false));
            return Ending.ANSWERED;
        }
        return fault(answer, outcome == AnswerLines.Outcome.TOO_LONG
            ? Faults.tooLong(AnswerLines.LINE_LIMIT) : endText());
    }

    private long due() {
        return limit < Long.MAX_VALUE - clock ? clock + limit : Long.MAX_VALUE;
    }

    /** Starts the process, and the clock with it; returns what went wrong, or {@code null}. */
    private String start() {
        Sentinel.shared().start();
        try {
            stderr = StderrFile.create();
        } catch (IOException e) {
            throw new UncheckedIOException("no temporary file for the stderr of " + name + ": " + e.getMessage(), e);
        }
        clock = Watchdog.now();
        ProcessGroup started;
        try {
            started = ProcessGroup.start(command, stderr);
        } catch (IOException e) {
            throw new UncheckedIOException(name + " could not be started: " + e.getMessage(), e);
        } finally {
            stderr.unlink();
        }
        input = started.process().getOutputStream();
        output = new AnswerLines(started.process().getInputStream());
        Watchdog.shared().add(deadline);
        group = started;
        if (over) {
            // Broken off by another thread, which may have come too early to see the process.
            Watchdog.shared().remove(deadline);
            return BROKEN_OFF;
        }
        return null;
    }

    /** Writes what is queued and the frame in one piece. */
    private void send(byte[] frame, int length) {
        byte[] bytes = frame;
        int count = length;
        if (queued.size() > 0) {
            tell(frame, length);
            bytes = queued.bytes();
            count = queued.size();
            queued.reset();
        }
        try {
            input.write(bytes, 0, count);
            input.flush();
        } catch (IOException e) {
            // It has exited or closed its input. What it answered before counts; its output says the rest.
            return;
        }
    }

    private String lateText(long waited, int lines, int loose) {
        return written ? Faults.late(limit, waited, lines, wanted, loose) : Faults.deaf(limit, waited);
    }

    /** Why the output has ended. The exit status may come a little later than the end of the output. */
    private String endText() {
        boolean exited = group.awaitExit(TimeUnit.MILLISECONDS.toNanos(EXIT_MS));
        return exited ? Faults.exited(group.process().exitValue()) : "closed its output before answering";
    }

    private Ending fault(Answer answer, String reason) {
        over = true;
        answer.setFault(reason);
        if (group != null) {
            group.kill();
            output.show(answer, SHOWN);
            answer.setStderr(stderr.collect(true));
        }
        return Ending.FAULT;
    }

    @Override
    public void farewell(byte[] lines, int length) {
        if (!over && group != null && writer == null) {
            startWriter(lines, length);
        }
    }

    /** Another thread says the last lines and closes, since that may block; it stays behind if it does. */
    private void startWriter(byte[] lines, int length) {
        byte[] copy = lines == null ? new byte[0] : Arrays.copyOf(lines, length);
        FutureTask<Void> task = new FutureTask<>(() -> {
            if (copy.length > 0) {
                send(copy, copy.length);
            }
            closeInput();
        }, null);
        try {
            SpareThreads.run(task);
            writer = task;
        } catch (OutOfMemoryError e) {
            // No more threads: it is not told.
            return;
        }
    }

    @Override
    public void finish(byte[] lines, int length) {
        boolean polite = !over;
        over = true;
        if (group != null) {
            if (polite && writer == null) {
                startWriter(lines, length);
            }
            boolean closing = polite && writer != null;
            if (closing) {
                awaitExit();
            }
            group.kill();
            Watchdog.shared().remove(deadline);
            if (!abandoned) {
                output.close();
            }
            if (!abandoned && !closing) {
                closeInput();
            }
        }
        if (stderr != null) {
            lastWords = polite ? stderr.collect(true) : lastWords;
            stderr.close();
        }
    }

    @Override
    public String lastWords() {
        return lastWords;
    }

    /** Waits until the last lines are written and the process has exited, for as long as either may take. */
    private void awaitExit() {
        try {
            writer.get(FAREWELL_MS, TimeUnit.MILLISECONDS);
            group.process().waitFor(graceMs, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (TimeoutException | ExecutionException e) {
            // It does not read, or there is no memory left to write with: it is killed without having been told.
            return;
        }
    }

    /** What happens at and before the deadline, on other threads than the asking one. */
    private final class Alarm implements Deadline.Owner {

        /** Written by the watchdog before it decides. */
        private boolean leaderGone;
        private long goneSince;

        /** Kills the group, which ends the blocked call of the asking thread; failing that, abandons that thread. */
        @Override
        public void expired() {
            group.kill();
            long giveUp = Watchdog.now() + TimeUnit.MILLISECONDS.toNanos(ABANDON_AFTER_MS);
            while (deadline.isExpired() && Watchdog.now() < giveUp) {
                LockSupport.parkNanos(1_000_000);
            }
            Consumer<Answer> next = continuation;
            if (next != null && deadline.abandon()) {
                next.accept(abandon());
            }
        }

        /**
         * Bounds the stderr of a thinking bot, and gives up a bot that has exited while something it left behind
         * keeps its output open: for one tick more, so that an answer on its way is read.
         */
        @Override
        public boolean tick(long now) {
            stderr.bound();
            if (goneSince == 0 && !group.process().isAlive()) {
                goneSince = now;
            }
            leaderGone = goneSince > 0 && now - goneSince >= Watchdog.TICK;
            return leaderGone;
        }
    }

    private Answer abandon() {
        over = true;
        abandoned = true;
        Answer answer = new Answer();
        long waited = Watchdog.now() - clock;
        answer.setNanos(waited);
        answer.setFault(alarm.leaderGone ? endText() : lateText(waited, output.come(), 0));
        answer.setStderr(stderr.collect(true));
        return answer;
    }

    private void closeInput() {
        try {
            input.close();
        } catch (IOException e) {
            // Nobody reads it any more.
            return;
        }
    }
}

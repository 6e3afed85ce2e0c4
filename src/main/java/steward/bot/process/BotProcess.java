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
import steward.bot.AnswerReader;
import steward.bot.Burner;
import steward.bot.FaultMessages;
import steward.bot.LineBuffer;
import steward.bot.Player;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.bot.accounting.OwnThread;
import steward.bot.accounting.TreeSample;
import steward.bot.accounting.TreeSampler;
import steward.bot.command.BotCommand;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.Launch;
import steward.bot.isolation.ProcessTree;
import steward.bot.isolation.SandboxLevel;

/**
 * Player that is a bot program: sends frames to its input and reads answers from its output, line by line.
 *
 * <p>The process starts with the first {@link #ask}. The asking thread itself writes and reads with blocking calls; one
 * watchdog for all bots kills the process group at the deadline, which ends the blocked call. If a call has not
 * returned {@value #ABANDON_AFTER_MS} ms later, because a process outside the group holds the pipe, it is abandoned
 * (see {@link Player#onAbandoned}). An abandoned thread stays behind, so call {@code ask} on daemon threads.
 *
 * <p>The bot is its first process: when that has exited, output of its remaining descendants is ignored. A bot that
 * closes its input may still answer. After a fault the bot is killed at once.
 *
 * <p>Caveats: without a sandbox, processes survive that leave the group on purpose and whose parents have exited. An
 * answer that was written before the question counts as given at once. The file is long because both sides of the race
 * between answer and deadline are in it and read the same fields.
 */
public final class BotProcess implements Player {

    /** How long a bot may take by default to exit by itself at the end, in milliseconds. */
    public static final long DEFAULT_GRACE_MS = 100;

    private static final long ABANDON_AFTER_MS = 100;

    /**
     * How long a process may take to exit after closing its output, in milliseconds, to be reported as exited. In a
     * sandbox the status passes two more processes, each of which may have to wait for a processor.
     */
    private static final long EXIT_MS = 1000;

    /** How long the last lines may take to be written, in milliseconds. */
    private static final long LAST_LINES_MS = 100;

    private static final String BROKEN_OFF = "asked again after its end";

    /** Bytes of a faulty answer that are shown. */
    private static final int SHOWN = 1024;

    private final String name;
    private final Launch launch;
    private final long graceMs;
    private final Alarm alarm = new Alarm();
    private final OwnThread asking = new OwnThread();
    private final QuestionClock clock = new QuestionClock(asking::state, at -> this.tree.sample(at));
    private final Deadline deadline = new Deadline(Watchdog.shared(), alarm);
    private volatile Consumer<Answer> continuation;
    private final LineBuffer queued = new LineBuffer();
    private StderrFile stderr;
    private OutputStream input;
    private AnswerReader output;
    private TreeSampler tree;
    /** {@code null} for a bot that is never held. */
    private volatile BotHold hold;

    /** Set last: once it is there, so are the four fields above. */
    private volatile ProcessGroup group;

    /** How many lines the current question wants. */
    private int wanted;

    /** Writes the last lines. */
    private volatile FutureTask<Void> writer;
    private volatile String finalStderr;

    /** No more questions may be asked. */
    private volatile boolean over;

    /** Another thread is blocked in the streams and then owns them. */
    private boolean abandoned;

    /**
     * A bot whose process is started by the first {@link #ask}, without a sandbox.
     *
     * @param name    its name in messages
     * @param command the program and its arguments, as from {@link BotCommand#resolve}
     */
    public BotProcess(String name, List<String> command) {
        this(name, command, DEFAULT_GRACE_MS);
    }

    /** As {@link #BotProcess(String, Launch, long)}, without a sandbox. */
    public BotProcess(String name, List<String> command, long graceMs) {
        this(name, Launch.plain(command), graceMs);
    }

    /**
     * A bot whose process is started by the first {@link #ask}, as the launch says.
     *
     * @param graceMs how long the process may take to exit by itself at the end, in milliseconds, before it is killed
     * @throws IllegalArgumentException when there is no command, or the time is negative
     */
    public BotProcess(String name, Launch launch, long graceMs) {
        if (launch.program().words().isEmpty()) {
            throw new IllegalArgumentException("player " + name + " has an empty command");
        }
        if (!(graceMs >= 0)) {
            throw new IllegalArgumentException("player " + name + " has a time to exit of " + graceMs + " ms");
        }
        this.name = name;
        this.launch = launch;
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
    public void limitBy(TimeBasis basis) {
        clock.limitBy(basis);
    }

    @Override
    public void strikeAfter(long nanos) {
        clock.strikeAfter(nanos);
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
        wanted = answerLines;
        asking.enter();
        long limit = Math.max(1, limitNanos);
        if (group == null) {
            String problem = start(limit, answer);
            if (problem != null) {
                return fault(answer, problem);
            }
        } else {
            resume();
            if (group.fault() != null) {
                return fault(answer, group.fault());
            }
            long now = Watchdog.now();
            clock.begin(limit, now, clock.needsBaseline() ? tree.baseline(now) : null);
        }
        deadline.arm(clock.started(), clock.firstLook());
        send(frame, length);
        if (!deadline.isPending()) {
            return conclude(false, AnswerReader.Outcome.ENDED, answer);
        }
        clock.frameWritten(Watchdog.now());
        AnswerReader.Outcome outcome = output.await(answerLines);
        return conclude(deadline.complete(), outcome, answer);
    }

    /** Ends a call that has returned in time, or because the watchdog ended it, or after having been abandoned. */
    private Ending conclude(boolean inTime, AnswerReader.Outcome outcome, Answer answer) {
        long now = Watchdog.now();
        if (!inTime && !deadline.claim()) {
            output.close();
            closeInput();
            return Ending.ABANDONED;
        }
        boolean complete = outcome == AnswerReader.Outcome.COMPLETE;
        long charge = complete && inTime ? clock.charge(now) : clock.passed(now);
        boolean late = inTime ? charge < 0 : !alarm.leaderGone;
        answer.setNanos(late ? clock.taken() : charge);
        if (late) {
            return fault(answer, lateText(answer, complete ? wanted : output.linesReceived(), output.partialBytes()));
        }
        if (complete) {
            output.take(wanted, answer);
            answer.setExtraLines(output.extraLines());
            answer.setStderr(stderr.collect(false));
            answer.setTimeSpent(clock.strike(now, charge));
            if (hold != null) {
                hold.answered(now);
                answer.setHeld(hold.held());
            }
            return Ending.ANSWERED;
        }
        return fault(answer, outcome == AnswerReader.Outcome.TOO_LONG
            ? FaultMessages.tooLong(AnswerReader.LINE_LIMIT) : endText());
    }

    /** The processes of the bot as this machine numbers them, see {@link ProcessTree}; none before it is started. */
    List<Long> processes() {
        return group == null ? List.of() : group.processes();
    }

    /** Starts the process and the clock; returns the problem, or {@code null}. */
    private String start(long limit, Answer answer) {
        Sentinel.shared().start();
        try {
            stderr = StderrFile.create();
        } catch (IOException e) {
            throw new UncheckedIOException("no temporary file for the stderr of " + name + ": " + e.getMessage(), e);
        }
        long now = Watchdog.now();
        clock.begin(limit, now, TreeSample.beforeStart(now, TreeSampler.idle()));
        ProcessGroup started;
        try {
            started = ProcessGroup.start(launch, stderr);
        } catch (IOException e) {
            return unstarted(e, answer);
        } finally {
            stderr.unlink();
        }
        input = started.process().getOutputStream();
        output = new AnswerReader(started.process().getInputStream());
        tree = new TreeSampler(started.process().pid()).keepingFiles(clock.needsBaseline());
        Watchdog.shared().add(deadline);
        HoldPolicy policy = launch.isolation().holds();
        if (policy != HoldPolicy.NEVER && limit < Long.MAX_VALUE) {
            hold = new BotHold(policy, started, new TreeSampler(started.process().pid()), now);
        }
        group = started;
        if (over) {
            // Broken off by another thread, perhaps before the process was visible to it.
            endWatch();
            return BROKEN_OFF;
        }
        return null;
    }

    /**
     * Describes the system's refusal to start a program. Where bots have sessions of their own, {@code setsid} is what
     * starts, and then fails in these very words: the verdict does not depend on it.
     *
     * @throws UncheckedIOException if it is not the program that is refused
     */
    private String unstarted(IOException problem, Answer answer) {
        String message = String.valueOf(problem.getMessage());
        StartRefusal refusal = StartRefusal.of(message);
        if (refusal.status() == 0) {
            throw new UncheckedIOException(name + " could not be started: " + message, problem);
        }
        answer.setStderr("failed to execute " + launch.program().words().get(0) + refusal.reason());
        return FaultMessages.exited(refusal.status());
    }

    /** Writes the queued lines and the frame in one piece. */
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
            // The bot has exited or closed its input. An earlier answer counts; reading the output shows which.
            return;
        }
    }

    /** The fault after a missed deadline; the processes need not be alive if it was the watchdog that found it. */
    private String lateText(Answer answer, int lines, int partialBytes) {
        TimeSpent spent = clock.spent(Watchdog.now(), answer.nanos());
        answer.setTimeSpent(spent);
        return FaultMessages.missed(spent, clock.basis(), clock.unread(), lines, wanted, partialBytes);
    }

    /** The fault after the end of the output. The exit status may be known a little later than that. */
    private String endText() {
        boolean exited = group.awaitExit(TimeUnit.MILLISECONDS.toNanos(EXIT_MS));
        return group.fault() != null ? group.fault()
            : exited ? FaultMessages.exited(group.process().exitValue()) : "closed its output before answering";
    }

    private Ending fault(Answer answer, String reason) {
        over = true;
        answer.setFault(reason);
        if (group != null) {
            kill();
            output.show(answer, SHOWN);
            answer.setStderr(stderr.collect(true));
        }
        return Ending.FAULT;
    }

    /** Kills the bot, and of what has left its group whatever could go on filling the file for stderr. */
    private void kill() {
        group.kill();
        if (launch.isolation().level() == SandboxLevel.OFF) {
            StderrHolders.kill(stderr.file().toPath(), group.process().pid());
        }
    }

    @Override
    public void sendLastLines(byte[] lines, int length) {
        if (!over && group != null && writer == null) {
            resume();
            startWriter(lines, length);
        }
    }

    private void resume() {
        if (hold != null) {
            hold.asking();
        }
    }

    private void endWatch() {
        Watchdog.shared().remove(deadline);
        tree.close();
        if (hold != null) {
            hold.end();
        }
    }

    @Override
    public Burner burner(long sinceNanos) {
        BotHold watched = hold;
        return watched == null ? null : watched.burner(Watchdog.now() - sinceNanos);
    }

    /**
     * Sends the last lines and closes the input on another thread, because both may block; a blocked thread is left
     * behind.
     */
    private void startWriter(byte[] lines, int length) {
        byte[] copy = lines == null ? new byte[0] : Arrays.copyOf(lines, length);
        FutureTask<Void> task = new FutureTask<>(() -> {
            if (copy.length > 0) {
                send(copy, copy.length);
            }
            closeInput();
        }, null);
        try {
            DaemonThreadPool.run(task);
            writer = task;
        } catch (OutOfMemoryError e) {
            // No more threads: the last lines are not sent.
            return;
        }
    }

    @Override
    public void finish(byte[] lines, int length) {
        boolean polite = !over;
        over = true;
        if (group != null) {
            if (polite && writer == null) {
                resume();
                startWriter(lines, length);
            }
            boolean closing = polite && writer != null;
            if (closing) {
                awaitExit();
            }
            kill();
            endWatch();
            if (!abandoned) {
                output.close();
            }
            if (!abandoned && !closing) {
                closeInput();
            }
        }
        if (stderr != null) {
            finalStderr = polite ? stderr.collect(true) : finalStderr;
            stderr.close();
        }
    }

    @Override
    public String finalStderr() {
        return finalStderr;
    }

    /** Waits until the last lines are written and the process has exited, each within its time limit. */
    private void awaitExit() {
        try {
            writer.get(LAST_LINES_MS, TimeUnit.MILLISECONDS);
            group.process().waitFor(graceMs, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (TimeoutException | ExecutionException e) {
            // The bot does not read, or no memory is left to write: it is killed without its last lines.
            return;
        }
    }

    /** The watchdog's side: what happens before and at the deadline, on other threads than the asking one. */
    private final class Alarm implements Deadline.Owner {

        /** Written by the watchdog before it decides. */
        private boolean leaderGone;
        private long goneSince;

        /** Kills the group, which ends the blocked call of the asking thread; if that fails, abandons that thread. */
        @Override
        public void expired() {
            if (!leaderGone) {
                clock.spent(Watchdog.now(), clock.taken());
            }
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
         * Bounds the stderr of a computing bot. Ends the wait for a bot that has exited while a remaining descendant
         * keeps its output open, one tick later, so that an answer already in the pipe is read.
         */
        @Override
        public long look(long now, long overslept) {
            stderr.bound();
            if (goneSince == 0 && !group.process().isAlive()) {
                goneSince = now;
            }
            leaderGone = goneSince > 0 && now - goneSince >= Watchdog.TICK;
            return leaderGone ? QuestionClock.PASSED : clock.look(now, overslept);
        }
    }

    private Answer abandon() {
        over = true;
        abandoned = true;
        Answer answer = new Answer();
        answer.setNanos(alarm.leaderGone ? clock.passed(Watchdog.now()) : clock.taken());
        answer.setFault(alarm.leaderGone ? endText() : lateText(answer, output.linesReceived(), 0));
        answer.setStderr(stderr.collect(true));
        return answer;
    }

    private void closeInput() {
        try {
            input.close();
        } catch (IOException e) {
            // The input has no reader any more.
            return;
        }
    }
}

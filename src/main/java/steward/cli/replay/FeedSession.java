package steward.cli.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.util.concurrent.CompletableFuture;
import steward.bot.command.BotCommand;
import steward.bot.command.CommandLine;
import steward.bot.command.Program;
import steward.bot.process.AttendedProcess;
import steward.bot.process.Debugger;
import steward.cli.shared.FailedException;
import steward.cli.streams.Colour;
import steward.cli.streams.EnterKey;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameTypes;
import steward.match.Protocol;
import steward.replay.RecordedMatch;
import steward.replay.feed.Feed;
import steward.replay.feed.Takeover;
import steward.replay.page.UnclosedOutputStream;
import steward.text.TextFormat;

/**
 * Session of {@code steward feed}: a recorded match, one player of it, and a bot that is sent that player's lines.
 *
 * @param bot      as it was called
 * @param program  what is started, and where
 * @param pause    the turn before which the session waits for Enter, or {@code null}
 * @param quiet    whether turns that are the same are passed over
 * @param json     whether nothing but one JSON object is printed to the standard output
 * @param piped    whether the standard output is the new replay
 */
record FeedSession(Streams streams, GameTypes types, RecordedMatch match, int player, BotCommand bot, Protocol protocol,
                   Program program, Integer pause, boolean quiet, boolean json, boolean piped) {

    /** How long a bot may take to end by itself, without a debugger or a pause, in milliseconds. */
    private static final long GRACE_MS = 1000;
    private static final long KILL_MS = 500;

    /** Work with a bot once it runs; returns the outcome if it played on, or {@code null}. */
    private interface Work {
        Takeover.Outcome with(AttendedProcess process, FeedReport report, WaitingNotice waiting)
            throws InterruptedException;
    }

    /** Returns where readable text goes. */
    PrintStream text() {
        return json || piped ? streams.err() : streams.out();
    }

    Colour colour() {
        return json || piped ? streams.errColour() : streams.outColour();
    }

    /** As it was called, since a bundled bot's words are a long line of a JVM. */
    private String called() {
        return bot.prefix() == BotCommand.Prefix.BUILTIN ? bot.toString() : CommandLine.quote(program.words());
    }

    /** Sends the turns to the last or the given one, and compares. */
    int compare(int until) throws InterruptedException {
        return start(null, (process, report, waiting) -> {
            Feed feed = new Feed(match, types, player, protocol, process);
            Feed.Ending ending = feed.run(until, turn -> before(turn, process, waiting), turn -> {
                waiting.answered();
                report.add(turn);
            });
            if (ending == Feed.Ending.STOPPED) {
                report.end(null, null);
                hold(until, process);
            }
            return null;
        });
    }

    /**
     * Lets the bot play on, and records that.
     *
     * @param file as it was typed
     */
    int replace(int from, String file, boolean overwrite) throws InterruptedException {
        try (OutputStream out = piped ? new UnclosedOutputStream(streams.out())
                : OutputFiles.open(OutputFiles.path(file), overwrite)) {
            return start(file, (process, report, waiting) -> {
                Takeover takeover = new Takeover(match, types, player, protocol, process, from, bot.toString(), out);
                return takeover.run(turn -> before(turn, process, waiting), turn -> {
                    waiting.answered();
                    report.add(turn);
                });
            });
        } catch (UncheckedIOException problem) {
            throw new FailedException(file + ": " + problem.getMessage());
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be closed: " + problem.getMessage());
        }
    }

    /**
     * Starts the bot and works with it; the verdict is the last word, behind all that the bot says.
     *
     * @param file of the new replay as it was typed, or {@code null}
     */
    private int start(String file, Work work) throws InterruptedException {
        boolean debugger = Debugger.is(program.words());
        AttendedProcess process;
        try {
            process = AttendedProcess.start(bot.displayName(program.folder()), debugger
                ? program.started(Debugger.onTerminal(program.words())) : program,
                debugger || pause != null ? null : streams.err());
        } catch (IOException problem) {
            throw new InputException("the bot could not be started: " + problem.getMessage());
        }
        Thread last = new Thread(() -> end(process), "feed-end");
        streams.hooks().add(last);
        PrintStream terminal = debugger ? null : streams.errTerminal() ? streams.err()
            : streams.outTerminal() ? streams.out() : null;
        WaitingNotice waiting = new WaitingNotice(terminal, protocol.word(), WaitingNotice.AFTER_MS);
        try {
            if (!json || pause != null) {
                text().println(TextFormat.plain("process " + process.pid() + " is player " + player + " of "
                    + match.source() + ", speaks " + protocol.word() + ": " + called()));
                text().flush();
            }
            FeedReport report = new FeedReport(this);
            Takeover.Outcome outcome = work.with(process, report, waiting);
            text().flush();
            process.close();
            if (debugger || pause != null) {
                process.ended().join();
            } else if (process.awaitEnd(GRACE_MS)) {
                process.showRest();
            }
            end(process);
            report.end(outcome, file);
            text().flush();
            return report.status();
        } finally {
            waiting.answered();
            end(process);
            streams.hooks().remove(last);
        }
    }

    private static void end(AttendedProcess bot) {
        try {
            bot.kill(KILL_MS);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void before(int turn, AttendedProcess process, WaitingNotice waiting) {
        if (pause != null && pause == turn) {
            text().println("waiting before turn " + turn + ": attach to process " + process.pid()
                + ", then press Enter");
            text().flush();
            CompletableFuture.anyOf(EnterKey.pressed(streams), process.ended()).join();
        }
        waiting.asked(turn);
    }

    private void hold(int until, AttendedProcess process) {
        boolean debugger = Debugger.is(program.words());
        text().println("stopped after turn " + until + "; process " + process.pid() + " waits for more until "
            + (debugger ? "the debugger ends" : "it ends or you press Enter"));
        text().flush();
        if (debugger) {
            process.ended().join();
        } else {
            CompletableFuture.anyOf(EnterKey.pressed(streams), process.ended()).join();
        }
    }
}

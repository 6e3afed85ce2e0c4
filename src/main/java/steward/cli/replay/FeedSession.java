package steward.cli.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import steward.bot.command.CommandLine;
import steward.bot.process.AttendedProcess;
import steward.bot.process.Debugger;
import steward.cli.shared.EnterKey;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.match.Protocol;
import steward.replay.RecordedMatch;
import steward.replay.feed.Feed;
import steward.replay.feed.Takeover;
import steward.text.TextFormat;

/**
 * A recorded match, a player of it, and a bot that is started to be sent what that player was sent.
 *
 * @param words the program and its arguments
 * @param pause the turn before which is waited for Enter, or {@code null}
 */
record FeedSession(Streams streams, RecordedMatch match, int player, Protocol protocol, List<String> words,
    boolean quiet,
               Integer pause) {

    /** How long the bot may take to end by itself, where nobody is looking into it. */
    private static final long GRACE_MS = 1000;
    private static final long KILL_MS = 500;

    /** What is done with a bot once it runs; gives the exit status. */
    private interface Work {
        int with(AttendedProcess bot, FeedReport report) throws InterruptedException;
    }

    /** Sends the turns to the last or the given one, and compares. */
    int compare(int until) throws InterruptedException {
        return start((bot, report) -> {
            Feed feed = new Feed(match, Games.types(), player, protocol, bot);
            Feed.Ending ending = feed.run(until, turn -> pauseBefore(turn, bot), report::add);
            report.sum();
            if (ending == Feed.Ending.STOPPED) {
                hold(until, bot);
            }
            return report.status();
        });
    }

    /** Lets the bot play on, and records that. */
    int replace(int from, Path file, boolean overwrite) throws InterruptedException {
        try (OutputStream out = OutputFiles.open(file, overwrite)) {
            return start((bot, report) -> {
                Takeover takeover = new Takeover(match, Games.types(), player, protocol, bot, from,
                    CommandLine.quote(words), out);
                Takeover.Outcome outcome = takeover.run(turn -> pauseBefore(turn, bot), report::add);
                report.sum();
                report.outcome(outcome, file);
                return report.status();
            });
        } catch (UncheckedIOException problem) {
            throw new FailedException(file + ": " + problem.getMessage());
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be closed: " + problem.getMessage());
        }
    }

    private int start(Work work) throws InterruptedException {
        boolean debugger = Debugger.is(words);
        AttendedProcess bot;
        try {
            bot = AttendedProcess.start(match.header().names().get(player),
                debugger ? Debugger.onTerminal(words) : words);
        } catch (IOException problem) {
            throw new InputException("the bot could not be started: " + problem.getMessage());
        }
        Thread last = new Thread(() -> end(bot), "feed-end");
        Runtime.getRuntime().addShutdownHook(last);
        try {
            streams.out().println(TextFormat.plain("process " + bot.pid() + " is player " + player + " of "
                + match.source()
                + ", speaks " + protocol.word() + ": " + CommandLine.quote(words)));
            streams.out().flush();
            int status = work.with(bot, new FeedReport(streams, match, quiet));
            streams.out().flush();
            bot.close();
            if (debugger || pause != null) {
                bot.ended().join();
            } else {
                bot.awaitEnd(GRACE_MS);
            }
            return status;
        } finally {
            end(bot);
            removeHook(last);
        }
    }

    private static void removeHook(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException shutdown) {
            // It runs already, or has run.
            return;
        }
    }

    private static void end(AttendedProcess bot) {
        try {
            bot.kill(KILL_MS);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void pauseBefore(int turn, AttendedProcess bot) {
        if (pause != null && pause == turn) {
            streams.out().println("waiting before turn " + turn + ": attach to process " + bot.pid()
                + ", then press Enter");
            streams.out().flush();
            CompletableFuture.anyOf(EnterKey.pressed(streams), bot.ended()).join();
        }
    }

    private void hold(int until, AttendedProcess bot) {
        boolean debugger = Debugger.is(words);
        streams.out().println("stopped after turn " + until + "; process " + bot.pid() + " waits for more until "
            + (debugger ? "the debugger ends" : "it ends or you press Enter"));
        streams.out().flush();
        if (debugger) {
            bot.ended().join();
        } else {
            CompletableFuture.anyOf(EnterKey.pressed(streams), bot.ended()).join();
        }
    }

    /** Names of players for a sentence. */
    static String names(RecordedMatch match, List<Integer> players) {
        return players.stream().map(match.header().names()::get).collect(Collectors.joining(", "));
    }
}

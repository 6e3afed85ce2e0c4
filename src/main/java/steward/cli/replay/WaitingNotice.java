package steward.cli.replay;

import java.io.PrintStream;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** Notice of the answer that the program is waiting for, printed once a turn after some time. */
final class WaitingNotice {

    /** Answers come within milliseconds; a person begins to wonder after some seconds. */
    static final long AFTER_MS = 2000;

    private final PrintStream terminal;
    private final String language;
    private final long afterMs;
    private CompletableFuture<Void> due;

    /**
     * @param terminal where it is printed, or {@code null} for nowhere
     * @param language what the bot is sent, in words
     */
    WaitingNotice(PrintStream terminal, String language, long afterMs) {
        this.terminal = terminal;
        this.language = language;
        this.afterMs = afterMs;
    }

    /** A bot is about to be asked. */
    void asked(int turn) {
        if (terminal != null) {
            due = CompletableFuture.runAsync(() -> {
                terminal.println("waiting for the bot's answer to turn " + turn + " (it is sent " + language + ")");
                terminal.flush();
            }, CompletableFuture.delayedExecutor(afterMs, TimeUnit.MILLISECONDS));
        }
    }

    /** It has answered, or never will. */
    void answered() {
        if (due != null) {
            due.cancel(false);
        }
    }
}

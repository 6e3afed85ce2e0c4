package steward.bot.isolation;

import java.util.Locale;

/**
 * Level of isolation of a bot from this machine and from other bots. It is a property of the machine on which a match
 * is played, never of the game: verdicts and exit statuses are the same at every level.
 */
public enum SandboxLevel {

    /** A session and process group of its own, no more. */
    OFF,
    /** Also user, PID, mount, network, IPC and UTS namespaces of its own, without capabilities. */
    LIGHT,
    /** Also a file system that is read-only and shows little of the home directory, and limits. */
    STRICT;

    /** Returns the word as it is written in options, results and replays. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}

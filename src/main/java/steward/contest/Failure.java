package steward.contest;

import java.util.List;
import java.util.regex.Pattern;
import steward.Internal;
import steward.bot.Burner;
import steward.bot.ErrorLine;
import steward.bot.FaultMessages;
import steward.bot.TimeSpent;

/**
 * Failure of a bot in one game: a crash, a missed deadline or an invalid answer.
 *
 * @param player its place in the game
 * @param turn   in which it failed, counted from 1
 * @param reason what was found and what was expected, as the referee says it
 * @param stderr the last lines it wrote there, in this turn or before, oldest first; if {@code error} is not among
 *               them, it and the lines that follow it
 * @param error  the line of its stderr that says why, see {@link ErrorLine}; if none has a known form the last one of
 *               a bot that exited; otherwise empty
 * @param hints  what the reason may be, each a short sentence without its full stop
 * @param time   where the time of a late answer went, or {@code null}
 * @param burner a bot that burned meanwhile and was not yet held, or {@code null}
 */
public record Failure(int player, int turn, String reason, List<String> stderr, String error, List<String> hints,
                      TimeSpent time, @Internal Burner burner) {

    /** How many lines of stderr are kept at most. */
    public static final int LINES = 10;

    static final String RECEIVED = "; received: ";
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?(E-?\\d+)?");

    /** Copies the lists. */
    @Internal
    public Failure {
        stderr = List.copyOf(stderr);
        hints = List.copyOf(hints);
    }

    /** One that is not of time. */
    public Failure(int player, int turn, String reason, List<String> stderr, List<String> hints) {
        this(player, turn, reason, stderr, "", hints, null, null);
    }

    /** Returns this failure without lines and hints, to save memory. */
    Failure brief() {
        return new Failure(player, turn, reason, List.of(), "", List.of(), time, burner);
    }

    /** True if it was late while other programs used the processors, see {@link TimeSpent#starved}. */
    public boolean starved() {
        return time != null && time.starved();
    }

    /** True if it may have been late only since other programs used the processors, see {@link TimeSpent#doubtful}. */
    public boolean doubtful() {
        return time != null && time.doubtful();
    }

    /**
     * Returns the common part of failures for the same reason: the reason without what was received, and with {@code #}
     * for each number. The status of an exit and the limit of an answer stay.
     */
    public String kind() {
        return kind(reason);
    }

    /** The {@link #kind()} of failures for this reason. */
    public static String kind(String reason) {
        int received = reason.indexOf(RECEIVED);
        String text = FaultMessages.withoutTimes(received < 0 ? reason : reason.substring(0, received));
        return FaultMessages.isExit(reason) || FaultMessages.isLate(reason) ? text
            : NUMBER.matcher(text).replaceAll("#");
    }
}

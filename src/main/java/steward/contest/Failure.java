package steward.contest;

import java.util.List;
import java.util.regex.Pattern;
import steward.bot.FaultMessages;

/**
 * How a bot failed as a program in one game.
 *
 * @param player its place in the game
 * @param turn   in which it failed, counted from 1
 * @param reason what was found and what was expected, as the referee says it
 * @param stderr the last lines it wrote there, in this turn or before, oldest first
 * @param hints  what the reason may be, each a short sentence without its full stop
 */
public record Failure(int player, int turn, String reason, List<String> stderr, List<String> hints) {

    /** How many lines of stderr are kept at most. */
    public static final int LINES = 10;

    private static final String RECEIVED = "; received: ";
    private static final Pattern WAITED = Pattern.compile(" \\(waited [^)]*\\)");
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?(E-?\\d+)?");

    /** Copies the lists. */
    public Failure {
        stderr = List.copyOf(stderr);
        hints = List.copyOf(hints);
    }

    /** The same without lines and hints, to save memory. */
    Failure brief() {
        return new Failure(player, turn, reason, List.of(), List.of());
    }

    /**
     * What failures for the same reason have in common: the reason without what was received, and with {@code #} for
     * each number. The status of an exit and the limit of an answer stay.
     */
    public String kind() {
        int received = reason.indexOf(RECEIVED);
        String text = WAITED.matcher(received < 0 ? reason : reason.substring(0, received)).replaceAll("");
        return FaultMessages.isExit(reason) || FaultMessages.isLate(reason) ? text
            : NUMBER.matcher(text).replaceAll("#");
    }
}

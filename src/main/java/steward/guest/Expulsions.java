package steward.guest;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.text.TextFormat;

/**
 * Detector of players whom a referee has thrown out of the game. The referee writes a line of the block SUMMARY in the
 * SDK's form for errors, red and with the player in it. Then it either asks others twice without this player or gives
 * it the score -1. A negative score alone proves nothing: games have such scores.
 *
 * <p>From version 4.7.2 on the SDK counts times: it allows {@value #STRIKE_EXTRA_MS} ms beyond the contest's limit, but
 * at the third answer that needs them the player is out.
 */
final class Expulsions {

    /** Milliseconds of a limit beyond that of the contest. */
    static final int STRIKE_EXTRA_MS = 50;
    /** Late answers of which the last one puts a player out. */
    private static final int STRIKES = 3;
    private static final double THROWN_OUT = -1;
    /** Answers that others give after the last one of a player who takes no more part. */
    private static final int OTHERS = 2;
    private static final int LONGEST = 300;
    /** A line in red; the first player that it names is the one who was wrong. */
    private static final Pattern ERROR =
        Pattern.compile("\u00a4RED\u00a4[^$\u00a7]*\\$(\\d)(?!\\d).*\u00a7RED\u00a7");
    static final Pattern COLOUR = Pattern.compile("[\u00a4\u00a7][A-Za-z_]+[\u00a4\u00a7]");

    /** Lines since the last answer of each player. */
    private final List<List<String>> errors = new ArrayList<>();
    private final List<List<String>> late = new ArrayList<>();
    private final String[] struckOut;
    /** Answers of others since the last one of each player: the most that one of them has given. */
    private final int[][] since;

    Expulsions(int players) {
        for (int player = 0; player < players; player++) {
            errors.add(new ArrayList<>());
            late.add(new ArrayList<>());
        }
        struckOut = new String[players];
        since = new int[players][players];
    }

    /**
     * Counts an answer.
     *
     * @param ms       that it took, as the referee is told
     * @param strikeMs after which it is late; 0 where times do not count
     */
    void answered(int player, long ms, int strikeMs) {
        errors.get(player).clear();
        Arrays.fill(since[player], 0);
        for (int[] others : since) {
            others[player]++;
        }
        since[player][player] = 0;
        struckOut[player] = null;
        if (strikeMs > 0 && ms > strikeMs) {
            late.get(player).add(Long.toString(ms));
            struckOut[player] = late.get(player).size() < STRIKES ? null : "late " + STRIKES + " times, after "
                + String.join(", ", late.get(player)) + " ms, expected answers within " + strikeMs + " ms";
        }
    }

    /** Records the errors in lines of a summary. Many say what was wrong in the line before, and name nobody in it. */
    void said(List<String> lines) {
        String before = null;
        for (String line : lines) {
            Matcher error = ERROR.matcher(line.strip());
            int player = error.matches() ? Integer.parseInt(error.group(1)) : since.length;
            if (player < since.length) {
                if (before != null && !COLOUR.matcher(before).find() && before.indexOf('$') < 0) {
                    errors.get(player).add(before);
                }
                errors.get(player).add(line);
            }
            before = line;
        }
    }

    /** Returns why a player was thrown out by the end of the game, or {@code null}. */
    String of(int player, double score) {
        if (struckOut[player] != null) {
            return struckOut[player];
        }
        boolean without = Arrays.stream(since[player]).anyMatch(answers -> answers >= OTHERS);
        if (errors.get(player).isEmpty() || !without && score != THROWN_OUT) {
            return null;
        }
        String name = "$" + player;
        return TextFormat.beginning(errors.get(player).stream().map(line -> COLOUR.matcher(line).replaceAll("").strip())
            .map(line -> line.startsWith(name) ? line.substring(name.length()).replaceFirst("^[\\s:,]+", "")
                : line.replace(name, "player " + player))
            .filter(line -> !line.isEmpty()).collect(Collectors.joining("; ")), LONGEST);
    }
}

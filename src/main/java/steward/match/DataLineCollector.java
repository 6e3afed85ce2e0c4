package steward.match;

import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * Collector of the data lines that bots write to stderr for rating tools. {@code [TDATA] key = value} is about the
 * match; {@code [PDATA] key = value} is about the player, and the last value counts; {@code [PDATA+] key = value} is
 * summed up. Other lines are skipped, and so is text beyond {@value #MOST} characters in all. A line that is incomplete
 * when a turn ends is completed in the next turn.
 */
final class DataLineCollector {

    private static final String MATCH = "[TDATA]";
    private static final String PLAYER = "[PDATA]";
    private static final String PLAYER_SUM = "[PDATA+]";
    /** Characters of an incomplete line that are kept. */
    private static final int LONGEST = 1000;
    /** Characters that are kept of reports about a player, or about the match. */
    private static final int MOST = 1 << 14;

    private final Map<String, String> match = new TreeMap<>();
    private final Map<String, String>[] players;
    private final String[] begun;

    @SuppressWarnings({"unchecked", "rawtypes"})
    DataLineCollector(int count) {
        players = new Map[count];
        for (int player = 0; player < count; player++) {
            players[player] = new TreeMap<>();
        }
        begun = new String[count];
        Arrays.fill(begun, "");
    }

    /** Reads what a player wrote to stderr. */
    void read(int player, String stderr) {
        if (stderr == null) {
            return;
        }
        int end = stderr.lastIndexOf('\n') + 1;
        String lines = end == 0 ? "" : begun[player] + stderr.substring(0, end);
        String rest = end == 0 ? begun[player] + stderr : stderr.substring(end);
        begun[player] = rest.substring(0, Math.min(LONGEST, rest.length()));
        readLines(player, lines);
    }

    private void readLines(int player, String lines) {
        if (lines.indexOf("DATA") < 0) {
            return;
        }
        for (String line : lines.split("\\R")) {
            if (line.startsWith(MATCH)) {
                put(match, line.substring(MATCH.length()), false);
            } else if (line.startsWith(PLAYER_SUM)) {
                put(players[player], line.substring(PLAYER_SUM.length()), true);
            } else if (line.startsWith(PLAYER)) {
                put(players[player], line.substring(PLAYER.length()), false);
            }
        }
    }

    private static void put(Map<String, String> data, String assignment, boolean sum) {
        int equals = assignment.indexOf('=');
        if (equals < 0) {
            return;
        }
        String key = assignment.substring(0, equals).strip();
        String value = assignment.substring(equals + 1).strip();
        if (key.isEmpty()) {
            return;
        }
        String before = data.get(key);
        String after = before != null && sum ? add(before, value) : value;
        int more = after.length() - (before == null ? -key.length() : before.length());
        if (more <= 0 || size(data) + more <= MOST) {
            data.put(key, after);
        }
    }

    private static int size(Map<String, String> data) {
        return data.entrySet().stream().mapToInt(entry -> entry.getKey().length() + entry.getValue().length()).sum();
    }

    /** The sum of two numbers, whole if both are; anything but a number counts as 0. */
    private static String add(String one, String other) {
        double sum = number(one) + number(other);
        return sum == Math.rint(sum) && Math.abs(sum) < 0x1p53 ? Long.toString((long) sum) : Double.toString(sum);
    }

    private static double number(String text) {
        try {
            double value = Double.parseDouble(text);
            return Double.isFinite(value) ? value : 0;
        } catch (NumberFormatException problem) {
            return 0;
        }
    }

    /** The match is over: an incomplete line is read as it is. */
    void end() {
        for (int player = 0; player < begun.length; player++) {
            readLines(player, begun[player]);
            begun[player] = "";
        }
    }

    Map<String, String> match() {
        return Collections.unmodifiableMap(match);
    }

    Map<String, String> player(int player) {
        return Collections.unmodifiableMap(players[player]);
    }
}

package steward.codingame;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.match.MatchListener;
import steward.match.Turn;

/**
 * Listener that keeps data about single turns, which bots write to stderr, for the JSON of rating tools. A line
 * {@code [TDATA][turn] name = value} is about the match, {@code [PDATA][turn] name = value} about the player. Only the
 * first {@value #MOST_CHARACTERS} characters are kept.
 */
public final class LeagueAttributes implements MatchListener {

    static final int MOST_CHARACTERS = 4 << 20;

    private static final Pattern LINE = Pattern.compile("\\[([TP])DATA]\\[(\\d{1,5})]\\s*(\\w+)\\s*=\\s*(.*)");
    /** Tools keep turns in 16 bits. */
    private static final int LAST_TURN = 65_535;

    private final List<Attribute> attributes = new ArrayList<>();
    private int left = MOST_CHARACTERS;

    /**
     * A value with a name.
     *
     * @param player the player it is about, or -1 for the match
     * @param turn   the turn, or -1 for the whole match
     */
    record Attribute(String name, int player, int turn, String value) { }

    @Override
    public void commands(Turn turn) {
        for (int player = 0; player < turn.players(); player++) {
            String stderr = turn.stderr(player);
            if (stderr != null && stderr.contains("DATA][")) {
                int number = player;
                stderr.lines().forEach(line -> read(number, line));
            }
        }
    }

    private void read(int player, String line) {
        Matcher matcher = LINE.matcher(line.strip());
        if (!matcher.matches() || line.length() > left || Integer.parseInt(matcher.group(2)) > LAST_TURN) {
            return;
        }
        left -= line.length();
        attributes.add(new Attribute(matcher.group(3), matcher.group(1).equals("P") ? player : -1,
            Integer.parseInt(matcher.group(2)), matcher.group(4)));
    }

    /** In the order of the match. */
    List<Attribute> list() {
        return attributes;
    }
}

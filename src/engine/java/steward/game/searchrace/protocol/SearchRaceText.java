package steward.game.searchrace.protocol;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import steward.game.TextCodec;
import steward.game.searchrace.OfficialSearchRace;
import steward.game.searchrace.SearchRace;
import steward.game.searchrace.SearchRaceSettings;
import steward.text.TextFormat;
import tools.jackson.core.io.NumberOutput;

/**
 * Line protocol of CodinGame for the search race. The setup is the number of all checkpoints of the race, then their
 * places in the order in which they are to be passed. A turn is {@code passed x y vx vy angle}. Once a message has
 * contained {@code debug}, one more line has the time of the last checkpoint passed in the turn before.
 *
 * <p>An answer is {@code X Y THRUST message} or {@code EXPERT ANGLE THRUST message}, split at single blanks, with whole
 * numbers as Java's {@code parseInt} reads them, exactly as the published referee takes it. The only addition: a
 * carriage return at the end is ignored.
 */
final class SearchRaceText implements TextCodec {

    private static final String DEBUG = "debug";
    private static final String EXPERT = "EXPERT";
    private static final int SHOWN = 40;

    private final SearchRace race;
    private String message;

    SearchRaceText(SearchRace race) {
        this.race = race;
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        double[][] checkpoints = race.checkpoints();
        out.append(race.toFinish()).append('\n');
        for (int k = 1; k <= race.toFinish(); k++) {
            double[] checkpoint = checkpoints[k % checkpoints.length];
            out.append((long) checkpoint[0]).append(' ').append((long) checkpoint[1]).append('\n');
        }
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        out.append(race.passed());
        append(out, race.bodies().x[0]);
        append(out, race.bodies().y[0]);
        append(out, race.bodies().vx[0]);
        append(out, race.bodies().vy[0]);
        out.append(' ').append(OfficialSearchRace.degrees(race.heading())).append('\n');
        if (race.wantsTimes()) {
            out.append(NumberOutput.toString(race.passTime(), true)).append('\n');
        }
    }

    private static void append(StringBuilder out, double value) {
        out.append(' ').append((long) value);
    }

    @Override
    public int answerLines(int player) {
        return 1;
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        message = null;
        String line = new String(answer, 0, length, StandardCharsets.UTF_8);
        String[] words = (line.endsWith("\r") ? line.substring(0, line.length() - 1) : line).split(" ");
        if (words.length < 3) {
            return "found \"" + TextFormat.beginning(line.strip(), SHOWN)
                + "\", expected X Y THRUST or EXPERT ANGLE THRUST with single blanks";
        }
        boolean expert = words[0].equals(EXPERT);
        int most = SearchRaceSettings.MAXIMUM_TURN;
        String wrong = expert ? wrong("ANGLE", words[1], -most, most)
            : wrong("X", words[0], Integer.MIN_VALUE, Integer.MAX_VALUE);
        wrong = wrong != null || expert ? wrong : wrong("Y", words[1], Integer.MIN_VALUE, Integer.MAX_VALUE);
        wrong = wrong != null ? wrong : wrong("THRUST", words[2], 0, SearchRaceSettings.MAXIMUM_THRUST);
        if (wrong != null) {
            return wrong;
        }
        int thrust = Integer.parseInt(words[2]);
        if (expert) {
            race.turn(Integer.parseInt(words[1]), thrust);
        } else {
            race.toward(Integer.parseInt(words[0]), Integer.parseInt(words[1]), thrust);
        }
        if (words.length > 3) {
            message = String.join(" ", Arrays.asList(words).subList(3, words.length));
            if (message.contains(DEBUG)) {
                race.askForTimes();
            }
        }
        return null;
    }

    /** Returns the error of a whole number, or {@code null}. */
    private static String wrong(String what, String word, int least, int most) {
        try {
            int value = Integer.parseInt(word);
            if (value >= least && value <= most) {
                return null;
            }
        } catch (NumberFormatException problem) {
            // reported below, with the range
        }
        return what + ": found \"" + TextFormat.beginning(word, SHOWN) + "\", expected a whole number"
            + (most == Integer.MAX_VALUE ? "" : " " + least + ".." + most);
    }

    @Override
    public String message(int player) {
        return message;
    }
}

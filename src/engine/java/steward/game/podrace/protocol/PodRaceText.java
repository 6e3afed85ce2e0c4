package steward.game.podrace.protocol;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.CommandLines;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.PodState;

/**
 * Line protocols of CodinGame for the pod race. If each player has several pods (the upper leagues), the setup is laps,
 * number of checkpoints and their places, and a turn shows each pod, own ones first, as {@code x y vx vy angle
 * nextCheckPointId}. If each has one (the lower leagues), there is no setup, and a turn is {@code x y nextX nextY
 * nextDist nextAngle} and a line {@code x y} per opponent.
 *
 * <p>Answers are one line per pod, {@code X Y THRUST|SHIELD|BOOST message}. If the {@code commands} of a scene are
 * {@code site}, the pattern of the contest's published referee reads them, with BOOST. Otherwise they are read as
 * leniently as real bots need it: any number of blanks, a carriage return, decimals and a plus in X and Y, lower-case
 * words, blanks at the end, and no third word, which means full thrust; the published referee refuses all of these but
 * blanks between the words, and a blank behind Y. If two blanks follow Y, the rest may be a message and the thrust is
 * full. Lines before a bad one take effect.
 */
public final class PodRaceText extends CommandLines {

    private static final int FULL_TURN = 360;

    /** Decimals as languages print them; Java alone would also read 1d, 0x1p3, NaN and Infinity. */
    private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

    /** Two blanks or more behind Y stand for a thrust that is left out: what follows is a message. */
    private static final Pattern MESSAGE_ONLY = Pattern.compile("\\S+\\s+\\S+\\s\\s+(.*\\D.*)");

    /** The whole line as the site reads it. A missing thrust after Y and a blank is full thrust. */
    private static final Pattern SITE =
        Pattern.compile("(-?[0-9]{1,9})\\s+(-?[0-9]{1,9})\\s+([0-9]{1,9}|SHIELD|BOOST)?(?:\\s+(.+))?");

    private final PodRace race;
    private final PodRaceSettings settings;

    public PodRaceText(PodRace race) {
        super(race.players());
        this.race = race;
        settings = race.settings();
    }

    private boolean isSinglePod() {
        return settings.podsPerPlayer() == 1;
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        if (isSinglePod()) {
            return;
        }
        double[][] checkpoints = race.checkpoints();
        out.append(settings.laps()).append('\n').append(checkpoints.length).append('\n');
        for (double[] checkpoint : checkpoints) {
            append(out, checkpoint[0], ' ');
            append(out, checkpoint[1], '\n');
        }
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        if (isSinglePod()) {
            writeSinglePod(out, player);
            return;
        }
        writePods(out, player);
        for (int other = 0; other < race.players(); other++) {
            if (other != player) {
                writePods(out, other);
            }
        }
    }

    private void writePods(StringBuilder out, int player) {
        int first = player * settings.podsPerPlayer();
        for (int pod = first; pod < first + settings.podsPerPlayer(); pod++) {
            PodState state = race.pod(pod);
            append(out, state.x(), ' ');
            append(out, state.y(), ' ');
            append(out, state.vx(), ' ');
            append(out, state.vy(), ' ');
            out.append(angle(state.heading())).append(' ').append(race.nextCheckpoint(pod)).append('\n');
        }
    }

    /** Whole degrees, 0..360 after wrapping and rounding; -1 while unset. */
    static long angle(double heading) {
        return Double.isNaN(heading) ? -1 : Math.round(PodJsonCache.degrees(heading));
    }

    private void writeSinglePod(StringBuilder out, int player) {
        PodState state = race.pod(player);
        double[] next = race.checkpoints()[race.nextCheckpoint(player)];
        double dx = next[0] - state.x();
        double dy = next[1] - state.y();
        append(out, state.x(), ' ');
        append(out, state.y(), ' ');
        append(out, next[0], ' ');
        append(out, next[1], ' ');
        append(out, Math.sqrt(dx * dx + dy * dy), ' ');
        out.append(relativeAngle(state.heading(), dx, dy)).append('\n');
        for (int other = 0; other < race.players(); other++) {
            if (other != player) {
                append(out, race.pod(other).x(), ' ');
                append(out, race.pod(other).y(), '\n');
            }
        }
    }

    /** The direction of (dx, dy) as seen from the heading, whole degrees -180..180; 0 while the heading is unset. */
    static long relativeAngle(double heading, double dx, double dy) {
        if (Double.isNaN(heading)) {
            return 0;
        }
        double degrees = (Math.toDegrees(StrictMath.atan2(dy, dx)) - PodJsonCache.degrees(heading)) % FULL_TURN;
        double wrapped = degrees > FULL_TURN / 2 ? degrees - FULL_TURN
            : degrees < -FULL_TURN / 2 ? degrees + FULL_TURN : degrees;
        return Math.round(wrapped);
    }

    private static void append(StringBuilder out, double value, char end) {
        out.append(Math.round(value)).append(end);
    }

    @Override
    public int answerLines(int player) {
        return settings.podsPerPlayer();
    }

    @Override
    protected String read(String line, int player, int index, List<String> said) {
        int pod = player * settings.podsPerPlayer() + index;
        return settings.siteCommands() ? readSiteLine(pod, line, said) : readLenientLine(pod, line, said);
    }

    private String readSiteLine(int pod, String line, List<String> said) {
        Matcher words = SITE.matcher(line);
        if (!words.matches()) {
            return notFound("as the site does: X Y of at most nine digits, a blank, and digits, SHIELD or BOOST; "
                + "behind them nothing, or a blank and a message", line);
        }
        int thrust = words.group(3) == null ? settings.maximumThrust() : thrust(words.group(3));
        if (thrust == PodRace.NO_COMMAND) {
            return noThrust(words.group(3));
        }
        race.command(pod, Integer.parseInt(words.group(1)), Integer.parseInt(words.group(2)), thrust);
        say(words.group(4), said);
        return null;
    }

    private String noThrust(String found) {
        return "thrust: " + notFound("a whole number 0.." + settings.maximumThrust() + ", SHIELD or BOOST", found);
    }

    private String readLenientLine(int pod, String line, List<String> said) {
        String[] words = line.strip().split("\\s+", 4);
        if (words.length < 2) {
            return notFound("X Y and a thrust, SHIELD or BOOST", line.strip());
        }
        double x = decimal(words[0]);
        double y = decimal(words[1]);
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return (Double.isNaN(x) ? "X: " : "Y: ") + notFound("a finite number", words[Double.isNaN(x) ? 0 : 1]);
        }
        int thrust = words.length < 3 ? settings.maximumThrust() : thrust(words[2]);
        if (thrust == PodRace.NO_COMMAND) {
            Matcher message = MESSAGE_ONLY.matcher(line.strip());
            if (!message.matches()) {
                return noThrust(words[2]);
            }
            race.command(pod, x, y, settings.maximumThrust());
            say(message.group(1), said);
            return null;
        }
        race.command(pod, x, y, thrust);
        say(words.length == 4 ? words[3] : null, said);
        return null;
    }

    /** A decimal number, or NaN. */
    private static double decimal(String word) {
        if (!DECIMAL.matcher(word).matches()) {
            return Double.NaN;
        }
        double value = Double.parseDouble(word);
        return Double.isFinite(value) ? value + 0.0 : Double.NaN;
    }

    private int thrust(String word) {
        switch (word.toUpperCase(Locale.ROOT)) {
            case "SHIELD" -> {
                return PodRace.SHIELD;
            }
            case "BOOST" -> {
                return PodRace.BOOST;
            }
            default -> {
                double value = decimal(word);
                boolean good = value == Math.rint(value) && value >= 0 && value <= settings.maximumThrust();
                return good ? (int) value : PodRace.NO_COMMAND;
            }
        }
    }
}

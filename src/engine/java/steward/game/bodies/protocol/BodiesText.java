package steward.game.bodies.protocol;

import java.nio.charset.StandardCharsets;
import steward.game.TextCodec;
import steward.game.bodies.BodiesGame;
import steward.game.bodies.BodiesGame.Thrust;
import steward.game.bodies.Body;
import steward.game.bodies.Zone;
import steward.physics.Bodies;
import steward.text.TextFormat;
import tools.jackson.core.io.NumberOutput;

/**
 * Lines of numbers. The setup is {@code PLAYER PLAYERS DISCS ZONES}, a line {@code OWNER RADIUS MASS} for each disc (-1
 * for nobody, and for an infinite mass), and a line {@code X Y RADIUS POINTS} for each zone. A turn is a line with the
 * scores, then {@code X Y VX VY} for each disc. An answer has a line {@code X Y} for each of the player's discs, and
 * behind the numbers of the first a message.
 */
final class BodiesText implements TextCodec {

    private static final int SHOWN = 40;

    private final BodiesGame game;
    private final String[] messages;

    BodiesText(BodiesGame game) {
        this.game = game;
        messages = new String[game.players()];
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        out.append(player).append(' ').append(game.players()).append(' ').append(game.discs().size()).append(' ')
            .append(game.rules().zones().size()).append('\n');
        for (Body disc : game.discs()) {
            out.append(disc.owner());
            numbers(out, disc.radius(), disc.mass() == Double.POSITIVE_INFINITY ? -1 : disc.mass());
        }
        for (Zone zone : game.rules().zones()) {
            out.append(text(zone.x()));
            numbers(out, zone.y(), zone.radius(), zone.points());
        }
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        double[] scores = game.scores();
        out.append(text(scores[0]));
        for (int other = 1; other < scores.length; other++) {
            out.append(' ').append(text(scores[other]));
        }
        out.append('\n');
        Bodies bodies = game.bodies();
        for (int k = 0; k < game.discs().size(); k++) {
            out.append(text(bodies.x[k]));
            numbers(out, bodies.y[k], bodies.vx[k], bodies.vy[k]);
        }
    }

    /** Appends the rest of a line. */
    private static void numbers(StringBuilder out, double... values) {
        for (double value : values) {
            out.append(' ').append(text(value));
        }
        out.append('\n');
    }

    private static String text(double value) {
        return value == Math.rint(value) && Math.abs(value) < 0x1p53 ? Long.toString((long) value)
            : NumberOutput.toString(value, true);
    }

    @Override
    public int answerLines(int player) {
        return game.owned(player).length;
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        messages[player] = null;
        String[] lines = new String(answer, 0, length, StandardCharsets.UTF_8).split("\n", -1);
        int[] owned = game.owned(player);
        Thrust[] thrusts = new Thrust[owned.length];
        for (int k = 0; k < owned.length; k++) {
            String[] words = lines[k].strip().split("\\s+", 3);
            double x = number(words, 0);
            double y = number(words, 1);
            if (Double.isNaN(x) || Double.isNaN(y) || k > 0 && words.length > 2) {
                return "line " + (k + 1) + ": found \"" + TextFormat.beginning(lines[k].strip(), SHOWN)
                    + "\", expected two numbers X Y";
            }
            String wrong = BodiesAnswer.tooLong(game, x, y);
            if (wrong != null) {
                return "line " + (k + 1) + ": " + wrong;
            }
            thrusts[k] = new Thrust(x, y);
            messages[player] = words.length > 2 ? words[2] : messages[player];
        }
        for (int k = 0; k < owned.length; k++) {
            game.thrust(owned[k], thrusts[k]);
        }
        return null;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }

    /** A finite number of decimal digits, or NaN. */
    private static double number(String[] words, int index) {
        if (index >= words.length || !words[index].matches("[-+]?[0-9.]+([eE][-+]?[0-9]+)?")) {
            return Double.NaN;
        }
        try {
            double value = Double.parseDouble(words[index]);
            return Double.isInfinite(value) ? Double.NaN : value + 0.0;
        } catch (NumberFormatException problem) {
            return Double.NaN;
        }
    }
}

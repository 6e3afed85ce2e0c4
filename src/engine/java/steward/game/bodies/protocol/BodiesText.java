package steward.game.bodies.protocol;

import java.util.List;
import steward.game.CommandLines;
import steward.game.bodies.BodiesGame;
import steward.game.bodies.BodiesGame.Thrust;
import steward.game.bodies.Body;
import steward.game.bodies.Zone;
import steward.physics.Bodies;
import tools.jackson.core.io.NumberOutput;

/**
 * Line protocol of the game {@code bodies}. The setup is {@code PLAYER PLAYERS DISCS ZONES}, a line {@code OWNER RADIUS
 * MASS} for each disc (-1 for nobody, and for an infinite mass), and a line {@code X Y RADIUS POINTS} for each zone. A
 * turn is a line with the scores, then {@code X Y VX VY} for each disc; a disc that a zone has taken out has that
 * zone's centre and no speed. An answer has a line {@code X Y} for each of the player's discs, with an optional message
 * behind it.
 */
final class BodiesText extends CommandLines {

    private final BodiesGame game;

    BodiesText(BodiesGame game) {
        super(game.players());
        this.game = game;
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
        for (int id = 0, k = 0; id < game.discs().size(); id++) {
            Zone taker = game.taker(id);
            out.append(text(taker == null ? bodies.x[k] : taker.x()));
            if (taker == null) {
                numbers(out, bodies.y[k], bodies.vx[k], bodies.vy[k]);
                k++;
            } else {
                numbers(out, taker.y(), 0, 0);
            }
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
    protected String read(String line, int player, int index, List<String> said) {
        String[] words = line.strip().split("\\s+", 3);
        double x = number(words, 0);
        double y = number(words, 1);
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return notFound("two numbers X Y", withoutReturn(line));
        }
        say(words.length > 2 ? words[2] : null, said);
        String wrong = BodiesAnswer.tooLong(game, x, y);
        if (wrong == null) {
            game.thrust(game.owned(player)[index], new Thrust(x, y));
        }
        return wrong;
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

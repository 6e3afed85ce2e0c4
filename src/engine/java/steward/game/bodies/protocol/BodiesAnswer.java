package steward.game.bodies.protocol;

import steward.game.bodies.BodiesGame;
import steward.game.bodies.BodiesGame.Thrust;
import steward.json.CommandsAnswer;
import steward.numerics.SplitMix64;
import tools.jackson.core.JsonParser;

/**
 * Reader of the thrusts that a player commands, from the JSON of answers and replays. They are {@code thrusts}, an
 * array with one object for each disc of the player, {@code {"x":1,"y":-2.5}}, ascending by ids.
 */
final class BodiesAnswer extends CommandsAnswer<Thrust> {

    private final BodiesGame game;

    BodiesAnswer(BodiesGame game) {
        super("thrusts", FARTHEST, "x", "y");
        this.game = game;
    }

    /** An answer for measuring. */
    static String drawn(int count, double most, SplitMix64 random) {
        StringBuilder text = new StringBuilder("{\"thrusts\":[");
        for (int k = 0; k < count; k++) {
            text.append(k == 0 ? "" : ",").append("{\"x\":").append(component(most, random)).append(",\"y\":")
                .append(component(most, random)).append('}');
        }
        return text.append("]}").toString();
    }

    /** A number in a square inside the circle of all thrusts. */
    private static double component(double most, SplitMix64 random) {
        return 0.7 * most * (2 * random.nextDouble() - 1);
    }

    /** Returns the error of a thrust that is too long, or {@code null}. */
    static String tooLong(BodiesGame game, double x, double y) {
        double length = Math.sqrt(x * x + y * y);
        double most = game.rules().maximumThrust();
        return length <= most ? null : "found a thrust of length " + length + ", expected at most " + most;
    }

    @Override
    protected int count() {
        return game.owned(player).length;
    }

    @Override
    protected void beginCommand() {
        // x and y are forgotten already
    }

    @Override
    protected String commandField(String field, JsonParser in) {
        throw new IllegalStateException(field);
    }

    @Override
    protected String endCommand(int index) {
        String wrong = missingTarget();
        if (wrong != null) {
            return wrong;
        }
        wrong = tooLong(game, x, y);
        return wrong == null ? keep(index, new Thrust(x + 0.0, y + 0.0)) : ": " + wrong;
    }
}

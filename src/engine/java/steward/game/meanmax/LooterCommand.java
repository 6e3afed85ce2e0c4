package steward.game.meanmax;

/**
 * A looter's command for a turn: to wait, to thrust toward a place, or to use its skill at a place.
 *
 * @param action the kind of command
 * @param x      the place of the thrust or skill, in u; 0 for {@code WAIT}
 * @param y      as {@code x}
 * @param power  of a thrust, at least 0; more than {@value #MOST_POWER} counts as {@value #MOST_POWER}
 */
public record LooterCommand(Action action, double x, double y, double power) {

    public static final int MOST_POWER = 300;

    public static final LooterCommand WAIT = new LooterCommand(Action.WAIT, 0, 0, 0);

    /** Kinds of commands. */
    public enum Action {
        /** Nothing. */
        WAIT,
        /** A thrust toward a place. */
        MOVE,
        /** The looter's skill, at a place. */
        SKILL
    }

    /** A thrust toward a place. */
    public static LooterCommand move(double x, double y, double power) {
        return new LooterCommand(Action.MOVE, x, y, power);
    }

    public static LooterCommand skill(double x, double y) {
        return new LooterCommand(Action.SKILL, x, y, 0);
    }
}

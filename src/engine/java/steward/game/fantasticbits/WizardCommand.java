package steward.game.fantasticbits;

/**
 * A wizard's command for a turn: move, throw, or cast a spell.
 *
 * @param x      the place it is about, in u; 0 for a spell
 * @param y      the same
 * @param power  of a thrust or throw; 0 for a spell
 * @param spell  the spell, or {@code null}
 * @param target the id of the entity that a spell is aimed at; -1 for none
 */
public record WizardCommand(Action action, double x, double y, double power, Spell spell, int target) {

    public static final int MOST_THRUST = 150;

    public static final int MOST_THROW = 500;

    /** Kinds of commands. */
    public enum Action {
        /** A thrust toward a place. */
        MOVE,
        /** The snaffle that it holds is thrown toward a place. */
        THROW,
        /** A spell on an entity. */
        CAST
    }

    /** A thrust toward a place. */
    public static WizardCommand move(double x, double y, double power) {
        return new WizardCommand(Action.MOVE, x, y, power, null, -1);
    }

    /** A throw toward a place. */
    public static WizardCommand toss(double x, double y, double power) {
        return new WizardCommand(Action.THROW, x, y, power, null, -1);
    }

    public static WizardCommand cast(Spell spell, int target) {
        return new WizardCommand(Action.CAST, 0, 0, 0, spell, target);
    }

    /** The greatest power of a move or a throw. */
    public static int mostPower(Action action) {
        return action == Action.MOVE ? MOST_THRUST : MOST_THROW;
    }
}

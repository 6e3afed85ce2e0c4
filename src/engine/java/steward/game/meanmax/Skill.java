package steward.game.meanmax;

import java.util.Locale;

/** Skills of looters, in the order in which their effects work within a turn. */
public enum Skill {

    /** Adds {@value MeanMaxWorld#TAR_MASS} to the mass of units within it, each turn. */
    TAR(5, 30, 3),
    /** Units within it have no friction, and reapers cannot harvest. */
    OIL(6, 30, 3),
    /** Throws units away from its centre in the turn in which it is cast. */
    GRENADE(7, 60, 1);

    private final int type;
    private final int cost;
    private final int turns;
    private final String text = name().toLowerCase(Locale.ROOT);

    Skill(int type, int cost, int turns) {
        this.type = type;
        this.cost = cost;
        this.turns = turns;
    }

    /** The number of its effects in the site's lines. */
    public int type() {
        return type;
    }

    public int cost() {
        return cost;
    }

    /** Returns how many turns it works, the one in which it is cast included. */
    public int turns() {
        return turns;
    }

    /** Its name in frames. */
    public String text() {
        return text;
    }
}

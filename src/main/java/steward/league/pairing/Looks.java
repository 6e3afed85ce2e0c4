package steward.league.pairing;

/**
 * Decisions at which results are looked at anew: at first every one, later whenever there are about 2% more. These
 * decisions depend on their numbers alone, so that an interrupted league looks at the same ones.
 */
public final class Looks {

    private static final int SHARE = 32;

    private Looks() { }

    /** The last look at or before a decision. */
    public static int of(int decision) {
        return decision - decision % Math.max(1, Integer.highestOneBit(decision / SHARE));
    }

    /** A number below which a schedule that goes on at a decision never asks for results again. */
    public static int settled(int decision, int lag) {
        return Math.max(0, of(decision) - lag + 1);
    }

    /** True if there is a look before this decision. */
    public static boolean isLook(int decision) {
        return of(decision) == decision;
    }
}

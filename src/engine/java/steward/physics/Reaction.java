package steward.physics;

/**
 * Callback of a game that answers a contact whose {@link Contacts} entry is {@code ASK}. It is called inside the
 * advance, at the exact time, with all positions at that time and the velocities before any impulse.
 *
 * <p>A reaction reads and alters the given bodies and nothing else, so that it also runs on copies of a game's bodies,
 * in measurements and searches. It passes facts for the game to the sink (see {@link TurnSink#fact}); the game takes
 * them from its own log after the turn.
 */
@FunctionalInterface
public interface Reaction {

    /** Answer to a contact. */
    enum Verdict {
        /** An impact under the scene's law. */
        BOUNCE,
        /** The two pass through each other; the reaction is not called again until they have separated. */
        PASS,
        /**
         * The bodies were altered (moved, removed, added, given other speeds or properties): the rest of the batch is
         * dropped and all predictions are computed anew. If nothing was altered, the reaction is called again at the
         * same instant, until the bound on impacts ends the turn.
         */
        CHANGED,
        /**
         * The bodies were altered without an impulse, none removed or added; the rest of the batch goes on with the
         * bodies as they now are, then all predictions are computed anew. If one was removed or added after all: as
         * {@code CHANGED}.
         */
        ALTERED
    }

    /**
     * @param time   within the turn, 0..1
     * @param a      index of the body
     * @param b      index of the other body, or {@code ~w} (negative) for the wall with index w
     * @param bodies all bodies; may be altered if the answer is {@code CHANGED} or {@code ALTERED}
     * @param sink   receives facts
     */
    Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink);

    /**
     * Called after the impulse of a contact that was answered by {@code BOUNCE}, and after its positional correction.
     * May alter bodies, but neither add nor remove any; the rest of the batch goes on with the bodies as they are.
     *
     * @param b index of the other body, or {@code ~w}
     * @return whether anything but the two was altered
     */
    default boolean after(double time, int a, int b, Bodies bodies, TurnSink sink) {
        return false;
    }
}

package steward.physics;

/**
 * The game's answer to a contact whose {@link Contacts} entry is {@code ASK}. Called inside the advance, at the exact
 * time, with all positions at that time and the velocities before any impulse.
 */
@FunctionalInterface
public interface Reaction {

    /** What is to happen. */
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
        CHANGED
    }

    /**
     * @param time   within the turn, 0..1
     * @param a      index of the body
     * @param b      index of the other body, or {@code ~w} (negative) for the wall with index w
     * @param bodies all bodies; may be altered if the answer is {@code CHANGED}
     */
    Verdict on(double time, int a, int b, Bodies bodies);
}

package steward.physics;

/**
 * The scene's answer to a touch whose {@link Contacts} say {@code ASK}. Called inside the advance, at the exact time,
 * with the bodies in their places and the speeds before any impulse.
 */
@FunctionalInterface
public interface Reaction {

    /** What is to happen. */
    enum Verdict {
        /** An impact under the scene's law. */
        BOUNCE,
        /** They pass through each other, and nobody asks again until they have separated. */
        PASS,
        /**
         * The bodies were altered (moved, removed, added, given other speeds or properties): the rest of the batch is
         * dropped and the advance looks anew. Altering nothing and saying so asks again at the same instant, until the
         * bound on impacts ends it.
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

package steward.physics;

/** Algorithm that advances all bodies by one turn, from t = 0 to t = 1. One instance serves one thread. */
public interface Advance {

    /**
     * Alternates free flight and impacts until the turn is over or the bound on impacts ends it.
     *
     * @param bodies altered in place
     * @param sink   receives impacts and path knots
     * @throws IllegalArgumentException before anything is altered, if a number is too large to compute with; the
     *                                  message names the body, what was found and what was expected
     */
    void turn(Bodies bodies, TurnSink sink);
}

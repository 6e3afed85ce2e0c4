package steward.game;

import java.util.function.IntPredicate;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * Player that follows rules, for measuring: it leads games to states that occur in play. It is stateless, and all its
 * random numbers come from the given generator, so that the same seeds give the same games.
 */
@FunctionalInterface
public interface Pilot {

    /** Purpose of a pilot. */
    enum Aim {
        /** To win, more or less. */
        WIN,
        /** All bodies come to the same place and stay there. */
        GATHER,
        /** Bodies meet, whatever the state: the commands depend on the generator alone. */
        MINGLE
    }

    /**
     * The next answer of a player.
     *
     * @param game   its current state, one of the setup that offers this pilot
     * @param player the player that answers
     * @param random where all random numbers come from
     * @return the line of JSON that a bot would send
     */
    String answer(Game game, int player, SplitMix64 random);

    /** The wanted body whose centre is nearest to that of another, the first of equals; -1 if none is wanted. */
    static int nearest(Bodies bodies, int self, IntPredicate wanted) {
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int body = 0; body < bodies.size(); body++) {
            double dx = bodies.x[self] - bodies.x[body];
            double dy = bodies.y[self] - bodies.y[body];
            if (wanted.test(body) && dx * dx + dy * dy < least) {
                nearest = body;
                least = dx * dx + dy * dy;
            }
        }
        return nearest;
    }
}

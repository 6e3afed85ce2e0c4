package steward.game.podrace;

/**
 * State of one pod between two turns.
 *
 * @param x           centre, in u
 * @param y           centre, in u
 * @param vx          velocity, in u per turn
 * @param vy          velocity, in u per turn
 * @param heading     in radians, not normalised; NaN while unset
 * @param shieldTimer 4 after the turn the shield was raised, counting down to 0
 * @param passed      how many checkpoints it has passed; the next is number {@code (passed + 1) % n}
 */
public record PodState(double x, double y, double vx, double vy, double heading, int shieldTimer, boolean boostLeft,
                       int passed) { }

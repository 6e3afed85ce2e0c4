package steward.bots.searchrace;

/** A bot's command to its car: an angle to turn by, and a thrust. */
final class Command {

    static final int MAXIMUM_TURN = 18;
    static final int MAXIMUM_THRUST = 200;

    /** -18..18. */
    int degrees;
    /** 0..200. */
    int thrust;

    void set(double turn, int power) {
        degrees = (int) Math.max(-MAXIMUM_TURN, Math.min(MAXIMUM_TURN, Math.round(turn)));
        thrust = power;
    }
}

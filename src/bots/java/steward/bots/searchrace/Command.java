package steward.bots.searchrace;

/** What a bot tells its car: by how much to turn, and with how much thrust. */
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

package steward.bots.searchrace;

import java.io.IOException;

/**
 * The plain bot: it steers at the next checkpoint, less a few turns of its own velocity, so that the drift carries it
 * there, and gives no thrust while it looks elsewhere.
 */
public final class Driver extends SearchRaceBot {

    /** How many turns of velocity the aim is moved back. */
    private static final double DRIFT_TURNS = 4;
    /** Degrees off the aim from which on there is no thrust. */
    private static final double SIDEWAYS = 75;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Driver().run();
    }

    @Override
    void decide(Course race, Car now, Command command) {
        steer(race, now, race.next(now.passed), command);
    }

    /** Steers at a checkpoint, the drift taken into account. */
    static void steer(Course race, Car now, int checkpoint, Command command) {
        double off = now.angleTo(race.x[checkpoint] - DRIFT_TURNS * now.vx, race.y[checkpoint] - DRIFT_TURNS * now.vy);
        command.set(off, Math.abs(off) < SIDEWAYS ? Command.MAXIMUM_THRUST : 0);
    }
}

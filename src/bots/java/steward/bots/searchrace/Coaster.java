package steward.bots.searchrace;

import java.io.IOException;

/**
 * The bot that looks at one thing ahead: it steers as {@link Driver} does, but at the checkpoint after the next as soon
 * as that carries it through the next.
 */
public final class Coaster extends SearchRaceBot {

    /** Turns that are predicted. */
    private static final int TURNS = 6;

    private final Car trial = new Car();

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Coaster().run();
    }

    @Override
    void decide(Course race, Car now, Command command) {
        if (now.passed + 1 == race.toFinish() || !passes(race, now, command)) {
            Driver.steer(race, now, race.next(now.passed), command);
        } else {
            Driver.steer(race, now, race.next(now.passed + 1), command);
        }
    }

    /** True if the car that steers at the checkpoint after the next passes the next within some turns. */
    private boolean passes(Course race, Car now, Command command) {
        int next = race.next(now.passed);
        double reach = race.radius + TURNS * (Math.abs(now.vx) + Math.abs(now.vy) + Command.MAXIMUM_THRUST);
        if (now.distanceTo(race.x[next], race.y[next]) > reach) {
            return false;
        }
        trial.set(now);
        for (int turn = 0; turn < TURNS && trial.passed == now.passed; turn++) {
            Driver.steer(race, trial, race.next(now.passed + 1), command);
            trial.play(race, command.degrees, command.thrust);
        }
        return trial.passed > now.passed;
    }
}

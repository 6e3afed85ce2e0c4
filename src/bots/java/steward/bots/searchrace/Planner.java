package steward.bots.searchrace;

import java.io.IOException;

/**
 * The bot that searches: it tries beginnings, each a turn and a thrust held for some turns, drives on as
 * {@link Coaster} does from there, and takes the beginning after which the car is farthest along the course.
 */
public final class Planner extends SearchRaceBot {

    private static final int[] DEGREES = {-18, -9, -3, 0, 3, 9, 18};
    private static final int[] THRUSTS = {0, 200};
    /** For how many turns a beginning is held. */
    private static final int[] HELD = {2, 5, 9};
    /** How many turns are looked ahead. */
    private static final int HORIZON = 24;
    /** Worth of a checkpoint passed, in u: more than any distance. */
    private static final double CHECKPOINT = 50_000;
    /** Worth of passing one a turn earlier, in u. */
    private static final double TURN = 400;

    private final Car trial = new Car();
    private final Coaster rule = new Coaster();
    private final Command steered = new Command();

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Planner().run();
    }

    @Override
    void decide(Course race, Car now, Command command) {
        rule.decide(race, now, steered);
        command.degrees = steered.degrees;
        command.thrust = steered.thrust;
        double best = worth(race, now, 0, 0, 0);
        for (int held : HELD) {
            for (int degrees : DEGREES) {
                for (int thrust : THRUSTS) {
                    double worth = worth(race, now, degrees, thrust, held);
                    if (worth > best) {
                        best = worth;
                        command.degrees = degrees;
                        command.thrust = thrust;
                    }
                }
            }
        }
    }

    private double worth(Course race, Car now, int degrees, int thrust, int held) {
        trial.set(now);
        double worth = 0;
        for (int turn = 0; turn < HORIZON && trial.passed < race.toFinish(); turn++) {
            int before = trial.passed;
            double passTime;
            if (turn < held) {
                passTime = trial.play(race, degrees, thrust);
            } else {
                rule.decide(race, trial, steered);
                passTime = trial.play(race, steered.degrees, steered.thrust);
            }
            worth += (trial.passed - before) * (CHECKPOINT + TURN * (HORIZON - turn - passTime));
        }
        if (trial.passed >= race.toFinish()) {
            return worth + CHECKPOINT;
        }
        int next = race.next(trial.passed);
        return worth - trial.distanceTo(race.x[next], race.y[next]);
    }
}

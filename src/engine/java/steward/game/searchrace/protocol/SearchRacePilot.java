package steward.game.searchrace.protocol;

import steward.game.searchrace.SearchRace;
import steward.numerics.SplitMix64;

/** Pilot of the car with seeded commands: it aims at the next checkpoint against its drift, and misses a little. */
final class SearchRacePilot {

    /** How many turns of its velocity a car aims short of its checkpoint, so that the drift carries it there. */
    private static final int DRIFT = 3;
    /** The most by which it misses its target along each axis, in u. */
    private static final int AIM = 300;
    /** One of this many commands turns by degrees. */
    private static final int TURNS = 10;

    static String answer(SearchRace race, SplitMix64 random) {
        if (random.nextInt(TURNS) == 0) {
            return "{\"turn\":" + random.nextInt(-18, 18) + ",\"thrust\":" + random.nextInt(0, 200) + "}";
        }
        double[] goal = race.checkpoints()[race.nextCheckpoint()];
        return "{\"x\":" + Math.round(goal[0] - DRIFT * race.bodies().vx[0] + random.nextInt(-AIM, AIM))
            + ",\"y\":" + Math.round(goal[1] - DRIFT * race.bodies().vy[0] + random.nextInt(-AIM, AIM))
            + ",\"thrust\":" + random.nextInt(50, 200) + "}";
    }
}

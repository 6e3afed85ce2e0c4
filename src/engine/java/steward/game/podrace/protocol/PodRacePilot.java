package steward.game.podrace.protocol;

import java.util.StringJoiner;
import steward.game.Pilot;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.numerics.SplitMix64;

/** Pilot of pods with seeded commands: a race, a brawl, or a crowd in the middle. */
final class PodRacePilot {

    /** One of this many commands is a shield. */
    private static final int SHIELDS = 25;
    /** Divisor of shields in a crowd. */
    private static final int CROWD_SHIELDS = 20;
    /** How many turns of its velocity a pod aims short of its checkpoint, so that the drift carries it there. */
    private static final int DRIFT = 3;
    /** The most by which a pilot misses its target along each axis, in u. */
    private static final int AIM = 300;
    /** A pod that shall stop somewhere gets a unit of thrust per this many u of distance. */
    private static final int BRAKE = 10;

    static String answer(PodRace race, int player, SplitMix64 random, Pilot.Aim aim) {
        int pods = race.settings().podsPerPlayer();
        StringJoiner all = new StringJoiner(",", "{\"pods\":[", "]}");
        for (int pod = player * pods; pod < (player + 1) * pods; pod++) {
            all.add(aim == Pilot.Aim.MINGLE ? crowd(random) : drive(race, pod, random, aim == Pilot.Aim.GATHER));
        }
        return all.toString();
    }

    private static String drive(PodRace race, int pod, SplitMix64 random, boolean brawl) {
        double[][] checkpoints = race.checkpoints();
        PodState state = race.pod(pod);
        double[] goal = checkpoints[brawl ? 1 : (state.passed() + 1) % checkpoints.length];
        double aimX = goal[0] - DRIFT * state.vx() + random.nextInt(-AIM, AIM);
        double aimY = goal[1] - DRIFT * state.vy() + random.nextInt(-AIM, AIM);
        long x = Math.round(aimX);
        long y = Math.round(aimY);
        int most = race.settings().maximumThrust();
        double far = Math.abs(aimX - state.x()) + Math.abs(aimY - state.y());
        int least = brawl ? (int) Math.min(most, far / BRAKE) : most / 2;
        String power = random.nextInt(SHIELDS) == 0 ? "\"shield\":true"
            : "\"thrust\":" + (brawl ? least : random.nextInt(least, most));
        return "{\"x\":" + x + ",\"y\":" + y + "," + power + "}";
    }

    /** A random place near the middle, so that pods meet; now and then a shield. */
    private static String crowd(SplitMix64 random) {
        return "{\"x\":" + random.nextInt(6000, 10_000) + ",\"y\":" + random.nextInt(3000, 6000)
            + (random.nextInt(CROWD_SHIELDS) == 0 ? ",\"shield\":true}"
                : ",\"thrust\":" + random.nextInt(50, 100) + "}");
    }
}

package steward.cli.lab;

import java.util.StringJoiner;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.lab.calibration.SeededPlay;
import steward.numerics.SplitMix64;

/** Players by rule for seeded play: they lead a game to states that occur in real play of its scene. */
final class SeededPilots {

    /** One of this many commands is a shield. */
    private static final int SHIELDS = 25;
    /** How many turns of its velocity a pod aims short of its checkpoint, so that the drift carries it there. */
    private static final int DRIFT = 3;
    /** The most by which a pilot misses its target along each axis, in u. */
    private static final int AIM = 300;
    /** A pod that shall stop somewhere gets a unit of thrust per this many u of distance. */
    private static final int BRAKE = 10;

    private SeededPilots() {
    }

    /** A play of a scene whose players try to win. The pod race is the only game that is supported. */
    static SeededPlay race(GameSetup setup, long seed) {
        return new SeededPlay(setup, racing(), seed);
    }

    /** The players of that play. */
    static SeededPlay.Script racing() {
        return (game, player, random) -> answer((PodRace) game, player, random, false);
    }

    /** A play of a pod race in which all pods head for the same checkpoint and stay there. */
    static SeededPlay brawl(GameSetup setup, long seed) {
        return new SeededPlay(setup, (game, player, random) -> answer((PodRace) game, player, random, true), seed);
    }

    private static String answer(PodRace race, int player, SplitMix64 random, boolean brawl) {
        double[][] checkpoints = race.checkpoints();
        int pods = race.settings().podsPerPlayer();
        StringJoiner all = new StringJoiner(",", "{\"pods\":[", "]}");
        for (int pod = player * pods; pod < (player + 1) * pods; pod++) {
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
            all.add("{\"x\":" + x + ",\"y\":" + y + "," + power + "}");
        }
        return all.toString();
    }
}

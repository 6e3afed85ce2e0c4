package steward.bots;

import java.io.IOException;

/**
 * One step above {@link Racer}, by one idea: a pod keeps most of its speed from turn to turn, so it aims beside its
 * checkpoint, against that drift. It needs no brakes: three turns before the checkpoint the aim lies behind the pod,
 * and the engine is off while the pod points the wrong way.
 *
 * <p>Its limits: it does not predict the outcome of a turn; it ignores the checkpoint after the next and other pods,
 * and never uses shield or boost.
 */
public final class Regular extends PodBot {

    /** A bot for one match. */
    public Regular() {
        super(new AgainstDrift());
    }

    private Regular(double driftTurns, double leastShare) {
        super((race, pods, commands) -> {
            for (int pod = 0; pod < pods.size; pod++) {
                if (pods.player[pod] == race.player) {
                    AgainstDrift.drive(race, pods, pod, commands, driftTurns, leastShare);
                }
            }
        });
    }

    /**
     * Plays one match over the standard streams.
     *
     * @param arguments none; or, to be tuned, turns of velocity by which the aim is moved back, and the least share of
     *                  the thrust
     */
    public static void main(String[] arguments) throws IOException {
        if (arguments.length == 2) {
            new Regular(Double.parseDouble(arguments[0]), Double.parseDouble(arguments[1])).run();
        } else {
            new Regular().run();
        }
    }

    /** The decision. */
    static final class AgainstDrift implements Strategy {

        /** How many turns of velocity the aim is moved back; 2 to 5 were about equal. */
        private static final double DRIFT_TURNS = 3;

        @Override
        public void decide(Race race, Pods pods, Commands commands) {
            for (int pod = 0; pod < pods.size; pod++) {
                if (pods.player[pod] == race.player) {
                    drive(race, pods, pod, commands);
                }
            }
        }

        /** Gives a pod its command: the less thrust the more it has to turn. */
        static void drive(Race race, Pods pods, int pod, Commands commands) {
            drive(race, pods, pod, commands, DRIFT_TURNS, 0);
        }

        private static void drive(Race race, Pods pods, int pod, Commands commands, double driftTurns,
                                  double leastShare) {
            double x = race.checkpointX[pods.next[pod]] - driftTurns * pods.vx[pod];
            double y = race.checkpointY[pods.next[pod]] - driftTurns * pods.vy[pod];
            commands.set(pod, x, y, (int) (race.maximumThrust * Math.max(leastShare, pods.cosineTo(pod, x, y))));
        }
    }
}

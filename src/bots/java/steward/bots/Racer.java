package steward.bots;

import java.io.IOException;

/**
 * The plain bot: every pod steers at the centre of its next checkpoint, the slower the more it has to turn, and slows
 * down before it arrives. It ignores its drift and other pods, and never uses shield or boost.
 */
public final class Racer extends PodBot {

    /** A bot for one match. */
    public Racer() {
        super(new StraightOn());
    }

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Racer().run();
    }

    /** The decision. */
    static final class StraightOn implements Strategy {

        /** Thrust as a share of the maximum that suffices to keep a pod turning. */
        private static final double LEAST_SHARE = 0.1;
        /** Where braking begins, in checkpoint radii from the centre. */
        private static final double BRAKING_RADII = 2;

        @Override
        public void decide(Race race, Pods pods, Commands commands) {
            for (int pod = 0; pod < pods.size; pod++) {
                if (pods.player[pod] == race.player) {
                    decide(race, pods, pod, commands);
                }
            }
        }

        private static void decide(Race race, Pods pods, int pod, Commands commands) {
            double x = race.checkpointX[pods.next[pod]];
            double y = race.checkpointY[pods.next[pod]];
            double distance = pods.toNext(race, pod);
            double share = Math.min(1, distance / (BRAKING_RADII * race.checkpointRadius));
            share *= Math.max(0, pods.cosineTo(pod, x, y));
            int thrust = (int) (race.maximumThrust * Math.max(LEAST_SHARE, share));
            commands.set(pod, x, y, thrust);
        }
    }
}

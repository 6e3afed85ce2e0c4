package steward.bots;

import java.io.IOException;

/**
 * One step above {@link Regular}, by one idea: it simulates before it decides. It simulates what {@link Regular} would
 * do with a {@link Forecast}, and six other first moves, and takes the one that brings the pod farthest.
 *
 * <p>Its limits: the forecast has one pod alone, so it predicts walls but no other pod; no pod blocks an enemy, and
 * shield and boost are never used. {@link Veteran} does all this.
 */
public final class Contender extends PodBot {

    /** A bot for one match. */
    public Contender() {
        super(new OneMoveAhead());
    }

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Contender().run();
    }

    /** The decision: for each pod 7 times 12 turns of the forecast, in any race, so that an answer is quick. */
    static final class OneMoveAhead implements Strategy {

        /** No first move: drive as {@link Regular} from the first turn on. */
        private static final int BY_RULE = -1;
        /** Moves 0 to 5: to the left, straight on, to the right, each with full thrust and without. */
        private static final double[] COSINES = {Forecast.TURN_COSINE, 1, Forecast.TURN_COSINE};
        private static final double[] SINES = {-Forecast.TURN_SINE, 0, Forecast.TURN_SINE};
        private static final int MOVES = 2 * COSINES.length;
        /** For how many turns the first move is held before the rule takes over. */
        private static final int MOVE_TURNS = 3;
        /** How many turns are simulated. */
        private static final int TURNS = 12;

        private final Pods alone = new Pods();
        private final Commands trial = new Commands();
        private Forecast forecast;

        @Override
        public void decide(Race race, Pods pods, Commands commands) {
            if (forecast == null) {
                forecast = new Forecast(race, 1);
            }
            for (int pod = 0; pod < pods.size; pod++) {
                if (pods.player[pod] == race.player) {
                    command(race, pods, pod, bestMove(race, pods, pod), commands);
                }
            }
        }

        private int bestMove(Race race, Pods pods, int pod) {
            int best = BY_RULE;
            double most = worth(race, pods, pod, BY_RULE);
            for (int move = 0; move < MOVES; move++) {
                double worth = worth(race, pods, pod, move);
                if (worth > most) {
                    most = worth;
                    best = move;
                }
            }
            return best;
        }

        /** Returns how far a move brings a pod: the sum over all turns, so that earlier progress counts more. */
        private double worth(Race race, Pods pods, int pod, int move) {
            alone.clear();
            alone.add(pods, pod);
            double worth = 0;
            for (int turn = 0; turn < TURNS; turn++) {
                command(race, alone, 0, turn < MOVE_TURNS ? move : BY_RULE, trial);
                forecast.turn(alone, trial);
                worth += alone.progress(race, 0);
            }
            return worth;
        }

        private static void command(Race race, Pods pods, int pod, int move, Commands commands) {
            if (move == BY_RULE) {
                Regular.AgainstDrift.drive(race, pods, pod, commands);
            } else {
                int thrust = move % 2 == 0 ? race.maximumThrust : 0;
                commands.turn(pods, pod, COSINES[move / 2], SINES[move / 2], thrust);
            }
        }
    }
}

package steward.bots;

import java.io.IOException;

/**
 * One step above {@link Regular}, by one idea: it tries before it decides. It plays what {@link Regular} would do
 * forward with a {@link Forecast}, and six times more with another first move, and takes what brings the pod farthest.
 *
 * <p>Where it ends: the forecast holds one pod alone, so it foresees walls but no other pod; nobody stands in an
 * enemy's way, and shield and boost are never used. {@link Veteran} does all this.
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

    /** The decision: for each pod 7 times 12 turns of the forecast, whatever the race, so that an answer is quick. */
    static final class OneMoveAhead implements Strategy {

        /** The move that is no move: drive as {@link Regular} from the first turn on. */
        private static final int BY_RULE = -1;
        /** Moves 0 to 5: to the left, straight on, to the right, each with full thrust and without. */
        private static final double[] COSINES = {Forecast.TURN_COSINE, 1, Forecast.TURN_COSINE};
        private static final double[] SINES = {-Forecast.TURN_SINE, 0, Forecast.TURN_SINE};
        private static final int MOVES = 2 * COSINES.length;
        /** For how many turns a move is made before the rule takes over. */
        private static final int MOVE_TURNS = 3;
        /** How many turns are played. */
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

        /** How far a move brings a pod: the sum over all turns, so that sooner is better. */
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

package steward.game.podrace.simulator;

import java.util.Arrays;
import java.util.Objects;
import steward.game.podrace.RulesEdition;

/**
 * Many independent official pod races of four pods on one map, played together: one call plays a turn of every game.
 * Every bit is that of {@link PodRaceSimulator}, game by game. For search programs, training and ratings.
 *
 * <p>The numbers of a game are adjacent in memory; one kernel plays game after game. Tried and rejected: one array per
 * quantity with loops over games without branches, which compilers can turn into vector instructions. Hotspot 17 did so
 * for some of the loops only, and the whole was slower.
 *
 * <p>Allocates nothing in a turn. Not thread-safe; all cores are used by {@link ParallelBatch}.
 */
public final class PodRaceBatch {

    private static final int PODS = 4;
    private static final int PLAYERS = 2;
    private static final int LAPS = 3;
    private static final int MOST_GAMES = 100_000_000;

    private final double[][] checkpoints;
    private final RulesEdition rules;
    private final PodRaceSimulator start;
    private final double[][] states;
    private final int[][] counts;
    private final PodTurn turn;

    /** Commands for all pods of all games. A command stays until another is set. */
    public static final class Commands {

        private final double[] targetX;
        private final double[] targetY;
        private final int[] thrust;

        /**
         * No commands.
         *
         * @param games number of games, 1..100,000,000
         * @throws IllegalArgumentException if the number is out of range
         */
        public Commands(int games) {
            checkGames(games);
            targetX = new double[PODS * games];
            targetY = new double[PODS * games];
            thrust = new int[PODS * games];
            Arrays.fill(thrust, PodCommands.NO_COMMAND);
        }

        /**
         * Sets a command as {@link PodCommands#set} does.
         *
         * @param game index of the game, from 0
         * @param pod  index of the pod, 0..3
         * @throws IllegalArgumentException  if the target is not finite or the thrust out of range
         * @throws IndexOutOfBoundsException if there is no such game or pod
         */
        public void set(int game, int pod, double podTargetX, double podTargetY, int podThrust) {
            Objects.checkIndex(game, thrust.length / PODS);
            Objects.checkIndex(pod, PODS);
            PodCommands.check(pod, podTargetX, podTargetY, podThrust);
            int at = PODS * game + pod;
            targetX[at] = podTargetX;
            targetY[at] = podTargetY;
            thrust[at] = podThrust;
        }

        /**
         * Sets a command as {@link PodCommands#turn} does.
         *
         * @param game index of the game, from 0
         * @param pod  index of the pod, 0..3
         * @throws IllegalArgumentException  if the degrees are NaN or the thrust is out of range
         * @throws IndexOutOfBoundsException if there is no such game or pod
         */
        public void turn(int game, int pod, double degrees, int podThrust) {
            Objects.checkIndex(game, thrust.length / PODS);
            Objects.checkIndex(pod, PODS);
            PodCommands.checkTurn(pod, degrees, podThrust);
            int at = PODS * game + pod;
            targetX[at] = PodCommands.limited(degrees);
            targetY[at] = Double.NaN;
            thrust[at] = podThrust;
        }
    }

    /**
     * Games at the start.
     *
     * @param checkpoints as for {@link PodRaceSimulator#PodRaceSimulator(double[][])}
     * @param games       number of games, 1..100,000,000
     * @throws IllegalArgumentException if the number is out of range, and as there
     */
    public PodRaceBatch(double[][] checkpoints, int games) {
        this(checkpoints, games, RulesEdition.LIVE);
    }

    /**
     * Games at the start, under another edition of the rules.
     *
     * @throws IllegalArgumentException as above
     */
    public PodRaceBatch(double[][] checkpoints, int games, RulesEdition rules) {
        checkGames(games);
        this.rules = rules;
        start = new PodRaceSimulator(checkpoints, PLAYERS, PODS / PLAYERS, LAPS, rules);
        this.checkpoints = Arrays.stream(checkpoints).map(double[]::clone).toArray(double[][]::new);
        states = new double[games][PodTurn.NUMBERS * PODS];
        counts = new int[games][PodTurn.COUNTS * PODS + PLAYERS];
        turn = kernel();
        for (int game = 0; game < games; game++) {
            set(game, start);
        }
    }

    private static void checkGames(int games) {
        if (games < 1 || games > MOST_GAMES) {
            throw new IllegalArgumentException(games + " games, expected 1.." + MOST_GAMES);
        }
    }

    /** The working memory of one thread. */
    PodTurn kernel() {
        return new PodTurn(checkpoints, PODS, PODS / PLAYERS, LAPS, rules);
    }

    public int games() {
        return states.length;
    }

    /**
     * Plays a turn of every game.
     *
     * @throws IllegalArgumentException if the commands are for another number of games
     */
    public void play(Commands commands) {
        check(commands);
        play(commands, turn, 0, states.length);
    }

    void check(Commands commands) {
        if (commands.thrust.length != PODS * states.length) {
            throw new IllegalArgumentException("commands for " + commands.thrust.length / PODS + " games, expected "
                + states.length);
        }
    }

    /** Plays a turn of the games from {@code first} up to, without, {@code end}. */
    void play(Commands commands, PodTurn kernel, int first, int end) {
        for (int game = first; game < end; game++) {
            kernel.play(states[game], counts[game], commands.targetX, commands.targetY, commands.thrust, PODS * game);
        }
    }

    /**
     * Sets a game to the state of a race on the same map.
     *
     * @throws IllegalArgumentException if its number of pods, players or checkpoints differs
     */
    public void set(int game, PodRaceSimulator from) {
        start.checkAlike(from);
        from.copyTo(states[game], counts[game]);
    }

    /**
     * Sets a race on the same map to the state of a game.
     *
     * @throws IllegalArgumentException if its number of pods, players or checkpoints differs
     */
    public void get(int game, PodRaceSimulator to) {
        start.checkAlike(to);
        to.copyFrom(states[game], counts[game]);
    }

    /** The x coordinate of a pod, in u. */
    public double x(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.X];
    }

    /** The y coordinate of a pod, in u. */
    public double y(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.Y];
    }

    /** The velocity of a pod to the right, in u per turn. */
    public double vx(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.VX];
    }

    /** The velocity of a pod downwards, in u per turn. */
    public double vy(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.VY];
    }

    /** The number of checkpoints that a pod has passed since the start. */
    public int passed(int game, int pod) {
        return counts[game][PodTurn.COUNTS * pod + PodTurn.PASSED];
    }

    /** Number of the checkpoint that a pod must pass next. */
    public int nextCheckpoint(int game, int pod) {
        return counts[game][PodTurn.COUNTS * pod + PodTurn.NEXT];
    }

    /** The distance of a pod from the centre of its next checkpoint, in u. */
    public double toNext(int game, int pod) {
        double[] next = checkpoints[nextCheckpoint(game, pod)];
        double dx = next[0] - x(game, pod);
        double dy = next[1] - y(game, pod);
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** The number of turns that the player has left to pass a checkpoint. */
    public int turnsLeft(int game, int player) {
        return counts[game][PodTurn.COUNTS * PODS + Objects.checkIndex(player, PLAYERS)];
    }
}

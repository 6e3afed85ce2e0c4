package steward.game.podrace;

import java.util.Arrays;

/**
 * Many independent official pod races of four pods on one map, played together: one call plays a turn of every game.
 * Every bit is that of {@link PodRaceSimulator}, game by game. For search over many lines, training and ratings.
 *
 * <p>A game's numbers lie side by side; one kernel goes over them, so that a game costs no more
 * than its turn. Tried and not taken: one array per quantity with loops over games without branches, which compilers
 * can turn into vector instructions. Hotspot 17 did so for some of the loops only, and the whole was slower.
 *
 * <p>Allocates nothing in a turn. Not thread-safe; all cores are used by {@link ParallelBatch}.
 */
public final class PodRaceBatch {

    private static final int PODS = 4;
    private static final int PLAYERS = 2;
    private static final int LAPS = 3;

    private final double[][] checkpoints;
    private final double[][] states;
    private final int[][] counts;
    private final PodTurn turn;

    /** Commands for all pods of all games. */
    public static final class Commands {

        private final double[] targetX;
        private final double[] targetY;
        private final int[] thrust;

        /** No commands. */
        public Commands(int games) {
            targetX = new double[PODS * games];
            targetY = new double[PODS * games];
            thrust = new int[PODS * games];
            Arrays.fill(thrust, PodCommands.NO_COMMAND);
        }

        /** As {@link PodCommands#set}. */
        public void set(int game, int pod, double podTargetX, double podTargetY, int podThrust) {
            int at = PODS * game + pod;
            targetX[at] = podTargetX;
            targetY[at] = podTargetY;
            thrust[at] = podThrust;
        }
    }

    /**
     * Games at the start.
     *
     * @param checkpoints {@code [n][x, y]}, n at least 2
     * @param games       at least 1
     * @throws IllegalArgumentException if there are too few
     */
    public PodRaceBatch(double[][] checkpoints, int games) {
        if (games < 1) {
            throw new IllegalArgumentException(games + " games, expected at least 1");
        }
        PodRaceSimulator start = new PodRaceSimulator(checkpoints);
        this.checkpoints = checkpoints;
        states = new double[games][PodTurn.NUMBERS * PODS];
        counts = new int[games][PodTurn.COUNTS * PODS + PLAYERS];
        turn = kernel();
        for (int game = 0; game < games; game++) {
            set(game, start);
        }
    }

    /** What one thread needs to play. */
    PodTurn kernel() {
        return new PodTurn(checkpoints, PODS, PODS / PLAYERS, LAPS);
    }

    /** How many games there are. */
    public int games() {
        return states.length;
    }

    /** Plays a turn of every game. */
    public void play(Commands commands) {
        play(commands, turn, 0, states.length);
    }

    /** Plays a turn of the games from {@code first} up to, without, {@code end}. */
    void play(Commands commands, PodTurn kernel, int first, int end) {
        for (int game = first; game < end; game++) {
            kernel.play(states[game], counts[game], commands.targetX, commands.targetY, commands.thrust, PODS * game);
        }
    }

    /** Puts a game into the state of a race on the same map. */
    public void set(int game, PodRaceSimulator from) {
        from.copyTo(states[game], counts[game]);
    }

    /** Puts a race on the same map into the state of a game. */
    public void get(int game, PodRaceSimulator to) {
        to.copyFrom(states[game], counts[game]);
    }

    public double x(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.X];
    }

    public double y(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.Y];
    }

    public double vx(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.VX];
    }

    public double vy(int game, int pod) {
        return states[game][PodTurn.NUMBERS * pod + PodTurn.VY];
    }

    /** How many checkpoints a pod has passed since the start. */
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

    /** How many turns the player has left to pass a checkpoint. */
    public int turnsLeft(int game, int player) {
        return counts[game][PodTurn.COUNTS * PODS + player];
    }
}

package steward.game.podrace.simulator;

import java.util.Arrays;
import java.util.Objects;
import steward.game.podrace.Headings;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.RulesEdition;
import steward.game.podrace.StartPlaces;
import steward.numerics.SineCosine;
import steward.physics.TurnLog;
import steward.physics.event.OfficialAdvance;

/**
 * Simulator of the official pod race for search programs: states are set and copied, turns are played, nothing is
 * allocated. Every bit is that of {@link PodRace} on the scene {@code mad-pod-racing}: positions, speeds, headings,
 * timers, checkpoints and, if recorded, impacts. The rules are those of the live server unless others are asked for.
 *
 * <pre>{@code
 * PodRaceSimulator now = new PodRaceSimulator(checkpoints), trial = new PodRaceSimulator(checkpoints);
 * PodCommands commands = new PodCommands(4);
 * now.setPod(0, x, y, vx, vy, Math.toRadians(headingDegrees), shieldTimer, boostLeft, passed);   // and pods 1..3
 * trial.copyFrom(now);
 * commands.set(0, targetX, targetY, 200);                                                        // and pods 1..3
 * trial.play(commands);
 * double worth = 50_000.0 * trial.passed(0) - trial.toNext(0);
 * }</pre>
 *
 * <p>Not simulated: elimination, the end of a race, marks; checkpoints are counted on behind the finish. A bot sees
 * headings as degrees and knows neither the shield timers nor the boosts of others. Degrees converted with {@code
 * Math.toRadians} are the referee's radians except for the last digits (and for whole turns, which do not matter): the
 * next positions differ in about one pod-turn of a million. Bots with the line protocol see whole degrees; they should
 * set a heading once and then simulate their own commands.
 *
 * <p>Caveat: far outside of any map, from about 2^36 u on, the push-out of touching pods is lost in the rounding of
 * their places, so that they react until the turn reaches its bound on impacts, 10,000 and 1,000 per pod, and takes
 * that much longer than a usual turn. A search program that sets such states should look at the places first.
 *
 * <p>Sources of the rules as in {@link PodRace}. Not thread-safe: one instance, one thread.
 */
public final class PodRaceSimulator {

    /** The maximum number of pods in a race. */
    public static final int MOST_PODS = OfficialAdvance.MOST_BODIES;

    /**
     * The greatest coordinate (u) and speed (u per turn) that can be set, in magnitude. Far below it turns may already
     * take long, see above.
     */
    public static final double GREATEST = 0x1p200;

    /** The distance of the targets that stand for a command by angle, in u. */
    private static final double FAR = 100_000_000;

    private static final int LAPS = 3;
    private static final int MOST_LAPS = 1000;
    private static final int MOST_PASSED = 1_000_000;

    private final int pods;
    private final int perPlayer;
    private final int checkpoints;
    private final PodTurn turn;
    private final double[] state;
    private final SineCosine aim = new SineCosine();
    private final int[] counts;

    /**
     * Four pods, those of player 0 first, three laps; pods stand at the start places, headings unset.
     *
     * @param checkpoints {@code [n][x, y]} in u, n at least 2; copied
     * @throws IllegalArgumentException if there are too few, a number is not finite or above {@link #GREATEST}, or the
     *                                  first two are in one place
     */
    public PodRaceSimulator(double[][] checkpoints) {
        this(checkpoints, 2, 2, LAPS);
    }

    /**
     * A race with other numbers of players, pods and laps.
     *
     * @param checkpoints   as above
     * @param players       1 or more
     * @param podsPerPlayer 1 or more; at most {@link #MOST_PODS} pods together
     * @param laps          1..1,000
     * @throws IllegalArgumentException as above, and if a number is out of range
     */
    public PodRaceSimulator(double[][] checkpoints, int players, int podsPerPlayer, int laps) {
        this(checkpoints, players, podsPerPlayer, laps, RulesEdition.LIVE);
    }

    /**
     * A race under another edition of the rules.
     *
     * @throws IllegalArgumentException as above
     */
    public PodRaceSimulator(double[][] checkpoints, int players, int podsPerPlayer, int laps, RulesEdition rules) {
        checkMap(checkpoints);
        require(players >= 1 && podsPerPlayer >= 1 && (long) players * podsPerPlayer <= MOST_PODS,
            players + " players with " + podsPerPlayer + " pods, expected at least one of each and at most " + MOST_PODS
            + " pods together");
        require(laps >= 1 && laps <= MOST_LAPS, laps + " laps, expected 1.." + MOST_LAPS);
        pods = players * podsPerPlayer;
        perPlayer = podsPerPlayer;
        this.checkpoints = checkpoints.length;
        turn = new PodTurn(checkpoints, pods, podsPerPlayer, laps, rules);
        state = new double[PodTurn.NUMBERS * pods];
        counts = new int[PodTurn.COUNTS * pods + players];
        double[][] places = StartPlaces.of(checkpoints, pods);
        for (int pod = 0; pod < pods; pod++) {
            setPod(pod, places[pod][0], places[pod][1], 0, 0, Double.NaN, 0, true, 0);
        }
        Arrays.fill(counts, PodTurn.COUNTS * pods, counts.length, PodTurn.TURNS_WITHOUT_CHECKPOINT);
    }

    private static void checkMap(double[][] checkpoints) {
        require(checkpoints.length >= 2, checkpoints.length + " checkpoints, expected at least 2");
        for (int k = 0; k < checkpoints.length; k++) {
            double[] place = checkpoints[k];
            require(place.length == 2 && isPlayable(place[0]) && isPlayable(place[1]), "checkpoint " + k + ": "
                + Arrays.toString(place) + ", expected x and y of at most " + GREATEST);
        }
        require(checkpoints[0][0] != checkpoints[1][0] || checkpoints[0][1] != checkpoints[1][1],
            "checkpoints 0 and 1 are in the same place, expected two places: pods start across them");
    }

    /** False for NaN too. */
    private static boolean isPlayable(double value) {
        return Math.abs(value) <= GREATEST;
    }

    private static void require(boolean fulfilled, String problem) {
        if (!fulfilled) {
            throw new IllegalArgumentException(problem);
        }
    }

    /**
     * Sets the state of a pod. Whole numbers are usual; others are played as {@link PodRace} would. The turns left of
     * the player do not change.
     *
     * @param x         in u, of at most {@link #GREATEST} in magnitude
     * @param y         in u, likewise
     * @param vx        in u per turn, likewise
     * @param vy        in u per turn, likewise
     * @param heading   in radians, NaN while unset
     * @param podTimer  4 after the turn the shield was raised, counting down to 0; at 4 the pod weighs 10 until its
     *                  next command
     * @param podPassed checkpoints passed since the start, 0..1,000,000; the next is number
     *                  {@code (podPassed + 1) % n}
     * @throws IllegalArgumentException  if a number is out of range; then the state is unchanged
     * @throws IndexOutOfBoundsException if there is no such pod
     */
    public void setPod(int pod, double x, double y, double vx, double vy, double heading, int podTimer,
                       boolean podBoostLeft, int podPassed) {
        Objects.checkIndex(pod, pods);
        if (Double.isInfinite(heading)) {
            throw wrong(pod, "heading " + heading + ", expected finite or NaN");
        }
        if (podTimer < 0 || podTimer > PodRaceSettings.SHIELD_TURNS) {
            throw wrong(pod, "shield timer " + podTimer + ", expected 0.." + PodRaceSettings.SHIELD_TURNS);
        }
        if (podPassed < 0 || podPassed > MOST_PASSED) {
            throw wrong(pod, "passed " + podPassed + ", expected 0.." + MOST_PASSED);
        }
        if (!(isPlayable(x) && isPlayable(y) && isPlayable(vx) && isPlayable(vy))) {
            throw wrong(pod, "place " + x + " " + y + ", speed " + vx + " " + vy + ", expected magnitudes of at most "
                + GREATEST);
        }
        int at = PodTurn.NUMBERS * pod;
        state[at + PodTurn.X] = x;
        state[at + PodTurn.Y] = y;
        state[at + PodTurn.VX] = vx;
        state[at + PodTurn.VY] = vy;
        turn.setHeading(state, pod, heading);
        at = PodTurn.COUNTS * pod;
        counts[at + PodTurn.TIMER] = podTimer == PodRaceSettings.SHIELD_TURNS ? podTimer + PodTurn.HEAVY : podTimer;
        counts[at + PodTurn.BOOST] = podBoostLeft ? 1 : 0;
        counts[at + PodTurn.PASSED] = podPassed;
        counts[at + PodTurn.NEXT] = (podPassed + 1) % checkpoints;
    }

    private static IllegalArgumentException wrong(int pod, String problem) {
        return new IllegalArgumentException("pod " + pod + ": " + problem);
    }

    /**
     * Sets the number of turns that a player has left without a checkpoint: at the start 100.
     *
     * @param turns how many turns the player has left to pass a checkpoint
     * @throws IndexOutOfBoundsException if there is no such player
     */
    public void setTurnsLeft(int player, int turns) {
        Objects.checkIndex(player, pods / perPlayer);
        counts[PodTurn.COUNTS * pods + player] = turns;
    }

    /** Sets whether {@link #log()} records the impacts and corners of the next turns; at first it does not. */
    public void setRecorded(boolean wanted) {
        turn.record(wanted);
    }

    /**
     * Copies another race on the same map, without its log. Another map with the same number of checkpoints is not
     * detected: the pods then race on the map of this one.
     *
     * @throws IllegalArgumentException if the numbers of pods, players or checkpoints differ
     */
    public void copyFrom(PodRaceSimulator other) {
        if (pods != other.pods || perPlayer != other.perPlayer || checkpoints != other.checkpoints) {
            throw new IllegalArgumentException(other.words() + ", expected " + words());
        }
        System.arraycopy(other.state, 0, state, 0, state.length);
        System.arraycopy(other.counts, 0, counts, 0, counts.length);
    }

    private String words() {
        return "a race of " + pods + " pods, " + perPlayer + " per player, with " + checkpoints + " checkpoints";
    }

    /**
     * Plays one turn. The commands stay as they are.
     *
     * @throws IllegalArgumentException if they are for another number of pods
     */
    public void play(PodCommands commands) {
        if (commands.thrust.length != pods) {
            throw new IllegalArgumentException("commands for " + commands.pods() + " pods, expected " + pods);
        }
        turn.play(state, counts, commands.targetX, commands.targetY, commands.thrust);
    }

    public int pods() {
        return pods;
    }

    public int playerOf(int pod) {
        return pod / perPlayer;
    }

    /** The x coordinate of a pod, in u: whole after a turn. */
    public double x(int pod) {
        return state[PodTurn.NUMBERS * pod + PodTurn.X];
    }

    /** The y coordinate of a pod, in u: whole after a turn. */
    public double y(int pod) {
        return state[PodTurn.NUMBERS * pod + PodTurn.Y];
    }

    /** The velocity of a pod to the right, in u per turn: whole after a turn. */
    public double vx(int pod) {
        return state[PodTurn.NUMBERS * pod + PodTurn.VX];
    }

    /** The velocity of a pod downwards, in u per turn: whole after a turn. */
    public double vy(int pod) {
        return state[PodTurn.NUMBERS * pod + PodTurn.VY];
    }

    /**
     * The exact heading in radians, not normalised; NaN while unset. It may have to be computed, which takes about 10
     * ns.
     */
    public double heading(int pod) {
        return Headings.angle(state, PodTurn.NUMBERS * pod + PodTurn.HEADING);
    }

    /**
     * The x component of the direction in which a pod heads, accurate to 1e-11; NaN while unset, and from 512 radians
     * on. Needs no computation.
     */
    public double directionX(int pod) {
        return state[PodTurn.NUMBERS * pod + PodTurn.HEADING];
    }

    /** The y component of the direction in which a pod heads, see {@link #directionX}. */
    public double directionY(int pod) {
        return state[PodTurn.NUMBERS * pod + PodTurn.HEADING + 1];
    }

    /**
     * The x coordinate of a target that makes a pod of a real race, in this state, turn as
     * {@link PodCommands#turn(int, double, int)} does. For 18 degrees and more to either side, the target is 90 degrees
     * aside and the turn is the same to the last bit. For less, it is 100,000,000 u away in the direction wanted; as it
     * is rounded to whole numbers, of at most nine digits on a map of the usual size, the direction is off by less than
     * 1e-8 radians, and the next positions differ in a few pod-turns of a million. The own position while the heading
     * is unset. Not for search: computes an angle.
     *
     * @param pod     whose position is below 2^50 u and whose heading is below 1e12 radians; a heading from 1e16 on
     *                changes by more than a turn between two doubles, and no target is aside
     * @param degrees as for {@link PodCommands#turn}
     * @return in u
     * @throws IllegalArgumentException if the degrees are NaN
     */
    public long targetX(int pod, double degrees) {
        aim(pod, degrees);
        return Math.round(x(pod) + (isUnset(pod) ? 0 : FAR * aim.cos()));
    }

    /** The y coordinate of the target, see {@link #targetX(int, double)}. */
    public long targetY(int pod, double degrees) {
        aim(pod, degrees);
        return Math.round(y(pod) + (isUnset(pod) ? 0 : FAR * aim.sin()));
    }

    private boolean isUnset(int pod) {
        return Headings.isUnset(state, PodTurn.NUMBERS * pod + PodTurn.HEADING);
    }

    /** Computes the direction in which the target is. */
    private void aim(int pod, double degrees) {
        if (Double.isNaN(degrees)) {
            throw wrong(pod, "turn by NaN degrees, expected a number");
        }
        boolean full = Math.abs(degrees) >= PodCommands.GREATEST_TURN;
        double aside = full ? Math.copySign(Math.PI / 2, degrees) : Math.toRadians(degrees);
        aim.turn(heading(pod) % (2 * Math.PI) + aside);
    }

    /** 4 after the turn the shield was raised, counting down to 0. */
    public int shieldTimer(int pod) {
        return counts[PodTurn.COUNTS * pod + PodTurn.TIMER] & PodTurn.TIMER_BITS;
    }

    public boolean boostLeft(int pod) {
        return counts[PodTurn.COUNTS * pod + PodTurn.BOOST] != 0;
    }

    /** The number of checkpoints that a pod has passed since the start. */
    public int passed(int pod) {
        return counts[PodTurn.COUNTS * pod + PodTurn.PASSED];
    }

    /** The number of checkpoints of the whole race. */
    public int toFinish() {
        return turn.toFinish();
    }

    /** Number of the checkpoint that a pod must pass next. */
    public int nextCheckpoint(int pod) {
        return counts[PodTurn.COUNTS * pod + PodTurn.NEXT];
    }

    /** The x coordinate of a checkpoint, in u. */
    public double checkpointX(int checkpoint) {
        return turn.checkpointX(checkpoint);
    }

    /** The y coordinate of a checkpoint, in u. */
    public double checkpointY(int checkpoint) {
        return turn.checkpointY(checkpoint);
    }

    /** The distance of a pod from the centre of its next checkpoint, in u. */
    public double toNext(int pod) {
        int next = counts[PodTurn.COUNTS * pod + PodTurn.NEXT];
        double dx = turn.checkpointX(next) - state[PodTurn.NUMBERS * pod + PodTurn.X];
        double dy = turn.checkpointY(next) - state[PodTurn.NUMBERS * pod + PodTurn.Y];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /**
     * The number of turns that the player has left to pass a checkpoint; a race by live rules eliminates a player at
     * -1, by those of the contest at 0.
     */
    public int turnsLeft(int player) {
        return counts[PodTurn.COUNTS * pods + player];
    }

    /** Impacts and corners of the last turn, if they are recorded. */
    public TurnLog log() {
        return turn.log();
    }
}

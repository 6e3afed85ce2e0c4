package steward.game.podrace.simulator;

import steward.game.podrace.Headings;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.RulesEdition;
import steward.physics.Bodies;
import steward.physics.TurnLog;
import steward.physics.event.FarPairs;
import steward.physics.event.OfficialAdvance;

/**
 * Fast kernel of the official turn, for {@link PodRaceSimulator} and for matches. Pods are steered by certified vectors
 * ({@link Headings}). In a turn in which no pair can meet they fly straight to their rounded ends, otherwise through
 * certified impacts ({@link CertifiedImpacts}), unless impacts are recorded. If a decision or a rounding is in doubt,
 * the game's own expressions are evaluated. States are in arrays of the caller; this class holds the working memory of
 * a turn. Allocates nothing. Not thread-safe.
 *
 * <p>A turn without impacts takes most of its time for steering, then for gliding; a turn with impacts takes longer.
 * Tried and rejected, because measured no faster: a box around the checkpoint before its quadratic; one sum instead of
 * the four bounds on position and speed; iterating over the set bits of the pods that glide; writing the base of a
 * heading to one of two places instead of taking one of two values (slower: later loads wait for the address); steering
 * and gliding in one loop. A more precise filter of pairs would gain nothing: the pairs that it keeps nearly always
 * meet.
 *
 * <p>One file of about 490 lines, because all of it works on the same arrays.
 */
final class PodTurn {

    static final double RADIUS = 400;
    static final double CHECKPOINT_RADIUS = 600;
    static final double CHECKPOINT_SQUARE = CHECKPOINT_RADIUS * CHECKPOINT_RADIUS;
    static final double DRAG = 0.15;
    static final double KEEP = 1 - DRAG;
    static final int MAXIMUM_THRUST = 200;
    static final int TURNS_WITHOUT_CHECKPOINT = 100;

    /** Shield timers: masses are 1 and 10. */
    static final double SHIELD_MASS = PodRaceSettings.SHIELD_MASS_FACTOR;

    /*
     * When a certified vector suffices. A pod below SMALL in each coordinate and speed is steered by a vector accurate
     * to 2^-37; times a thrust of at most 650 that is 2^-27.6 for the speed, and with the roundings of both
     * computations (2^-39 for the speed; 2^-37 for the position) less than 2^-27 for the speed and for the position at
     * the end. A drag's product adds 2^-39. So when the fraction to be truncated or rounded is farther than DOUBT from
     * where the result changes, the result is the game's. Otherwise, or when pairs may meet, the game's own direction
     * is computed.
     */
    static final double SMALL = 0x1p15;
    static final double DOUBT = 0x1p-26;

    /** Offsets per pod in {@link #state}: position, velocity, heading. */
    static final int X = 0;
    static final int Y = 1;
    static final int VX = 2;
    static final int VY = 3;
    static final int HEADING = 4;
    static final int NUMBERS = HEADING + Headings.NUMBERS;
    /** Offsets per pod in {@link #counts}; after the pods, per player, the turns left. */
    static final int TIMER = 0;
    /** The timer stands in these bits of its count; above them whether the last command was a shield. */
    static final int TIMER_BITS = (1 << 30) - 1;
    static final int HEAVY = 1 << 30;
    static final int BOOST = 1;
    static final int PASSED = 2;
    static final int NEXT = 3;
    static final int COUNTS = 4;
    /** Offsets per pod in {@link #speed}: the position before, the velocity, and these. */
    private static final int POWER = 4;
    private static final int MASS = 5;
    static final int SPEED = 6;

    private final int pods;
    private final int perPlayer;
    private final int checkpoints;
    private final int toFinish;
    private final double[] checkpointX;
    private final double[] checkpointY;
    private final OfficialAdvance advance;
    private final Headings headings = new Headings();
    private final TurnLog log;
    private final PodPaths paths;
    private final CertifiedImpacts impacts;
    /** The pods of a turn with impacts. */
    private final Bodies bodies;
    /** Per pod: the position before, the velocity in this turn, the thrust if by a certified vector, and the mass. */
    private final double[] speed;

    /** The pairs that could meet in the last turn. */
    private long near;

    /** The pods with certified impacts that pass a checkpoint, as bits. */
    private int passing;

    /** The states of the game being played. */
    private double[] state;
    private int[] counts;

    PodTurn(double[][] checkpoints, int pods, int perPlayer, int laps, RulesEdition rules) {
        this(checkpoints, pods, perPlayer, laps, rules, new OfficialAdvance(RADIUS), new TurnLog(TurnLog.RECORDED));
    }

    /** @param log receives the impacts that are recorded */
    PodTurn(double[][] checkpoints, int pods, int perPlayer, int laps, RulesEdition rules, OfficialAdvance advance,
            TurnLog log) {
        this.pods = pods;
        this.log = log;
        this.advance = advance;
        advance.setRadius(RADIUS);
        this.perPlayer = perPlayer;
        this.checkpoints = checkpoints.length;
        toFinish = laps * checkpoints.length;
        checkpointX = new double[checkpoints.length];
        checkpointY = new double[checkpoints.length];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpointX[k] = checkpoints[k][0];
            checkpointY[k] = checkpoints[k][1];
        }
        bodies = new Bodies(pods);
        paths = new PodPaths(pods, log, CHECKPOINT_RADIUS, rules);
        impacts = new CertifiedImpacts(pods, paths);
        speed = new double[SPEED * pods];
        for (int pod = 0; pod < pods; pod++) {
            bodies.setDrag(bodies.add(0, 0, RADIUS, 1), DRAG);
        }
    }

    TurnLog log() {
        return log;
    }

    void record(boolean wanted) {
        paths.record(wanted);
        log.clear();
    }

    /**
     * Adds the impacts of the last turn, which was not recorded, to the log. The state has to be as it was after that
     * turn, but with the velocities before it, and is as after it then.
     */
    void recordLast() {
        if (near != 0) {
            paths.record(true);
            paths.clear();
            collide();
            paths.record(false);
        }
    }

    /** True if the path of a pod in the last turn passes a checkpoint. */
    boolean passes(int pod, double x, double y) {
        return paths.passes(pod, speed[SPEED * pod + X], speed[SPEED * pod + Y], state[NUMBERS * pod + X],
            state[NUMBERS * pod + Y], x, y);
    }

    int toFinish() {
        return toFinish;
    }

    double checkpointX(int checkpoint) {
        return checkpointX[checkpoint];
    }

    double checkpointY(int checkpoint) {
        return checkpointY[checkpoint];
    }

    /** Sets the heading of a pod to an angle in radians, NaN for unset. */
    void setHeading(double[] to, int pod, double angle) {
        headings.set(to, NUMBERS * pod + HEADING, angle);
    }

    /** Plays one turn and counts checkpoints. @param numbers have also the turns left, per player; see {@link #move} */
    void play(double[] states, int[] numbers, double[] targetX, double[] targetY, int[] thrust) {
        int mayPass = move(states, numbers, targetX, targetY, thrust);
        int last = numbers.length;
        for (int player = COUNTS * pods; player < last; player++) {
            numbers[player]--;
        }
        if (mayPass != 0) {
            countCheckpoints(mayPass);
        }
    }

    /**
     * Plays the commands and the motion of one turn.
     *
     * @param states   {@link #NUMBERS} per pod, altered
     * @param numbers  {@link #COUNTS} per pod, altered
     * @param targetX  of a command by target; or the degrees of a command by angle
     * @param targetY  of a command by target; NaN for a command by angle: then no target can be steered to by vectors,
     *                 so that commands by target are not delayed by a question
     * @return the pods that may have passed their next checkpoint, as bits
     */
    int move(double[] states, int[] numbers, double[] targetX, double[] targetY, int[] thrust) {
        state = states;
        counts = numbers;
        steer(targetX, targetY, thrust);
        paths.clear();
        near = pods == 4 && PodPairFilter.allFar(speed, advance.reach()) ? 0
            : PodPairFilter.nearPairs(speed, pods, advance);
        return near == 0 ? glide(OfficialAdvance.ALL) : collide();
    }

    /** Applies headings and thrusts. Rare cases go to {@link #steerExactly}, so that values stay in registers here. */
    private void steer(double[] targetX, double[] targetY, int[] thrusts) {
        double[] from = state;
        double[] to = speed;
        int[] count = counts;
        int all = pods;
        for (int pod = 0; pod < all; pod++) {
            int at = NUMBERS * pod;
            int out = SPEED * pod;
            double x = from[at + X];
            double y = from[at + Y];
            double vx = from[at + VX];
            double vy = from[at + VY];
            int command = thrusts[pod];
            if (command >= 0 && Math.abs(x) < SMALL && Math.abs(y) < SMALL && Math.abs(vx) < SMALL
                && Math.abs(vy) < SMALL
                && (Headings.turnQuickly(from, at + HEADING, targetX[pod] - x, targetY[pod] - y)
                || Double.isNaN(targetY[pod])
                && Headings.turnByQuickly(from, at + HEADING, targetX[pod]))) {
                int timer = Math.max(0, (count[COUNTS * pod + TIMER] & TIMER_BITS) - 1);
                count[COUNTS * pod + TIMER] = timer;
                to[out + X] = x;
                to[out + Y] = y;
                to[out + MASS] = 1;
                double power = timer == 0 ? command : 0;
                to[out + POWER] = power;
                if (power != 0) {
                    vx += from[at + HEADING] * power;
                    vy += from[at + HEADING + 1] * power;
                }
                to[out + VX] = vx;
                to[out + VY] = vy;
            } else {
                steerExactly(pod, targetX[pod], targetY[pod], command);
            }
        }
    }

    /** Applies the command of any pod, with the game's own direction. */
    private void steerExactly(int pod, double targetX, double targetY, int command) {
        int at = NUMBERS * pod;
        int to = SPEED * pod;
        int before = counts[COUNTS * pod + TIMER];
        boolean heavy = command == PodCommands.SHIELD || command == PodCommands.NO_COMMAND && before > TIMER_BITS;
        int thrust = command < 0 ? special(pod, command) : command;
        int timer = Math.max(0, (counts[COUNTS * pod + TIMER] & TIMER_BITS) - 1);
        counts[COUNTS * pod + TIMER] = heavy ? timer + HEAVY : timer;
        System.arraycopy(state, at + X, speed, to + X, POWER);
        speed[to + MASS] = heavy ? SHIELD_MASS : 1;
        speed[to + POWER] = 0;
        if (command != PodCommands.NO_COMMAND && turnExactly(at, targetX, targetY)) {
            if (timer == 0 && thrust != 0) {
                speed[to + POWER] = thrust;
                pushExactly(pod);
            }
        }
    }

    /** @return whether there is a direction to steer to */
    private boolean turnExactly(int at, double targetX, double targetY) {
        if (Double.isNaN(targetY)) {
            headings.turnBy(state, at + HEADING, targetX);
            return !Headings.isUnset(state, at + HEADING);
        }
        double dx = targetX - state[at + X];
        double dy = targetY - state[at + Y];
        if (dx == 0 && dy == 0) {
            return false;
        }
        headings.turnTo(state, at + HEADING, dx, dy);
        return true;
    }

    /** Applies shield or boost. @return the thrust */
    private int special(int pod, int command) {
        int at = COUNTS * pod;
        if (command == PodCommands.SHIELD) {
            counts[at + TIMER] = PodRaceSettings.SHIELD_TURNS + 1;
        } else if (command == PodCommands.BOOST) {
            boolean left = counts[at + BOOST] != 0;
            counts[at + BOOST] = 0;
            return left ? PodRaceSettings.BOOST_THRUST : MAXIMUM_THRUST;
        }
        return 0;
    }

    /** Replaces certified speeds by the game's own. */
    private void pushExactly(int pod) {
        int at = NUMBERS * pod;
        int to = SPEED * pod;
        headings.direct(state, at + HEADING);
        speed[to + VX] = state[at + VX] + headings.directionX() * speed[to + POWER];
        speed[to + VY] = state[at + VY] + headings.directionY() * speed[to + POWER];
        speed[to + POWER] = 0;
    }

    /*
     * For each of the four fractions f to be truncated or rounded, f (1 - f) is at most 1/4; so when the product of the
     * four is above DOUBT / 64, each is above DOUBT, and so are f and 1 - f. A path longer than LONG is too long for
     * the filter of checkpoints; then everything is computed as the game does.
     */

    /**
     * The end of the turn for pods (bits) without impacts: free flight, drag, truncation, rounding.
     *
     * @return the pods that may have passed their next checkpoint, as bits
     */
    private int glide(int which) {
        double[] to = state;
        double[] from = speed;
        int mayPass = 0;
        for (int pod = 0; pod < pods; pod++) {
            if ((which >> pod & 1) == 0) {
                continue;
            }
            int at = NUMBERS * pod;
            int in = SPEED * pod;
            double startX = from[in + X];
            double startY = from[in + Y];
            double x = startX + from[in + VX] + 0.5;
            double y = startY + from[in + VY] + 0.5;
            double slowX = from[in + VX] * KEEP;
            double slowY = from[in + VY] * KEEP;
            double roundX = Math.floor(x);
            double roundY = Math.floor(y);
            int cutX = (int) slowX;
            int cutY = (int) slowY;
            double restX = x - roundX;
            double restY = y - roundY;
            double lostX = Math.abs(slowX - cutX);
            double lostY = Math.abs(slowY - cutY);
            double product = (restX - restX * restX) * (restY - restY * restY)
                * ((lostX - lostX * lostX) * (lostY - lostY * lostY));
            if (product > DOUBT / 64 && Math.abs(slowX) + Math.abs(slowY) < PodPaths.LONG / 2) {
                to[at + X] = roundX + 0.0;
                to[at + Y] = roundY + 0.0;
                to[at + VX] = cutX;
                to[at + VY] = cutY;
            } else {
                glideExactly(pod);
                mayPass |= 1 << pod;                  // the paths have a filter of their own
                continue;
            }
            int next = counts[COUNTS * pod + NEXT];
            if (FarPairs.mayMeet(startX - checkpointX[next], startY - checkpointY[next], to[at + X] - startX,
                to[at + Y] - startY, 1, CHECKPOINT_SQUARE)) {
                mayPass |= 1 << pod;
            }
        }
        return mayPass;
    }

    private void glideExactly(int pod) {
        int at = NUMBERS * pod;
        int to = SPEED * pod;
        if (speed[to + POWER] != 0) {
            pushExactly(pod);
        }
        state[at + X] = Math.floor(speed[to + X] + speed[to + VX] + 0.5) + 0.0;
        state[at + Y] = Math.floor(speed[to + Y] + speed[to + VY] + 0.5) + 0.0;
        state[at + VX] = cut(speed[to + VX] * KEEP);
        state[at + VY] = cut(speed[to + VY] * KEEP);
    }

    /** Truncates toward zero, never to -0.0. */
    private static double cut(double value) {
        if (Math.abs(value) < 0x1p31) {
            return (int) value;
        }
        return (value < 0 ? Math.ceil(value) : Math.floor(value)) + 0.0;
    }

    /**
     * The turn when some pairs may meet. Their pods get the game's own directions and speeds, then the game's event
     * loop is played; the other pods get them only if an impact sends a pod towards them.
     */
    private int collide() {
        if (!paths.areRecorded()) {
            if (flyCertified()) {
                int touched = impacts.touched();
                for (int rest = touched; rest != 0; rest &= rest - 1) {
                    int pod = Integer.numberOfTrailingZeros(rest);
                    int at = NUMBERS * pod;
                    state[at + X] = impacts.x(pod);
                    state[at + Y] = impacts.y(pod);
                    state[at + VX] = impacts.vx(pod);
                    state[at + VY] = impacts.vy(pod);
                }
                return passing | glide(~touched);
            }
            paths.clear();
        }
        int exact = advance.bodiesOf(near, pods);
        if (!collide(exact) || paths.knots() > CertainRounding.MOST_CORNERS
            || !CertainRounding.areSure(~exact, speed, pods)) {
            paths.clear();
            exact = OfficialAdvance.ALL;
            collide(exact);
        }
        for (int pod = 0; pod < pods; pod++) {
            if ((exact >> pod & 1) != 0) {
                int at = NUMBERS * pod;
                state[at + X] = Math.floor(bodies.x[pod] + 0.5) + 0.0;
                state[at + Y] = Math.floor(bodies.y[pod] + 0.5) + 0.0;
                state[at + VX] = cut(bodies.vx[pod] * KEEP);
                state[at + VY] = cut(bodies.vy[pod] * KEEP);
            }
        }
        return exact | glide(~exact);
    }

    /** True if the impacts of certified speeds, with all their results, are certified to be those of the game. */
    private boolean flyCertified() {
        for (int pod = 0; pod < pods; pod++) {
            int in = SPEED * pod;
            if (!impacts.set(pod, speed[in + X], speed[in + Y], speed[in + VX], speed[in + VY],
                speed[in + MASS] == 1 ? 1 : 1 / SHIELD_MASS)) {
                return false;
            }
        }
        if (!impacts.fly(near) || !CertainRounding.areSure(~impacts.touched(), speed, pods)) {
            return false;
        }
        passing = 0;
        for (int rest = impacts.touched(); rest != 0; rest &= rest - 1) {
            if (!isSureOfCheckpoints(Integer.numberOfTrailingZeros(rest))) {
                return false;
            }
        }
        return true;
    }

    private boolean isSureOfCheckpoints(int pod) {
        int next = counts[COUNTS * pod + NEXT];
        for (int passed = 0; passed < checkpoints; passed++) {
            double above = paths.nearest(pod, speed[SPEED * pod + X], speed[SPEED * pod + Y], impacts.x(pod),
                impacts.y(pod), checkpointX[next], checkpointY[next]) - CHECKPOINT_RADIUS;
            if (Math.abs(above) <= impacts.cornerError()) {
                return false;
            }
            if (above > 0) {
                return true;
            }
            passing |= 1 << pod;
            next = next + 1 < checkpoints ? next + 1 : 0;
        }
        return true;
    }

    private boolean collide(int exact) {
        for (int pod = 0; pod < pods; pod++) {
            int to = SPEED * pod;
            if (speed[to + POWER] != 0 && (exact >> pod & 1) != 0) {
                pushExactly(pod);
            }
            bodies.x[pod] = speed[to + X];
            bodies.y[pod] = speed[to + Y];
            bodies.vx[pod] = speed[to + VX];
            bodies.vy[pod] = speed[to + VY];
            bodies.mass[pod] = speed[to + MASS];
            bodies.inverseMass[pod] = speed[to + MASS] == 1 ? 1 : 1 / SHIELD_MASS;
        }
        return advance.turn(bodies, paths, near, exact);
    }

    /** @param mayPass the pods (bits) that may have passed a checkpoint */
    private void countCheckpoints(int mayPass) {
        for (int rest = mayPass & (1 << pods) - 1; rest != 0; rest &= rest - 1) {
            int pod = Integer.numberOfTrailingZeros(rest);
            if (pass(pod)) {
                counts[COUNTS * pods + pod / perPlayer] = TURNS_WITHOUT_CHECKPOINT;
            }
        }
    }

    /**
     * Counts the checkpoints on the path of a pod, on behind the finish too, each once at most.
     *
     * @return whether there is one
     */
    private boolean pass(int pod) {
        int at = COUNTS * pod;
        boolean any = false;
        int next = counts[at + NEXT];
        for (int most = checkpoints; most > 0 && passes(pod, checkpointX[next], checkpointY[next]); most--) {
            any = true;
            counts[at + PASSED]++;
            next = next + 1 < checkpoints ? next + 1 : 0;
            counts[at + NEXT] = next;
        }
        return any;
    }
}

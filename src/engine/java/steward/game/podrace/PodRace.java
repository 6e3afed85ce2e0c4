package steward.game.podrace;

import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import steward.Internal;
import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.numerics.SineCosine;
import steward.numerics.SplitMix64;
import steward.numerics.StrictAngles;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnLog;
import steward.scene.Bumper;
import steward.scene.Plan;
import steward.scene.Scene;

/**
 * Rules of the pod race, free of JSON. Pods are the bodies 0..pods-1 in the order of players; bumpers follow. Sources:
 * the published official referee and official recordings of 2016 and 2026; with the official law and arithmetic,
 * positions, speeds, headings, impact times and impulses agree with them to the last bit.
 *
 * <p>The pods of an eliminated player stay on the field: they get no commands, drift, and can be hit; a pod whose
 * shield was raised stays heavy. In a faulty answer, commands before the fault take effect in that turn.
 *
 * <p>Over 400 lines, because the steps of a turn belong together and half of the class are accessors for codecs.
 */
public final class PodRace extends AbstractGame {

    /** Pseudo-thrust of a pod whose player gave no command. */
    public static final int NO_COMMAND = -1;
    /** Pseudo-thrust of a SHIELD command. */
    public static final int SHIELD = -2;
    /** Pseudo-thrust of a BOOST command. */
    public static final int BOOST = -3;

    private final PodRaceSettings settings;
    private final Plan plan;
    private final double[][] checkpoints;
    private final List<IntFunction<String>> passTexts;
    private final Bodies bodies;
    private final Advance advance;
    /** Way to play a turn, {@code null} for the general one; then it has the headings. */
    private final TurnKernel kernel;
    /** Pods, as bits, whose {@link #heading} is to be taken from the kernel. */
    private int unread;
    /** True if the impacts of the last turn are to be taken from the kernel. */
    private boolean unlogged;
    private final Motion motion;
    private final SineCosine direction = new SineCosine();
    private final double reachOfPath;
    private final double reachOfEnd;
    private final RaceStanding standing = new RaceStanding(this);

    private final double[] heading;
    private final int[] shieldTimer;
    private final boolean[] boostLeft;
    private final int[] passed;
    private final double[] targetX;
    private final double[] targetY;
    private final int[] thrust;
    private final double[] startX;
    private final double[] startY;

    private final int[] turnsLeft;

    /**
     * A race before its first turn. Draws, in this order: the map, 0..maps-1; if the scene shifts, the first
     * checkpoint, 0..n-1; if it jitters, for each checkpoint in the shifted order x, then y, -jitter..jitter.
     */
    @Internal
    public PodRace(PodRaceSettings settings, Scene scene, Plan plan, long seed, TurnKernel.Choice kernels) {
        this(settings, scene, plan, settings.drawMap(new SplitMix64(seed)), plan.advance(null), kernels);
    }

    /** A race in the general way on a given map, {@code [n][x, y]}, with a given advance; copies have the plan's. */
    @Internal
    public PodRace(PodRaceSettings settings, Scene scene, Plan plan, double[][] checkpoints, Advance advance) {
        this(settings, scene, plan, checkpoints, advance, TurnKernel.Choice.NONE);
    }

    /** A race on a given map, {@code [n][x, y]}, with a given advance; copies have the plan's. */
    @Internal
    public PodRace(PodRaceSettings settings, Scene scene, Plan plan, double[][] checkpoints, Advance advance,
                   TurnKernel.Choice kernels) {
        super(settings.players());
        kernel = kernels.of(settings, scene, plan, checkpoints, advance, log);
        this.settings = settings;
        this.plan = plan;
        this.checkpoints = checkpoints;
        passTexts = passTexts();
        reachOfPath = settings.rules().reachOfPath(settings.checkpointRadius());
        reachOfEnd = settings.rules().reachOfEnd(settings.checkpointRadius());
        List<Bumper> bumpers = scene.field().map(field -> field.bumpers()).orElse(List.of());
        int pods = settings.pods();
        bodies = new Bodies(pods + bumpers.size());
        this.advance = advance;
        motion = plan.motion();
        heading = new double[pods];
        shieldTimer = new int[pods];
        boostLeft = new boolean[pods];
        passed = new int[pods];
        targetX = new double[pods];
        targetY = new double[pods];
        thrust = new int[pods];
        startX = new double[pods];
        startY = new double[pods];
        Arrays.fill(heading, Double.NaN);
        Arrays.fill(boostLeft, true);
        Arrays.fill(thrust, NO_COMMAND);
        turnsLeft = new int[settings.players()];
        Arrays.fill(turnsLeft, settings.turnsWithoutCheckpoint());
        placePods(scene.drag());
        for (Bumper bumper : bumpers) {
            int body = bodies.add(bumper.x(), bumper.y(), bumper.radius(), Double.POSITIVE_INFINITY);
            bodies.setRestitution(body, bumper.restitution());
        }
    }

    /** A copy of a race between two turns, with a way to advance of its own. */
    private PodRace(PodRace other, Advance advance) {
        super(other);
        kernel = other.kernel == null ? null : other.kernel.copy(advance, log);
        settings = other.settings;
        plan = other.plan;
        reachOfPath = other.reachOfPath;
        reachOfEnd = other.reachOfEnd;
        checkpoints = other.checkpoints;
        passTexts = other.passTexts;
        this.advance = advance;
        motion = other.motion;
        bodies = new Bodies(other.bodies.capacity());
        bodies.copyFrom(other.bodies);
        heading = new double[other.heading.length];
        for (int pod = 0; pod < heading.length; pod++) {
            heading[pod] = other.heading(pod);
        }
        shieldTimer = other.shieldTimer.clone();
        boostLeft = other.boostLeft.clone();
        passed = other.passed.clone();
        targetX = other.targetX.clone();
        targetY = other.targetY.clone();
        thrust = other.thrust.clone();
        startX = other.startX.clone();
        startY = other.startY.clone();
        turnsLeft = other.turnsLeft.clone();
    }

    @Override
    public PodRace copy() {
        return new PodRace(this, plan.advance(null));
    }

    private void placePods(double drag) {
        for (double[] place : StartPlaces.of(checkpoints, settings.pods())) {
            int body = bodies.add(place[0], place[1], settings.radius(), settings.mass());
            bodies.setRestitution(body, settings.restitution());
            bodies.setDrag(body, drag);
        }
    }

    /**
     * Gives a pod a command for the next turn.
     *
     * @param podThrust 0 to the scene's maximum, {@link #SHIELD} or {@link #BOOST}
     */
    public void command(int pod, double x, double y, int podThrust) {
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = podThrust;
    }

    @Override
    protected void playTurn() {
        int mayPass = kernel == null ? move() : moveQuickly();
        Arrays.fill(thrust, NO_COMMAND);
        for (int player = 0; player < settings.players(); player++) {
            if (isIn(player)) {
                countCheckpoints(player, mayPass);
            }
        }
        decideOutcome();
    }

    /** Steers and moves the pods in the general way. @return the pods that may have passed a checkpoint, as bits */
    private int move() {
        for (int pod = 0; pod < settings.pods(); pod++) {
            startX[pod] = bodies.x[pod];
            startY[pod] = bodies.y[pod];
            steer(pod, thrust[pod]);                        // lines before a bad one take effect
        }
        advance.turn(bodies, log);
        motion.endTurn(bodies);
        return -1;
    }

    /** The turn by the kernel; see {@link #move}. */
    private int moveQuickly() {
        unread = -1;
        unlogged = true;
        return kernel.play(bodies, targetX, targetY, thrust, shieldTimer, boostLeft, passed);
    }

    /**
     * Shield, boost, heading and thrust of one pod: step 1 of the official turn. A pod without a command keeps the mass
     * it had.
     *
     * @return the thrust that acts along the heading
     */
    private int steer(int pod, int command) {
        shieldTimer[pod] = command == SHIELD ? PodRaceSettings.SHIELD_TURNS : Math.max(0, shieldTimer[pod] - 1);
        if (command != NO_COMMAND) {
            bodies.setMass(pod, command == SHIELD ? PodRaceSettings.SHIELD_MASS_FACTOR * settings.mass()
                : settings.mass());
        }
        int power = Math.max(0, command);
        if (command == BOOST) {
            power = boostLeft[pod] ? PodRaceSettings.BOOST_THRUST : settings.maximumThrust();
            boostLeft[pod] = false;
        }
        double dx = targetX[pod] - bodies.x[pod];
        double dy = targetY[pod] - bodies.y[pod];
        if (command == NO_COMMAND || dx == 0 && dy == 0) {
            return 0;
        }
        heading[pod] = Headings.turned(heading[pod], StrictAngles.atan2(dy, dx));
        if (shieldTimer[pod] != 0) {
            return 0;
        }
        direction.turn(heading[pod]);
        double cos = direction.cos();
        double sin = direction.sin();
        double length = Math.sqrt(cos * cos + sin * sin);
        bodies.vx[pod] += cos / length * power;
        bodies.vy[pod] += sin / length * power;
        return power;
    }

    private void countCheckpoints(int player, int mayPass) {
        boolean any = false;
        for (int pod = player * settings.podsPerPlayer(); pod < (player + 1) * settings.podsPerPlayer(); pod++) {
            int most = (mayPass >> pod & 1) != 0 ? checkpoints.length : 0;
            for (; most > 0 && passesNext(pod); most--) {                                   // on behind the finish
                any = true;
                passed[pod]++;
                markCheckpoint(pod);
            }
        }
        turnsLeft[player] = any ? settings.turnsWithoutCheckpoint() : turnsLeft[player] - 1;
    }

    private boolean passesNext(int pod) {
        double[] next = toPass(pod);
        return kernel != null ? kernel.passes(pod, next[0], next[1])
            : CheckpointSweep.passes(log, bodies.id(pod), startX[pod], startY[pod], bodies.x[pod], bodies.y[pod],
                next[0], next[1], reachOfPath, reachOfEnd);
    }

    private void markCheckpoint(int pod) {
        boolean lap = passed[pod] % checkpoints.length == 0;
        events.add(TurnEvent.Kind.MARK, 1, pod, bodies.x[pod], bodies.y[pod], passTexts.get(pod), passed[pod], lap);
    }

    private List<IntFunction<String>> passTexts() {
        return IntStream.range(0, settings.pods()).<IntFunction<String>>mapToObj(pod -> passes -> {
            String lap = ", lap " + passes / checkpoints.length + " of " + settings.laps() + " done";
            int checkpoint = passes % checkpoints.length;
            return "pod " + pod + (checkpoint == 0 ? lap : ", checkpoint " + checkpoint);
        }).toList();
    }

    /** Eliminations and the end of the race: step 4 of the official turn. */
    private void decideOutcome() {
        int in = 0;
        int finished = 0;
        int fewest = settings.rules().fewestTurnsLeft();
        for (int player = 0; player < settings.players(); player++) {
            finished += standing.hasFinished(player) ? 1 : 0;
            if (isIn(player) && turnsLeft[player] < fewest && !standing.hasFinished(player)) {
                putOut(player, "no checkpoint in " + (settings.turnsWithoutCheckpoint() + 1 - fewest) + " turns");
                int pod = standing.bestPod(player);
                events.add(TurnEvent.Kind.MARK, 1, pod, bodies.x[pod], bodies.y[pod],
                    "player " + player + " is out: " + eliminationReason(player), true);
            }
            in += isIn(player) ? 1 : 0;
        }
        if (finished > 0) {
            end("finished after " + settings.laps() + (settings.laps() == 1 ? " lap" : " laps"));
        } else if (in <= (settings.players() > 1 ? 1 : 0)) {
            end(in == 1 ? "all others are out" : "all are out");
        } else if (turn() >= settings.maximumTurns()) {
            end("at most " + settings.maximumTurns() + " turns are played");
        }
    }

    /** All players who are out share the last rank. */
    @Override
    public int[] ranks() {
        return ranks((one, other) -> isIn(one) && isIn(other)
            ? standing.isBetter(standing.bestPod(one), standing.bestPod(other)) : isIn(one) && !isIn(other));
    }

    /** Checkpoints passed by the best pod; -1 for an eliminated player. */
    @Override
    public double[] scores() {
        return standing.scores();
    }

    /** Whole laps of the best pod. */
    @Override
    public SortedMap<String, double[]> ownValues() {
        return ownValue("laps", player -> passed[standing.bestPod(player)] / checkpoints.length);
    }

    public Advance advance() {
        return advance;
    }

    @Override
    public TurnLog log() {
        if (unlogged) {
            unlogged = false;
            kernel.log();
        }
        return log;
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    /**
     * Order: turn; per pod x, y, vx, vy, heading, shield timer, boost left, checkpoints passed, mass; per player turns
     * left and the turn of elimination (2^31 - 1 if not eliminated).
     */
    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int pod = 0; pod < settings.pods(); pod++) {
            hash.add(bodies.x[pod]).add(bodies.y[pod]).add(bodies.vx[pod]).add(bodies.vy[pod]).add(heading(pod))
                .add(shieldTimer[pod]).add(boostLeft[pod]).add(passed[pod]).add(bodies.mass[pod]);
        }
        for (int player = 0; player < settings.players(); player++) {
            hash.add(turnsLeft[player]).add(outTurn(player));
        }
        return hash.value();
    }

    @Internal
    public PodRaceSettings settings() {
        return settings;
    }

    /** A copy of the checkpoints, {@code [n][x, y]}. */
    public double[][] checkpoints() {
        return Arrays.stream(checkpoints).map(double[]::clone).toArray(double[][]::new);
    }

    /** The number of turns that the player has left to pass a checkpoint; by live rules one more is played at 0. */
    public int turnsLeft(int player) {
        return turnsLeft[player];
    }

    public PodState pod(int pod) {
        return new PodState(bodies.x[pod], bodies.y[pod], bodies.vx[pod], bodies.vy[pod], heading(pod),
            shieldTimer[pod], boostLeft[pod], passed[pod]);
    }

    /**
     * Sets the state of a pod, for tests of the rules and for simulators. Right after the turn of a shield (timer 4) it
     * is heavy until its next command.
     */
    public void setPod(int pod, PodState state) {
        log();
        bodies.setPosition(pod, state.x(), state.y());
        bodies.setVelocity(pod, state.vx(), state.vy());
        heading[pod] = state.heading();
        unread &= ~(1 << pod);
        if (kernel != null) {
            kernel.setHeading(pod, heading[pod]);
        }
        shieldTimer[pod] = state.shieldTimer();
        bodies.setMass(pod, state.shieldTimer() == PodRaceSettings.SHIELD_TURNS
            ? PodRaceSettings.SHIELD_MASS_FACTOR * settings.mass() : settings.mass());
        boostLeft[pod] = state.boostLeft();
        passed[pod] = state.passed();
    }

    /** Says how many turns a player has left to pass a checkpoint, for tests of the rules and for simulators. */
    public void setTurnsLeft(int player, int turns) {
        turnsLeft[player] = turns;
    }

    public int playerOf(int pod) {
        return pod / settings.podsPerPlayer();
    }

    /** Index of the checkpoint that a pod must pass next; by live rules 0 when it has finished. */
    public int nextCheckpoint(int pod) {
        return settings.rules().shownNext(passed[pod], toFinish(), checkpoints.length);
    }

    /** The checkpoint that a pod passes next, counting on behind the finish. */
    private double[] toPass(int pod) {
        return checkpoints[(passed[pod] + 1) % checkpoints.length];
    }

    /** Laps done. */
    public int lap(int pod) {
        return passed[pod] / checkpoints.length;
    }

    public double targetX(int pod) {
        return targetX[pod];
    }

    public double targetY(int pod) {
        return targetY[pod];
    }

    public int thrust(int pod) {
        return thrust[pod];
    }

    /** In radians, NaN while unset. */
    public double heading(int pod) {
        if ((unread >> pod & 1) != 0) {
            unread &= ~(1 << pod);
            heading[pod] = kernel.heading(pod);
        }
        return heading[pod];
    }

    public int shieldTimer(int pod) {
        return shieldTimer[pod];
    }

    public boolean boostLeft(int pod) {
        return boostLeft[pod];
    }

    public int passed(int pod) {
        return passed[pod];
    }

    /** The number of checkpoints of the whole race. */
    int toFinish() {
        return settings.laps() * checkpoints.length;
    }

    /** The distance of a pod from its next checkpoint, in u. */
    public double toNext(int pod) {
        double dx = toPass(pod)[0] - bodies.x[pod];
        double dy = toPass(pod)[1] - bodies.y[pod];
        return Math.sqrt(dx * dx + dy * dy);
    }
}

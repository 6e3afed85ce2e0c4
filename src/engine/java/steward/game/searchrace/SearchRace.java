package steward.game.searchrace;

import java.util.Arrays;
import java.util.function.IntFunction;
import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.numerics.SineCosine;
import steward.numerics.StrictAngles;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.scene.Accuracy;
import steward.scene.Plan;
import steward.scene.Scene;

/**
 * Rules of the search race, free of JSON: one car, a point without impacts, passes checkpoints in order as soon as it
 * can. Source: the published official referee; on the rung {@code event/official} positions, headings and times have
 * its bits. On other rungs the car flies by the scene's advance, and the times follow from its course.
 *
 * <p>A race is won with the turn in which the last checkpoint is passed; the score is the time, with two decimals. A
 * race that is lost, or goes on, has the score 1000. A finish in the very last turn does not count, since the official
 * referee would declare it at the beginning of the next one. When the player fails, the race is lost at once: the car
 * does not move in that turn.
 */
public final class SearchRace extends AbstractGame {

    /** No checkpoint was passed in the last turn: the official value of a time that is not there. */
    public static final double NOT_PASSED = 2.0;

    /** A player's command to the car. */
    public enum Order {
        /** Nothing. */
        NONE,
        /** Turn toward a place, and thrust. */
        TOWARD,
        /** Turn by degrees, and thrust. */
        TURN
    }

    private final SearchRaceSettings settings;
    private final Plan plan;
    private final double[][] checkpoints;
    private final boolean official;
    private final Bodies bodies = new Bodies(1);
    private final Advance advance;
    private final Motion motion;
    private final SineCosine direction = new SineCosine();
    private final IntFunction<String> passText = this::passText;

    private double heading;
    private int passed;
    private int timer;
    private double passTime = NOT_PASSED;
    private boolean asksForTimes;
    private boolean wantsTimes;
    private double score = SearchRaceSettings.LOST;

    private Order order = Order.NONE;
    private double targetX;
    private double targetY;
    private int degrees;
    private int thrust;

    /** A race before its first turn, on the scene's map or that of the seed. Nothing is drawn at random. */
    public SearchRace(SearchRaceSettings settings, Scene scene, Plan plan, long seed) {
        super(1);
        this.settings = settings;
        this.plan = plan;
        checkpoints = settings.map(seed);
        official = scene.accuracy().equals(Accuracy.event(Arithmetic.OFFICIAL));
        advance = plan.advance(null);
        motion = plan.motion();
        double[] start = checkpoints[0];
        bodies.setDrag(bodies.addPoint(start[0], start[1], 1), scene.drag());
        heading = OfficialSearchRace.wholeDegrees(
            StrictAngles.atan2(checkpoints[1][1] - start[1], checkpoints[1][0] - start[0]));
    }

    private SearchRace(SearchRace other) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        checkpoints = other.checkpoints;
        official = other.official;
        advance = plan.advance(null);
        motion = other.motion;
        bodies.copyFrom(other.bodies);
        heading = other.heading;
        passed = other.passed;
        timer = other.timer;
        passTime = other.passTime;
        asksForTimes = other.asksForTimes;
        wantsTimes = other.wantsTimes;
        score = other.score;
        order = other.order;
        targetX = other.targetX;
        targetY = other.targetY;
        degrees = other.degrees;
        thrust = other.thrust;
    }

    @Override
    public SearchRace copy() {
        return new SearchRace(this);
    }

    /** The command for the next turn: toward a place with a thrust of 0..200. */
    public void toward(double x, double y, int power) {
        order = Order.TOWARD;
        targetX = x;
        targetY = y;
        thrust = power;
    }

    /** The command for the next turn: turn by -18..18 degrees, then a thrust of 0..200. */
    public void turn(int byDegrees, int power) {
        order = Order.TURN;
        degrees = byDegrees;
        thrust = power;
    }

    /** No command for the next turn. */
    public void clear() {
        order = Order.NONE;
        asksForTimes = false;
    }

    /** With the next turn the player begins to be told when in a turn the last checkpoint was passed. */
    public void askForTimes() {
        asksForTimes = true;
    }

    @Override
    protected void playTurn() {
        if (!isIn(0)) {
            end("lost: " + eliminationReason(0));
            return;
        }
        wantsTimes |= asksForTimes;
        steer();
        clear();
        passTime = NOT_PASSED;
        if (official) {
            flyOfficially();
        } else {
            passOnCourse();
            advance.turn(bodies, log);
        }
        motion.endTurn(bodies);
        heading = OfficialSearchRace.wholeDegrees(heading);
        decideOutcome();
    }

    private void steer() {
        if (order == Order.TOWARD) {
            double dx = targetX - bodies.x[0];
            double dy = targetY - bodies.y[0];
            if (dx == 0 && dy == 0) {
                return;
            }
            heading = OfficialSearchRace.turned(heading, dx, dy);
        } else if (order == Order.TURN) {
            heading = OfficialSearchRace.turnedBy(heading, degrees);
        } else {
            return;
        }
        direction.turn(heading);
        bodies.vx[0] += direction.cos() * thrust;
        bodies.vy[0] += direction.sin() * thrust;
    }

    /** From checkpoint to checkpoint, then to the end of the turn, each way added to the position. */
    private void flyOfficially() {
        double now = 0.0;
        while (!hasFinished()) {
            double time = timeToNext(bodies.x[0], bodies.y[0]);
            if (!(time + now <= 1.0)) {
                break;
            }
            now += time;
            bodies.x[0] += bodies.vx[0] * time;
            bodies.y[0] += bodies.vy[0] * time;
            pass(now, bodies.x[0], bodies.y[0]);
        }
        bodies.x[0] += bodies.vx[0] * (1.0 - now);
        bodies.y[0] += bodies.vy[0] * (1.0 - now);
    }

    /** Passes checkpoints without moving the car: all times follow from where it is when the turn begins. */
    private void passOnCourse() {
        double now = 0;
        double x = bodies.x[0];
        double y = bodies.y[0];
        while (!hasFinished()) {
            double time = timeToNext(x, y);
            if (!(time + now <= 1)) {
                return;
            }
            now += time;
            x = bodies.x[0] + bodies.vx[0] * now;
            y = bodies.y[0] + bodies.vy[0] * now;
            pass(now, x, y);
        }
    }

    private double timeToNext(double x, double y) {
        double[] next = checkpoints[nextCheckpoint()];
        return OfficialSearchRace.timeTo(x - next[0], y - next[1], bodies.vx[0], bodies.vy[0],
            settings.checkpointRadius());
    }

    private String passText(int passes) {
        return passes % checkpoints.length == 0
            ? "lap " + passes / checkpoints.length + " of " + settings.laps() + " done"
            : "checkpoint " + passes % checkpoints.length;
    }

    private void pass(double time, double x, double y) {
        passed++;
        passTime = time;
        boolean lap = passed % checkpoints.length == 0;
        events.add(TurnEvent.Kind.MARK, time, 0, x, y, passText, passed, lap);
    }

    private void decideOutcome() {
        if (!hasFinished()) {
            timer++;
            if (timer >= settings.maximumTurns()) {
                end("lost: not finished in " + settings.maximumTurns() + " turns");
            }
        } else if (timer + 1 >= settings.maximumTurns()) {
            end("lost: finished in the last of " + settings.maximumTurns() + " turns, too late to be declared");
        } else {
            score = OfficialSearchRace.shown(timer + passTime);
            end("finished after " + settings.laps() + (settings.laps() == 1 ? " lap" : " laps"));
        }
    }

    private boolean hasFinished() {
        return passed >= toFinish();
    }

    @Override
    public int[] ranks() {
        return new int[1];
    }

    /** The time in turns with two decimals; 1000 while the race goes on, and when it is lost. */
    @Override
    public double[] scores() {
        return new double[] {score};
    }

    @Override
    public boolean lowerScoreIsBetter() {
        return true;
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    /**
     * Order: turn, x, y, vx, vy, heading, checkpoints passed, timer, the time of the last one that was passed, whether
     * the player wants times, the turn of elimination (2^31 - 1 if not eliminated).
     */
    @Override
    public long hash() {
        return hash.reset().add(turn()).add(bodies.x[0]).add(bodies.y[0]).add(bodies.vx[0]).add(bodies.vy[0])
            .add(heading).add(passed).add(timer).add(passTime).add(wantsTimes).add(outTurn(0)).value();
    }

    /** Sets the state of the car, for tests of the rules. */
    public void set(double x, double y, double vx, double vy, double headingRadians, int passedCheckpoints,
                    int fullTurns, double lastPassTime) {
        bodies.setPosition(0, x, y);
        bodies.setVelocity(0, vx, vy);
        heading = headingRadians;
        passed = passedCheckpoints;
        timer = fullTurns;
        passTime = lastPassTime;
    }

    public SearchRaceSettings settings() {
        return settings;
    }

    /** A copy of the checkpoints, {@code [n][x, y]}. */
    public double[][] checkpoints() {
        return Arrays.stream(checkpoints).map(double[]::clone).toArray(double[][]::new);
    }

    /** The number of checkpoints of the whole race. */
    public int toFinish() {
        return settings.laps() * checkpoints.length;
    }

    public int passed() {
        return passed;
    }

    /** Index of the checkpoint that it must pass next. */
    public int nextCheckpoint() {
        return (passed + 1) % checkpoints.length;
    }

    /** In radians. */
    public double heading() {
        return heading;
    }

    /** The number of turns in which the race was not finished. */
    public int timer() {
        return timer;
    }

    /** Returns when in the last turn the last checkpoint was passed, {@link #NOT_PASSED} if none was. */
    public double passTime() {
        return passTime;
    }

    /** True if the player has asked for these times in a turn before. */
    public boolean wantsTimes() {
        return wantsTimes;
    }

    /** True if the command for the next turn asks for these times. */
    public boolean asksForTimes() {
        return asksForTimes;
    }

    /** Returns the player's command for the next turn. */
    public Order order() {
        return order;
    }

    public double targetX() {
        return targetX;
    }

    public double targetY() {
        return targetY;
    }

    public int degrees() {
        return degrees;
    }

    public int thrust() {
        return thrust;
    }
}

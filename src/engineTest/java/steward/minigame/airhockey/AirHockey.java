package steward.minigame.airhockey;

import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.scene.Plan;

/** The rules. Bodies 0 and 1 are the players' paddles, body 2 is the puck; none is ever added or removed. */
final class AirHockey extends AbstractGame {

    static final int PADDLE = 0;
    static final int PUCK = 1;
    static final double[] RADIUS = {60, 60, 40};
    private static final double[] MASS = {4, 4, 1};
    private static final int RIGHT_WALL = 2;
    private static final int CENTRE_LINE = 4;

    private final HockeySettings settings;
    private final Plan plan;
    private final Bodies bodies = new Bodies(RADIUS.length);
    private final Advance advance;
    private final int[] goals = new int[2];
    private final double[] pushX = new double[2];
    private final double[] pushY = new double[2];

    /** The puck starts in a direction that the seed draws. */
    AirHockey(HockeySettings settings, double drag, Plan plan, long seed) {
        super(2);
        this.settings = settings;
        this.plan = plan;
        advance = plan.advance(new Touch(settings));
        for (int body = 0; body < RADIUS.length; body++) {
            bodies.add(0, 0, RADIUS[body], MASS[body]);
            bodies.setKind(body, body < 2 ? PADDLE : PUCK);
            bodies.setDrag(body, drag);
            settings.place(bodies, body);
        }
        SplitMix64 random = new SplitMix64(seed);
        bodies.setVelocity(2, random.nextInt(-10, 10), random.nextInt(-10, 10));
    }

    private AirHockey(AirHockey other) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        advance = plan.advance(new Touch(settings));
        bodies.copyFrom(other.bodies);
        System.arraycopy(other.goals, 0, goals, 0, 2);
    }

    @Override
    public AirHockey copy() {
        return new AirHockey(this);
    }

    /** Reaction to the touch of the puck and a wall: in a goal it scores and all bodies go back to their places. */
    record Touch(HockeySettings settings) implements Reaction {

        @Override
        public Verdict on(double time, int puck, int wall, Bodies bodies, TurnSink sink) {
            if (~wall == CENTRE_LINE) {
                return Verdict.PASS;
            } else if (~wall % 2 == 1 || !settings.isInGoal(bodies.y[puck])) {
                return Verdict.BOUNCE;
            }
            sink.fact(time, 0, 2, ~wall == RIGHT_WALL ? 0 : 1, bodies.x[puck], bodies.y[puck], 0, 0);
            for (int body = 0; body < bodies.size(); body++) {
                sink.knot(body, time, bodies.x[body], bodies.y[body]);
                settings.place(bodies, body);
                sink.knot(body, time, bodies.x[body], bodies.y[body]);
            }
            return Verdict.CHANGED;
        }
    }

    /** A player's command for the next turn: what the speed of its paddle changes by. */
    void push(int player, double x, double y) {
        pushX[player] = x;
        pushY[player] = y;
    }

    @Override
    protected void playTurn() {
        for (int player = 0; player < 2; player++) {
            bodies.vx[player] += isIn(player) ? pushX[player] : 0;
            bodies.vy[player] += isIn(player) ? pushY[player] : 0;
            push(player, 0, 0);
        }
        advance.turn(bodies, log);
        plan.motion().endTurn(bodies);
        for (int k = 0; k < log.facts(); k++) {
            goals[log.factB(k)]++;
            events.add(TurnEvent.Kind.MARK, log.factTime(k), 2, log.factX(k), log.factY(k),
                log.factB(k) == 0 ? "goal of player 0" : "goal of player 1", true);
        }
        if (!isIn(0) || !isIn(1)) {
            end("a player is out");
        } else if (Math.max(goals[0], goals[1]) >= settings.goalsToWin()) {
            end("a player has scored often enough");
        } else if (turn() >= settings.maximumTurns()) {
            end("at most " + settings.maximumTurns() + " turns are played");
        }
    }

    @Override
    public int[] ranks() {
        double[] scores = scores();
        return ranks((one, other) -> scores[one] > scores[other]);
    }

    /** Goals; -1 for a player that is out. */
    @Override
    public double[] scores() {
        return new double[] {isIn(0) ? goals[0] : -1, isIn(1) ? goals[1] : -1};
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    /** Turn; per body place and speed; per player goals and turn of exit; whether the puck is on the line. */
    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int k = 0; k < bodies.size(); k++) {
            hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
        }
        return hash.add(goals[0]).add(goals[1]).add(outTurn(0)).add(outTurn(1)).add(isOnLine()).value();
    }

    boolean isOnLine() {
        return !bodies.passing().isEmpty();
    }

    double pushX(int player) {
        return pushX[player];
    }

    double pushY(int player) {
        return pushY[player];
    }
}

package example;

import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.scene.Plan;

/** Rules of sumo: two wrestlers push themselves; whoever leaves the ring has lost. Body k is that of player k. */
final class Sumo extends AbstractGame {

    static final double RADIUS = 60;

    /**
     * The block {@code sumo} of a scene.
     *
     * @param ring         radius of the ring around (0, 0), in u
     * @param push         the most that a wrestler changes its speed by in a turn, in u per turn
     * @param maximumTurns after which whoever is nearer to the middle has won
     */
    record Settings(double ring, double push, int maximumTurns) {
    }

    private final Settings settings;
    private final Plan plan;
    private final Bodies bodies = new Bodies(2);
    private final Advance advance;
    private final double[] pushX = new double[2];
    private final double[] pushY = new double[2];

    /** The wrestlers begin on opposite sides, in a direction that the seed draws. */
    Sumo(Settings settings, double drag, Plan plan, long seed) {
        super(2);
        this.settings = settings;
        this.plan = plan;
        advance = plan.advance(null);
        SplitMix64 random = new SplitMix64(seed);
        double x = random.nextInt(-100, 100);
        double y = random.nextInt(1, 100);
        double scale = settings.ring / 2 / Math.sqrt(x * x + y * y);
        for (int side = 1; side >= -1; side -= 2) {
            int body = bodies.add(side * x * scale, side * y * scale, RADIUS, 1);
            bodies.setDrag(body, drag);
        }
    }

    private Sumo(Sumo other) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        advance = plan.advance(null);
        bodies.copyFrom(other.bodies);
    }

    @Override
    public Sumo copy() {
        return new Sumo(this);
    }

    void push(int player, double x, double y) {
        pushX[player] = x;
        pushY[player] = y;
    }

    double pushX(int player) {
        return pushX[player];
    }

    double pushY(int player) {
        return pushY[player];
    }

    @Override
    protected void playTurn() {
        for (int player = 0; player < 2; player++) {
            bodies.vx[player] += pushX[player];
            bodies.vy[player] += pushY[player];
            push(player, 0, 0);
        }
        advance.turn(bodies, log);
        plan.motion().endTurn(bodies);
        boolean left = false;
        for (int player = 0; player < 2; player++) {
            if (fromMiddle(player) > settings.ring) {
                left = true;
                events.add(TurnEvent.Kind.MARK, 1, player, bodies.x[player], bodies.y[player],
                    player == 0 ? "player 0 leaves the ring" : "player 1 leaves the ring", true);
            }
        }
        if (left) {
            end("the ring was left");
        } else if (!isIn(0) || !isIn(1)) {
            end("a player is out");
        } else if (turn() >= settings.maximumTurns) {
            end("at most " + settings.maximumTurns + " turns are played");
        }
    }

    private double fromMiddle(int player) {
        return Math.sqrt(bodies.x[player] * bodies.x[player] + bodies.y[player] * bodies.y[player]);
    }

    @Override
    public int[] ranks() {
        return ranks((one, other) -> isIn(one) != isIn(other) ? isIn(one) : fromMiddle(one) < fromMiddle(other));
    }

    /** Distance from the edge of the ring, in u. */
    @Override
    public double[] scores() {
        return new double[] {settings.ring - fromMiddle(0), settings.ring - fromMiddle(1)};
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int k = 0; k < 2; k++) {
            hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]).add(outTurn(k));
        }
        return hash.value();
    }
}

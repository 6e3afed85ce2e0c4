package steward.minigame;

import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.event.EventAdvance;
import steward.scene.Plan;
import steward.scene.Scene;

/** The game; what touches do is in {@link PondRules}. A player who is out has no body any more. */
final class Pond extends AbstractGame {

    static final int HUNTER = 0;
    static final int BUBBLE = 1;
    static final int CELL = 2;
    static final int FOG = 3;
    static final int KINDS = 4;

    private static final double HUNTER_MASS = 10;
    private static final double RADIUS_OF_UNIT_MASS = 15;
    /** Room for some bodies beyond what the scene can come to: without any, a cell is eaten where it would split. */
    private static final int SPARE = 4;

    private final PondSettings settings;
    private final Plan plan;
    private final double drag;
    private final Bodies bodies;
    private final Advance advance;
    private final Motion motion;
    private final int[] hunterIds;
    private final double[] pushX;
    private final double[] pushY;

    /** Draws the angle of the first hunter, then for each other body its place, until it is free, and its speed. */
    Pond(PondSettings settings, Scene scene, Plan plan, long seed) {
        super(scene.players());
        this.settings = settings;
        this.plan = plan;
        drag = scene.drag();
        int players = scene.players();
        bodies = new Bodies(players + settings.bubbles() + settings.fogs()
            + settings.cells() * (int) Math.ceil(settings.cellMass() / PondRules.SMALLEST_CELL) + SPARE);
        advance = new EventAdvance(plan.physics(new PondRules(this)));
        motion = plan.motion();
        hunterIds = new int[players];
        pushX = new double[players];
        pushY = new double[players];
        SplitMix64 random = new SplitMix64(seed);
        double first = 2 * Math.PI * random.nextDouble();
        Arena arena = settings.arena();
        for (int player = 0; player < players; player++) {
            double angle = first + 2 * Math.PI * player / players;
            hunterIds[player] = bodies.id(add(HUNTER, arena.x() + 0.6 * arena.radius() * StrictMath.cos(angle),
                arena.y() + 0.6 * arena.radius() * StrictMath.sin(angle), HUNTER_MASS));
        }
        scatter(random, BUBBLE, settings.bubbles(), 2);
        scatter(random, CELL, settings.cells(), settings.cellMass());
        scatter(random, FOG, settings.fogs(), 30);
    }

    private Pond(Pond other) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        drag = other.drag;
        bodies = new Bodies(other.bodies.capacity());
        bodies.copyFrom(other.bodies);
        advance = new EventAdvance(plan.physics(new PondRules(this)));
        motion = other.motion;
        hunterIds = other.hunterIds.clone();
        pushX = other.pushX.clone();
        pushY = other.pushY.clone();
    }

    @Override
    public Pond copy() {
        return new Pond(this);
    }

    private void scatter(SplitMix64 random, int kind, int count, double mass) {
        Arena arena = settings.arena();
        double room = arena.radius() - radiusOf(mass);
        for (int k = 0; k < count; k++) {
            double x;
            double y;
            do {
                x = arena.x() + room * (2 * random.nextDouble() - 1);
                y = arena.y() + room * (2 * random.nextDouble() - 1);
            } while (!isFree(x, y, radiusOf(mass)));
            bodies.setVelocity(add(kind, x, y, mass), 40 * random.nextDouble() - 20, 40 * random.nextDouble() - 20);
        }
    }

    private boolean isFree(double x, double y, double radius) {
        boolean free = settings.arena().gap(x, y, radius) > 0;
        for (int k = 0; k < bodies.size(); k++) {
            double dx = bodies.x[k] - x;
            double dy = bodies.y[k] - y;
            free &= Math.sqrt(dx * dx + dy * dy) > bodies.radius[k] + radius;
        }
        return free;
    }

    static double radiusOf(double mass) {
        return RADIUS_OF_UNIT_MASS * Math.sqrt(mass);
    }

    int add(int kind, double x, double y, double mass) {
        int body = bodies.add(x, y, radiusOf(mass), mass);
        bodies.setKind(body, kind);
        bodies.setDrag(body, drag);
        return body;
    }

    /** A body that has come to reach beyond the arena is moved straight in. */
    void keepInside(int body) {
        Arena arena = settings.arena();
        double gap = arena.gap(bodies.x[body], bodies.y[body], bodies.radius[body]);
        if (gap < 0) {
            double nx = arena.normalX(bodies.x[body], bodies.y[body]);
            double ny = arena.normalY(bodies.x[body], bodies.y[body]);
            bodies.setPosition(body, bodies.x[body] + gap * nx, bodies.y[body] + gap * ny);
        }
    }

    void report(TurnEvent.Kind kind, double time, int body, String text) {
        events.add(kind, time, bodies.id(body), bodies.x[body], bodies.y[body], text, false);
    }

    void command(int player, double x, double y) {
        pushX[player] = x;
        pushY[player] = y;
    }

    /** As the rules of the game say, seen by {@link PondRules}. */
    void eaten(int player, String reason) {
        putOut(player, reason);
    }

    @Override
    protected void playTurn() {
        for (int player = 0; player < players(); player++) {
            int body = bodies.indexOf(hunterIds[player]);
            if (body >= 0 && isIn(player)) {
                bodies.vx[body] += pushX[player];
                bodies.vy[body] += pushY[player];
            } else if (body >= 0) {
                report(TurnEvent.Kind.DEATH, 0, body, "out");
                bodies.remove(body);
            }
            command(player, 0, 0);
        }
        advance.turn(bodies, log);
        motion.endTurn(bodies);
        judge();
    }

    private void judge() {
        int in = 0;
        int cells = 0;
        for (int player = 0; player < players(); player++) {
            in += isIn(player) ? 1 : 0;
        }
        for (int body = 0; body < bodies.size(); body++) {
            cells += bodies.kind[body] == CELL ? 1 : 0;
        }
        if (in <= 1) {
            end(in == 1 ? "only one hunter is left" : "no hunter is left");
        } else if (cells == 0 && settings.cells() > 0) {
            end("no cell is left");
        } else if (turn() >= settings.maximumTurns()) {
            end("at most " + settings.maximumTurns() + " turns are played");
        }
    }

    /** In before out, then heavier or out later. */
    @Override
    public int[] ranks() {
        double[] scores = scores();
        return ranks((one, other) -> outTurn(one) > outTurn(other)
            || outTurn(one) == outTurn(other) && scores[one] > scores[other]);
    }

    /** The hunter's mass; 0 for a player that is out. */
    @Override
    public double[] scores() {
        double[] scores = new double[players()];
        for (int player = 0; player < scores.length; player++) {
            int body = bodies.indexOf(hunterIds[player]);
            scores[player] = body >= 0 && isIn(player) ? bodies.mass[body] : 0;
        }
        return scores;
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    /** Turn, next id, per body id, kind and five numbers, passing pairs in their order, per player the turn of exit. */
    @Override
    public long hash() {
        hash.reset().add(turn()).add(bodies.nextId());
        for (int k = 0; k < bodies.size(); k++) {
            hash.add(bodies.id(k)).add(bodies.kind[k]).add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k])
                .add(bodies.vy[k]).add(bodies.mass[k]);
        }
        for (int k = 0; k < bodies.passing().size(); k++) {
            hash.add(bodies.passing().first(k)).add(bodies.passing().second(k));
        }
        for (int player = 0; player < players(); player++) {
            hash.add(outTurn(player));
        }
        return hash.value();
    }

    PondSettings settings() {
        return settings;
    }

    double pushX(int player) {
        return pushX[player];
    }

    double pushY(int player) {
        return pushY[player];
    }

    int hunterId(int player) {
        return hunterIds[player];
    }

    /** The player whose hunter has this id, or -1. */
    int ownerOf(int id) {
        for (int player = 0; player < hunterIds.length; player++) {
            if (hunterIds[player] == id) {
                return player;
            }
        }
        return -1;
    }
}

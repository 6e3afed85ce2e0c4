package steward.minigame;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.game.Game;
import steward.game.TurnEvent;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnLog;
import steward.physics.event.EventAdvance;
import steward.scene.Plan;
import steward.scene.Scene;

/** The game; what touches do is in {@link PondRules}. A player who is out has no body any more. */
final class Pond implements Game {

    static final int HUNTER = 0;
    static final int BUBBLE = 1;
    static final int CELL = 2;
    static final int FOG = 3;
    static final int KINDS = 4;

    private static final double HUNTER_MASS = 10;
    private static final double RADIUS_OF_UNIT_MASS = 15;
    /** Room for some bodies beyond what the scene can come to: without any, a cell is eaten where it would split. */
    private static final int SPARE = 4;
    private static final int NOT_OUT = Integer.MAX_VALUE;

    private final PondSettings settings;
    private final double drag;
    private final Bodies bodies;
    private final Advance advance;
    private final Motion motion;
    private final TurnLog log = new TurnLog();
    private final List<TurnEvent> events = new ArrayList<>();
    private final StateHash hash = new StateHash();

    private final int[] hunterIds;
    private final double[] pushX;
    private final double[] pushY;
    private final int[] outTurn;
    private final String[] outReason;
    private int turn;
    private String ending;

    /** Draws the angle of the first hunter, then for each other body its place, until it is free, and its speed. */
    Pond(PondSettings settings, Scene scene, Plan plan, long seed) {
        this.settings = settings;
        drag = scene.drag();
        int players = scene.players();
        bodies = new Bodies(players + settings.bubbles() + settings.fogs()
            + settings.cells() * (int) Math.ceil(settings.cellMass() / PondRules.SMALLEST_CELL) + SPARE);
        advance = new EventAdvance(plan.physics(new PondRules(this)));
        motion = plan.motion();
        hunterIds = new int[players];
        pushX = new double[players];
        pushY = new double[players];
        outTurn = new int[players];
        outReason = new String[players];
        Arrays.fill(outTurn, NOT_OUT);
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
        events.add(new TurnEvent(kind, time, bodies.id(body), bodies.x[body], bodies.y[body], text, false));
    }

    void command(int player, double x, double y) {
        pushX[player] = x;
        pushY[player] = y;
    }

    void putOut(int player, String reason) {
        if (isIn(player)) {
            outReason[player] = reason;
            outTurn[player] = turn;
        }
    }

    @Override
    public void play() {
        turn++;
        log.clear();
        events.clear();
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
            ending = in == 1 ? "only one hunter is left" : "no hunter is left";
        } else if (cells == 0 && settings.cells() > 0) {
            ending = "no cell is left";
        } else if (turn >= settings.maximumTurns()) {
            ending = "at most " + settings.maximumTurns() + " turns are played";
        }
    }

    @Override
    public void eliminate(int player, String reason) {
        if (isIn(player)) {
            outReason[player] = reason;
            outTurn[player] = turn + 1;
        }
    }

    @Override
    public int players() {
        return hunterIds.length;
    }

    @Override
    public int turn() {
        return turn;
    }

    @Override
    public String eliminationReason(int player) {
        return outReason[player];
    }

    @Override
    public boolean isOver() {
        return ending != null;
    }

    @Override
    public String ending() {
        return ending;
    }

    /** In before out, then heavier or out later. */
    @Override
    public int[] ranks() {
        int[] ranks = new int[players()];
        double[] scores = scores();
        for (int player = 0; player < ranks.length; player++) {
            for (int other = 0; other < ranks.length; other++) {
                ranks[player] += outTurn[other] > outTurn[player]
                    || outTurn[other] == outTurn[player] && scores[other] > scores[player] ? 1 : 0;
            }
        }
        return ranks;
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

    @Override
    public TurnLog log() {
        return log;
    }

    @Override
    public List<TurnEvent> events() {
        return events;
    }

    /** Turn, next id, per body id, kind and five numbers, passing pairs in their order, per player the turn of exit. */
    @Override
    public long hash() {
        hash.reset().add(turn).add(bodies.nextId());
        for (int k = 0; k < bodies.size(); k++) {
            hash.add(bodies.id(k)).add(bodies.kind[k]).add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k])
                .add(bodies.vy[k]).add(bodies.mass[k]);
        }
        for (int k = 0; k < bodies.passing().size(); k++) {
            hash.add(bodies.passing().first(k)).add(bodies.passing().second(k));
        }
        for (int out : outTurn) {
            hash.add(out);
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

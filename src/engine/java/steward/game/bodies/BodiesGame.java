package steward.game.bodies;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.TeeSink;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Rest;
import steward.scene.Bumper;
import steward.scene.Plan;

/**
 * Rules of the game {@code bodies}: discs that players push, among walls and zones. The ids of discs come first, in the
 * order of the scene, then those of its bumpers. Zones may take discs out: then the indices of later bodies fall, and
 * ids stay. A player commands a thrust for each of its discs.
 */
public final class BodiesGame extends AbstractGame {

    private final PlayRules rules;
    private final Plan plan;
    private final List<Body> discs;
    /** Zones of the rules, as an array: the iterator of a list is allocated. */
    private final Zone[] zones;
    /** Zones that bodies reach on their way, and what enters them; {@code null} if there are none. */
    private final ZonePassings passings;
    /** {@code null} if no zone takes discs out on their way. */
    private final Pockets pockets;
    /** By the id of a disc, the zone that has taken it out, or {@code null}. */
    private final Zone[] takers;
    private final Bodies bodies;
    private final Advance advance;
    private final Wall[] walls;
    private final TurnSink sink;
    /** Per player the ids of its discs. */
    private final int[][] owned;
    private final long[] points;
    /** Commands, by body. */
    private final Thrust[] thrusts;

    /**
     * A command for one disc: an impulse at the start of the turn.
     *
     * @param x to the right
     * @param y downwards
     */
    public record Thrust(double x, double y) { }

    /** A game before its first turn. */
    public BodiesGame(Layout layout, PlayRules rules, Plan plan, int players, long seed) {
        this(layout.draw(seed), rules, plan, new int[players][], layout.field().bumpers().size());
        for (int player = 0; player < players; player++) {
            int owner = player;
            owned[player] = IntStream.range(0, discs.size()).filter(k -> discs.get(k).owner() == owner).toArray();
        }
        for (Body disc : discs) {
            int k = bodies.add(disc.x(), disc.y(), disc.radius(), disc.mass());
            bodies.setVelocity(k, disc.vx(), disc.vy());
            bodies.setRestitution(k, disc.restitution());
            bodies.setDrag(k, disc.drag());
        }
        for (Bumper bumper : layout.field().bumpers()) {
            int k = bodies.add(bumper.x(), bumper.y(), bumper.radius(), Double.POSITIVE_INFINITY);
            bodies.setRestitution(k, bumper.restitution());
        }
    }

    private BodiesGame(BodiesGame other) {
        super(other);
        rules = other.rules;
        plan = other.plan;
        discs = other.discs;
        zones = other.zones;
        owned = other.owned;
        bodies = other.bodies.copy();
        thrusts = new Thrust[discs.size()];
        points = other.points.clone();
        takers = other.takers.clone();
        passings = passings();
        pockets = pockets();
        advance = advance();
        walls = other.walls;
        sink = sink();
    }

    private BodiesGame(List<Body> discs, PlayRules rules, Plan plan, int[][] owned, int bumpers) {
        super(owned.length);
        this.rules = rules;
        this.plan = plan;
        this.discs = discs;
        zones = rules.zones().toArray(Zone[]::new);
        this.owned = owned;
        bodies = new Bodies(discs.size() + bumpers);
        thrusts = new Thrust[discs.size()];
        points = new long[owned.length];
        takers = new Zone[discs.size()];
        passings = passings();
        pockets = pockets();
        advance = advance();
        walls = plan.physics(pockets).walls().toArray(Wall[]::new);
        sink = sink();
    }

    @Override
    public BodiesGame copy() {
        return new BodiesGame(this);
    }

    private ZonePassings passings() {
        Zone[] passed = Arrays.stream(zones).filter(Zone::passing).toArray(Zone[]::new);
        return passed.length == 0 ? null : new ZonePassings(passed, discs.size());
    }

    private Pockets pockets() {
        return rules.hasPockets() ? new Pockets(zones, bodies, discs.size()) : null;
    }

    private Advance advance() {
        return pockets == null ? plan.advance(null)
            : plan.advance(pockets, inner -> pockets.around(inner, () -> turn() == 1));
    }

    /** The log, and in front of it a count of contacts where they have points. */
    private TurnSink sink() {
        if (rules.contactPoints() == 0 || owned.length == 0) {
            return log;
        }
        return new TeeSink(log, new TurnSink() {
            @Override
            public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                               double normalX, double normalY, double impulse, double energy, double massA,
                               double massB, double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                               double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
                if (b >= 0 && owner(a) != owner(b)) {
                    score(owner(a), rules.contactPoints());
                    score(owner(b), rules.contactPoints());
                }
            }
        });
    }

    private void score(int player, int more) {
        if (player != Body.NOBODY) {
            points[player] += more;
        }
    }

    private int owner(int body) {
        return body < discs.size() ? discs.get(body).owner() : Body.NOBODY;
    }

    /** Gives a disc its command for the next turn, or none for {@code null}. */
    public void thrust(int body, Thrust thrust) {
        thrusts[body] = thrust;
    }

    /** The command of a disc for the next turn, or {@code null}. */
    public Thrust thrust(int body) {
        return thrusts[body];
    }

    @Override
    public int fewestPlayers() {
        return Math.min(2, players());
    }

    @Override
    protected void playTurn() {
        if (isDecided()) {
            end("too few players are left");
            return;
        }
        push();
        if (passings == null) {
            advance.turn(bodies, sink);
            plan.motion().endTurn(bodies);
        } else {
            passings.begin(bodies, turn() == 1);
            advance.turn(bodies, sink);
            passings.follow(log);
            passings.end(bodies);
            plan.motion().endTurn(bodies);
            passings.end(bodies);
        }
        Arrays.fill(thrusts, null);
        boolean reached = passZones() || visitZones();
        if (!reached && discsLeft() == 0) {
            end("no body is left");
        } else if (!reached && isAtRest()) {
            end("all bodies are slower than the scene's restBelow");
        } else if (!reached && turn() >= rules.maximumTurns()) {
            end("at most " + rules.maximumTurns() + " turns are played");
        }
    }

    /** Impulses at the start of the turn: forces, gravity, thrust. */
    private void push() {
        for (int k = 0; k < discsLeft(); k++) {
            Thrust thrust = thrusts[bodies.id(k)];
            boolean pushed = thrust != null && isIn(owner(bodies.id(k)));
            rules.forces().accelerate(bodies, k, pushed ? thrust.x() : 0, pushed ? thrust.y() : 0);
        }
    }

    /** Lets zones act on what has entered them, in the order of time. @return whether the game is over */
    private boolean passZones() {
        for (int k = 0; passings != null && k < passings.size() && !isOver(); k++) {
            int disc = passings.disc(k);
            if (takers[disc] == null) {
                reach(passings.zone(k), disc, passings.time(k), passings.x(k), passings.y(k));
            }
        }
        return isOver();
    }

    /** Lets the other zones act on what is in them at the end of the turn. @return whether the game is over */
    private boolean visitZones() {
        for (Zone zone : zones) {
            for (int k = 0; !zone.passing() && k < discsLeft(); k++) {
                if (zone.holds(bodies.x[k], bodies.y[k])) {
                    reach(zone, bodies.id(k), 1, bodies.x[k], bodies.y[k]);
                    k -= zone.removes() ? 1 : 0;
                }
            }
        }
        return isOver();
    }

    /** Gives points, takes a disc out, and ends the game, as a zone says. */
    private void reach(Zone zone, int disc, double time, double x, double y) {
        score(owner(disc), zone.points());
        boolean ends = zone.ends() && !isOver();
        if (zone.removes()) {
            takers[disc] = zone;
            bodies.remove(bodies.indexOf(disc));
            events.add(TurnEvent.Kind.DEATH, time, disc, x, y, "zone " + zone.label(), true);
        } else if (zone.passing() || ends) {
            events.add(TurnEvent.Kind.MARK, time, disc, x, y, "zone " + zone.label(), ends);
        }
        if (ends) {
            end("body " + disc + (zone.passing() ? " has reached" : " is in") + " the zone " + zone.label());
        }
    }

    /** The number of discs that no zone has taken out; they have the lowest indices. */
    public int discsLeft() {
        return bodies.size() - (bodies.capacity() - discs.size());
    }

    /** The zone that has taken a disc out, or {@code null}. */
    public Zone taker(int disc) {
        return takers[disc];
    }

    /**
     * {@inheritDoc} These are slower than the scene's restBelow, in flight too. Without that they go in a turn less
     * than the share of their radius up to which a gap counts as contact.
     */
    @Override
    public int bodiesAtRest() {
        if (rules.restBelow() == 0 && !plan.physics(pockets).law().bodiesRest()) {
            return -1;
        }
        int count = 0;
        for (int k = 0; k < discsLeft(); k++) {
            double bound = rules.restBelow() > 0 ? rules.restBelow() : bodies.radius[k] / Rest.NEAR;
            count += bodies.inverseMass[k] > 0 && isSlower(k, bound) ? 1 : 0;
        }
        return count;
    }

    private boolean isSlower(int k, double bound) {
        return bodies.vx[k] * bodies.vx[k] + bodies.vy[k] * bodies.vy[k] < bound * bound;
    }

    private boolean isAtRest() {
        if (rules.restBelow() == 0) {
            return false;
        }
        for (int k = 0; k < discsLeft(); k++) {
            if (bodies.inverseMass[k] > 0
                && !(isSlower(k, rules.restBelow()) && (!rules.forces().act() || isCarried(k)))) {
                return false;
            }
        }
        return true;
    }

    /** True if a disc touches something against the force on it: at the top of a bounce it is slow, but not at rest. */
    private boolean isCarried(int k) {
        double forceX = rules.forces().x(bodies, k);
        double forceY = rules.forces().y(bodies, k);
        double x = bodies.x[k];
        double y = bodies.y[k];
        for (Wall wall : walls) {
            if (wall.normalX(x, y) * forceX + wall.normalY(x, y) * forceY > 0
                && wall.gap(x, y, bodies.radius[k]) * Rest.NEAR <= bodies.radius[k]) {
                return true;
            }
        }
        for (int i = 0; i < bodies.size(); i++) {
            double dx = bodies.x[i] - x;
            double dy = bodies.y[i] - y;
            double radii = bodies.radius[i] + bodies.radius[k];
            if (dx * forceX + dy * forceY > 0 && (Math.sqrt(dx * dx + dy * dy) - radii) * Rest.NEAR <= radii) {
                return true;
            }
        }
        return forceX == 0 && forceY == 0;
    }

    @Override
    public int[] ranks() {
        double[] scores = scores();
        return ranks((one, other) -> scores[one] > scores[other]);
    }

    /** Points; -1 for a player who is out. */
    @Override
    public double[] scores() {
        double[] scores = new double[points.length];
        for (int player = 0; player < scores.length; player++) {
            scores[player] = isIn(player) ? points[player] : -1;
        }
        return scores;
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    /** The discs as they were before the first turn, by id. */
    public List<Body> discs() {
        return discs;
    }

    /** The ids of a player's discs, ascending. */
    public int[] owned(int player) {
        return owned[player];
    }

    /** The block {@code play}. */
    public PlayRules rules() {
        return rules;
    }

    /** Points of a player, also of one who is out. */
    public long points(int player) {
        return points[player];
    }

    /** Turn; per disc place and speed, and its id where zones take discs out; per player points and turn of exit. */
    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int k = 0; k < discsLeft(); k++) {
            if (rules.removes()) {
                hash.add(bodies.id(k));
            }
            hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
        }
        for (int player = 0; player < points.length; player++) {
            hash.add(points[player]).add(outTurn(player));
        }
        return hash.value();
    }
}

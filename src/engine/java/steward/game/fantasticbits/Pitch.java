package steward.game.fantasticbits;

import java.util.Arrays;
import java.util.List;
import steward.numerics.JavaRandom;
import steward.numerics.StateHash;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.scene.Bumper;

/**
 * Everything on the pitch of Fantastic Bits: all bodies, and the spells of the wizards. Bodies are wizards 0..3 (two
 * for each player), snaffles, bludgers and goal posts, in this order. They are never removed, so that ids are indices.
 */
public final class Pitch {

    /** The width of the pitch, in u; its left upper corner is at (0, 0). */
    public static final double WIDTH = 16000;
    /** The height of the pitch, in u. */
    public static final double HEIGHT = 7500;
    /** The upper end of both goals, in u. */
    public static final double MOUTH_TOP = 1750;
    /** The lower end of both goals, in u. */
    public static final double MOUTH_BOTTOM = 5750;

    public static final int WIZARDS = 4;
    public static final int WIZARDS_PER_PLAYER = 2;
    /** The number of bludgers, where there are any. */
    public static final int BLUDGERS = 2;
    /** Most snaffles of a game: three pairs and one. */
    public static final int MOST_SNAFFLES = 7;
    /** For so many turns from a command on that moves a held snaffle, a wizard takes none. */
    static final int CAPTURE_WAIT = 3;

    /** The goal posts, in the order of their ids. */
    public static final List<Bumper> POSTS = List.of(post(0, MOUTH_TOP), post(0, MOUTH_BOTTOM),
        post(WIDTH, MOUTH_TOP), post(WIDTH, MOUTH_BOTTOM));

    /** Column of the bodies: the id of the snaffle that a wizard holds, or -1. */
    public static final int HELD = 0;
    /** Column of the bodies: a wizard takes no snaffle while this is above 0. */
    public static final int WAIT = 1;
    /** Column of the bodies: the id of the wizard that a bludger has hit last, or -1. */
    public static final int LAST_VICTIM = 2;
    /** Column of the bodies: the snaffles that a snaffle passes through, as bits; bit 0 is the first snaffle. */
    public static final int IGNORED = 3;
    private static final int COLUMNS = 4;

    private static final double SNAFFLE_RADIUS = EntityKind.SNAFFLE.radius();
    private static final double TOUCH = 4 * SNAFFLE_RADIUS * SNAFFLE_RADIUS;
    private static final double NEAREST_AT_START = 1250;
    private static final double BLUDGER_THRUST = 1000;
    private static final double MOST_SPELL_POWER = 1000;
    private static final double ACCIO_POWER = 3000;
    private static final double FLIPENDO_POWER = 6000;

    private final Bodies bodies;
    private final int snaffles;
    private final int bludgers;
    private final double[] thrustX;
    private final double[] thrustY;
    private final SpellBook spells = new SpellBook();
    private double unitX;
    private double unitY;

    /** Wizards and bludgers at their places, and snaffles at (0, 0). */
    Pitch(int snaffles, int bludgers) {
        this.snaffles = snaffles;
        this.bludgers = bludgers;
        bodies = new Bodies(WIZARDS + snaffles + bludgers + POSTS.size(), COLUMNS);
        thrustX = new double[bodies.capacity()];
        thrustY = new double[bodies.capacity()];
        for (int wizard = 0; wizard < WIZARDS; wizard++) {
            add(EntityKind.WIZARD, wizard < WIZARDS_PER_PLAYER ? 1000 : WIDTH - 1000, wizard % 3 == 0 ? 5250 : 2250);
        }
        for (int k = 0; k < snaffles; k++) {
            add(EntityKind.SNAFFLE, 0, 0);
        }
        for (int k = 0; k < bludgers; k++) {
            add(EntityKind.BLUDGER, 7450 + 1100 * k, HEIGHT / 2);
        }
        for (Bumper post : POSTS) {
            add(EntityKind.POST, post.x(), post.y());
        }
    }

    private static Bumper post(double x, double y) {
        return new Bumper(x, y, EntityKind.POST.radius(), 1);
    }

    private void add(EntityKind kind, double x, double y) {
        int body = bodies.add(x, y, kind.radius(), kind.mass());
        bodies.setKind(body, kind.ordinal());
        bodies.setDrag(body, kind.friction());
        bodies.columns[HELD][body] = -1;
        bodies.columns[LAST_VICTIM][body] = -1;
    }

    Pitch copy() {
        Pitch copy = new Pitch(snaffles, bludgers);
        copy.bodies.copyFrom(bodies);
        copy.spells.copyFrom(spells);
        return copy;
    }

    /**
     * A start. Draws 2 or 3 pairs of snaffles, each point-symmetric and at least 1250 u from those before; one more
     * stands in the middle.
     */
    static Pitch draw(long seed, int bludgers) {
        JavaRandom random = new JavaRandom(seed);
        int pairs = 2 + random.nextInt(2);
        Pitch pitch = new Pitch(2 * pairs + 1, bludgers);
        Bodies bodies = pitch.bodies;
        for (int next = WIZARDS; next < WIZARDS + 2 * pairs;) {
            double x = random.nextInt(5000) + 2000;
            double y = random.nextInt(6500) + 500;
            boolean free = true;
            for (int k = WIZARDS; k < next; k++) {
                double dx = bodies.x[k] - x;
                double dy = bodies.y[k] - y;
                free &= !(Math.sqrt(dx * dx + dy * dy) < NEAREST_AT_START);
            }
            if (free) {
                bodies.setPosition(next, x, y);
                bodies.setPosition(next + 1, WIDTH - x, HEIGHT - y);
                next += 2;
            }
        }
        bodies.setPosition(WIZARDS + 2 * pairs, WIDTH / 2, HEIGHT / 2);
        return pitch;
    }

    /** Steps of a turn's end: friction by kind, then whole numbers, halves away from zero. */
    public static List<Motion.Step> endOfTurn() {
        return List.of(Motion.Step.DRAG, Motion.Step.ROUND_POSITION_AWAY, Motion.Step.ROUND_VELOCITY);
    }

    /** The index of the first bludger among the bodies of a pitch; without any, that of the first post. */
    static int firstBludger(Bodies bodies) {
        int first = firstPost(bodies);
        while (bodies.kind[first - 1] == EntityKind.BLUDGER.ordinal()) {
            first--;
        }
        return first;
    }

    /** The index of the first goal post among the bodies of a pitch. */
    static int firstPost(Bodies bodies) {
        return bodies.size() - POSTS.size();
    }

    /** True if a height is between the posts of a goal. */
    static boolean isInMouth(double y) {
        return y >= MOUTH_TOP && y <= MOUTH_BOTTOM;
    }

    /** True if a snaffle is in a goal or so near its line that it has left the walls behind. */
    static boolean isInGoal(Bodies bodies, int snaffle) {
        double x = bodies.x[snaffle];
        return (x <= SNAFFLE_RADIUS || x >= WIDTH - SNAFFLE_RADIUS) && isInMouth(bodies.y[snaffle]);
    }

    /** True if a snaffle passes through another. */
    public static boolean ignores(Bodies bodies, int snaffle, int other) {
        return ((int) bodies.columns[IGNORED][snaffle] >> other - WIZARDS & 1) != 0;
    }

    /** Lets a snaffle pass through another: by the release of either, and in tests of the rules. */
    public static void ignore(Bodies bodies, int snaffle, int other) {
        bodies.columns[IGNORED][snaffle] = (int) bodies.columns[IGNORED][snaffle] | 1 << other - WIZARDS;
    }

    /** Forgets the thrusts of the turn before; spells count down and begin. */
    void beginTurn(Variant variant) {
        Arrays.fill(thrustX, 0);
        Arrays.fill(thrustY, 0);
        for (int wizard = 0; wizard < WIZARDS; wizard++) {
            spells.beginTurn(wizard, variant);
        }
        while (!bodies.passing().isEmpty()) {
            bodies.passing().remove(bodies.passing().size() - 1);
        }
    }

    /** A wizard moves or throws; spells are the game's. @param command one that is in order */
    void obey(int wizard, WizardCommand command) {
        if (command.action() == WizardCommand.Action.MOVE) {
            thrust(wizard, command);
        }
        if (Captures.holds(bodies, wizard)) {
            int snaffle = held(wizard);
            if (command.action() == WizardCommand.Action.THROW) {
                bodies.x[snaffle] = bodies.x[wizard];
                bodies.y[snaffle] = bodies.y[wizard];
                thrust(snaffle, command);
            }
            Captures.carry(bodies, wizard);
            bodies.columns[WAIT][wizard] = CAPTURE_WAIT;
        }
    }

    /** The unit vector is normalised twice, as the referee does: it changes last bits. */
    private void thrust(int body, WizardCommand command) {
        toUnit(command.x() - bodies.x[body], command.y() - bodies.y[body]);
        toUnit(unitX, unitY);
        thrustX[body] = unitX * command.power();
        thrustY[body] = unitY * command.power();
    }

    private void toUnit(double x, double y) {
        double length = Math.sqrt(x * x + y * y);
        unitX = length == 0 ? 0 : x / length;
        unitY = length == 0 ? 0 : y / length;
    }

    private void push(int body, double fx, double fy) {
        bodies.vx[body] += fx * bodies.inverseMass[body];
        bodies.vy[body] += fy * bodies.inverseMass[body];
    }

    /** The part of a turn before the motion. @return the number of snaffles in play */
    int update() {
        for (int k = WIZARDS; k < WIZARDS + snaffles; k++) {
            forgetSeparated(k);
        }
        for (int wizard = 0; wizard < WIZARDS; wizard++) {
            push(wizard, thrustX[wizard], thrustY[wizard]);
            if (Captures.holds(bodies, wizard)) {
                release(wizard);
            }
            int called = spells.target(wizard, Spell.ACCIO);
            if (called >= 0 && kind(called) == EntityKind.LOST_SNAFFLE) {
                spells.set(wizard, Spell.ACCIO, 0, -1);
            }
            bodies.columns[WAIT][wizard] -= bodies.columns[WAIT][wizard] > 0 ? 1 : 0;
        }
        int left = 0;
        for (int k = WIZARDS; k < WIZARDS + snaffles; k++) {
            left += kind(k) == EntityKind.LOST_SNAFFLE ? 0 : 1;
            push(k, thrustX[k], thrustY[k]);
        }
        for (int bludger = WIZARDS + snaffles; bludger < entities(); bludger++) {
            hunt(bludger);
        }
        applySpells();
        return left;
    }

    private void forgetSeparated(int snaffle) {
        int ignored = (int) bodies.columns[IGNORED][snaffle];
        for (int k = 0; k < snaffles; k++) {
            if ((ignored >> k & 1) != 0 && !(Captures.squared(bodies, snaffle, WIZARDS + k) <= TOUCH)) {
                ignored &= ~(1 << k);
            }
        }
        bodies.columns[IGNORED][snaffle] = ignored;
    }

    private void release(int wizard) {
        int snaffle = held(wizard);
        if (spells.target(wizard, Spell.ACCIO) == snaffle) {
            spells.set(wizard, Spell.ACCIO, 0, -1);
        }
        for (int k = WIZARDS; k < WIZARDS + snaffles; k++) {
            if (k != snaffle && Captures.squared(bodies, snaffle, k) <= TOUCH) {
                ignore(bodies, snaffle, k);
                ignore(bodies, k, snaffle);
            }
        }
        bodies.columns[HELD][wizard] = -1;
        if (kind(snaffle) == EntityKind.HELD_SNAFFLE) {
            bodies.kind[snaffle] = EntityKind.SNAFFLE.ordinal();
        }
    }

    /** A bludger heads for the nearest wizard but its last victim and the teams that it has forgotten. */
    private void hunt(int bludger) {
        int prey = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int wizard = 0; wizard < WIZARDS; wizard++) {
            if (bodies.columns[LAST_VICTIM][bludger] != wizard && !isForgotten(bludger, playerOf(wizard))) {
                double distance = Math.sqrt(Captures.squared(bodies, bludger, wizard));
                if (distance < least) {
                    prey = wizard;
                    least = distance;
                }
            }
        }
        if (prey >= 0) {
            toUnit(bodies.x[prey] - bodies.x[bludger], bodies.y[prey] - bodies.y[bludger]);
            thrustX[bludger] = unitX * BLUDGER_THRUST;
            thrustY[bludger] = unitY * BLUDGER_THRUST;
        }
        push(bludger, thrustX[bludger], thrustY[bludger]);
    }

    private boolean isForgotten(int bludger, int player) {
        for (int k = 0; k < WIZARDS_PER_PLAYER; k++) {
            if (spells.target(player * WIZARDS_PER_PLAYER + k, Spell.OBLIVIATE) == bludger) {
                return true;
            }
        }
        return false;
    }

    /** First all petrificus, then all accio, then all flipendo, each by the order of wizards. */
    private void applySpells() {
        for (int k = Spell.PETRIFICUS.ordinal(); k < Spell.count(); k++) {
            for (int wizard = 0; wizard < WIZARDS; wizard++) {
                int target = spells.target(wizard, Spell.of(k));
                if (target >= 0) {
                    apply(Spell.of(k), wizard, target);
                }
            }
        }
    }

    /** On exactly the same point the direction is (0, 0), and nothing is pushed. */
    private void apply(Spell spell, int wizard, int target) {
        if (spell == Spell.PETRIFICUS) {
            bodies.vx[target] = 0;
            bodies.vy[target] = 0;
            return;
        }
        int to = spell == Spell.ACCIO ? wizard : target;
        int from = wizard + target - to;
        double dx = bodies.x[to] - bodies.x[from];
        double dy = bodies.y[to] - bodies.y[from];
        double strength = spell == Spell.ACCIO ? ACCIO_POWER : FLIPENDO_POWER;
        double power = Math.min(strength * (1000000 / (dx * dx + dy * dy)), MOST_SPELL_POWER);
        toUnit(dx, dy);
        push(target, unitX * power, unitY * power);
    }

    public static int playerOf(int wizard) {
        return wizard / WIZARDS_PER_PLAYER;
    }

    public EntityKind kind(int entity) {
        return EntityKind.of(bodies.kind[entity]);
    }

    /** The id of the snaffle that a wizard holds, or -1. */
    public int held(int wizard) {
        return (int) bodies.columns[HELD][wizard];
    }

    /** The number of snaffles, those out of play included. */
    public int snaffles() {
        return snaffles;
    }

    /** The number of wizards, snaffles and bludgers: their ids come before those of the posts. */
    public int entities() {
        return WIZARDS + snaffles + bludgers;
    }

    /** Wizards, snaffles, bludgers, posts. */
    public Bodies bodies() {
        return bodies;
    }

    public SpellBook spells() {
        return spells;
    }

    /** Adds all entities that can move, with what they hold and ignore, and the spells to a hash. */
    void addTo(StateHash hash) {
        for (int k = 0; k < entities(); k++) {
            hash.add(bodies.kind[k]).add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
            for (int column = 0; column < COLUMNS; column++) {
                hash.add(bodies.columns[column][k]);
            }
        }
        spells.addTo(hash);
    }
}

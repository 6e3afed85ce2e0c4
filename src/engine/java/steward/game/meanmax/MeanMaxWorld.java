package steward.game.meanmax;

import java.util.ArrayList;
import java.util.List;
import steward.numerics.JavaRandom;
import steward.numerics.SineCosine;
import steward.numerics.StateHash;
import steward.physics.Bodies;

/**
 * Everything in the arena of Mean Max. Looters and tankers are bodies; wrecks and skill effects are places. All share
 * one counter of ids. Bodies stand in the order of their ids: looters from 0 on, player by player, then tankers.
 * Over 400 lines, because all steps of a turn work on the same bodies.
 */
public final class MeanMaxWorld {

    /** The radius of the arena, around (0, 0), in u. */
    public static final double ARENA_RADIUS = 6000;
    /** The radius of a looter, in u. */
    public static final double LOOTER_RADIUS = 400;
    /** How far from the caster the centre of a skill may be, in u. */
    public static final double SKILL_RANGE = 2000;
    /** The radius of a skill effect, in u. */
    public static final double SKILL_RADIUS = 1000;
    /** Within this distance of the centre tankers fill, in u. */
    public static final double WATER_RADIUS = 3000;
    /** The mass that a tar effect adds each turn. */
    static final double TAR_MASS = 10;

    /** Column of the bodies: the player, also the one that a tanker is spawned for. */
    public static final int OWNER = 0;
    /** Column of the bodies: the water of a tanker. */
    public static final int WATER = 1;
    /** Column of the bodies: the size of a tanker. */
    public static final int SIZE = 2;
    private static final int COLUMNS = 3;

    /** The share of an impulse that comes back. */
    public static final double RESTITUTION = 0.5;

    private static final double BIRTH_RADIUS = 8000;
    private static final double BIRTH_STEP = 600;
    private static final double BIRTH_POWER = 2000;
    private static final double WATER_MASS = 0.5;
    private static final double RADIUS_BY_SIZE = 50;
    private static final double TANKER_POWER = 500;
    private static final double GRENADE_POWER = -1000;
    /** More wrecks or effects at a time are rare. */
    private static final int SPARE = 16;
    private static final double EPSILON = 1e-5;

    private final Bodies bodies;
    private final List<Wreck> wrecks = new ArrayList<>();
    private final List<SkillEffect> effects = new ArrayList<>();
    /** Objects of wrecks and effects that are gone, for those to come: a turn allocates nothing. */
    private final List<Wreck> spareWrecks = new ArrayList<>();
    private final List<SkillEffect> spareEffects = new ArrayList<>();
    private final TankerQueue queue;
    private final MeanMaxSettings settings;
    private final int players;
    private final SineCosine direction = new SineCosine();

    /** @param capacity maximum number of bodies */
    MeanMaxWorld(MeanMaxSettings settings, int players, int capacity, TankerQueue queue) {
        this.settings = settings;
        this.players = players;
        this.queue = queue;
        bodies = new Bodies(capacity, COLUMNS);
        for (int k = 0; k < SPARE; k++) {
            spareWrecks.add(new Wreck());
            spareEffects.add(new SkillEffect());
        }
    }

    private MeanMaxWorld(MeanMaxWorld other) {
        settings = other.settings;
        players = other.players;
        queue = other.queue.copy();
        bodies = new Bodies(other.bodies.capacity(), COLUMNS);
        bodies.copyFrom(other.bodies);
        other.wrecks.forEach(wreck -> wrecks.add(wreck.copy()));
        other.effects.forEach(effect -> effects.add(effect.copy()));
    }

    MeanMaxWorld copy() {
        return new MeanMaxWorld(this);
    }

    /**
     * A start. Draws, in this order: tankers per player, 1..3; the queue of tankers; then the places of the looters,
     * for each kind a distance and an angle, all anew until no two are within 800 u.
     */
    static MeanMaxWorld draw(MeanMaxSettings settings, long seed, int players) {
        JavaRandom random = new JavaRandom(seed);
        int tankersByPlayer = 1 + random.nextInt(3);
        TankerQueue queue = new TankerQueue(random, players);
        int looters = settings.looters();
        MeanMaxWorld world = new MeanMaxWorld(settings, players, players * (looters + tankersByPlayer), queue);
        for (int looter = 0; looter < players * looters; looter++) {
            UnitKind kind = UnitKind.of(looter % looters);
            world.add(kind, looter / looters, 0, 0, LOOTER_RADIUS, kind.mass());
        }
        while (!world.placeLooters(random)) {
            for (int looter = 0; looter < players * looters; looter++) {
                world.bodies.setPosition(looter, 0, 0);
            }
        }
        for (int j = 0; j < tankersByPlayer; j++) {
            for (int player = 0; player < players; player++) {
                world.spawn(player);
            }
        }
        return world;
    }

    /** Adds a wreck. @param player for whom another comes when it is gone, or -1 */
    public void addWreck(int id, double x, double y, double radius, int water, int player) {
        Wreck wreck = spareWrecks.isEmpty() ? new Wreck() : spareWrecks.remove(spareWrecks.size() - 1);
        wrecks.add(wreck.set(id, x, y, radius, water, player));
    }

    /** Removes a wreck; its object serves the next one. */
    void removeWreck(int index) {
        spareWrecks.add(wrecks.remove(index));
    }

    /** @return false if two came too near, looters without a place at (0, 0) included */
    private boolean placeLooters(JavaRandom random) {
        for (int kind = 0; kind < settings.looters(); kind++) {
            double distance = random.nextDouble() * (ARENA_RADIUS - LOOTER_RADIUS);
            double share = random.nextDouble();
            for (int player = 0; player < players; player++) {
                int looter = looter(player, kind);
                direction.turn((player + share) * (Math.PI * 2.0 / 3));
                bodies.setPosition(looter, direction.cos() * distance, direction.sin() * distance);
                for (int other = 0; other < players * settings.looters(); other++) {
                    if (other != looter && distance(looter, bodies.x[other], bodies.y[other]) <= 2 * LOOTER_RADIUS) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    int add(UnitKind kind, int player, double x, double y, double radius, double mass) {
        int body = bodies.add(x, y, radius, mass);
        bodies.setKind(body, kind.ordinal());
        bodies.setDrag(body, kind.friction());
        bodies.setRestitution(body, RESTITUTION);
        bodies.columns[OWNER][body] = player;
        return body;
    }

    /**
     * Adds the next tanker of a player's queue, outside the arena; or the wreck that comes in its place, where there
     * are wrecks only.
     *
     * @return the index of the tanker, or -1 if none has come
     */
    int spawn(int player) {
        if (queue.left(player) == 0) {
            return -1;
        }
        int size = queue.size(player);
        direction.turn((player + queue.angle(player)) * Math.PI * 2.0 / 3);
        queue.take(player);
        double radius = LOOTER_RADIUS + RADIUS_BY_SIZE * size;
        if (settings.hasWrecksOnly()) {
            addWreck(bodies.takeId(), direction.cos() * WATER_RADIUS, direction.sin() * WATER_RADIUS, radius, size,
                player);
            return -1;
        }
        return addTanker(player, size, radius);
    }

    private int addTanker(int player, int size, double radius) {
        double from = BIRTH_RADIUS + radius;
        double x = direction.cos() * from;
        double y = direction.sin() * from;
        while (!isFree(x, y, radius)) {
            from += BIRTH_STEP;
            x = direction.cos() * from;
            y = direction.sin() * from;
        }
        int body = add(UnitKind.TANKER, player, x, y, radius, UnitKind.TANKER.mass() + WATER_MASS);
        bodies.columns[WATER][body] = 1;
        bodies.columns[SIZE][body] = size;
        thrust(body, 0, 0, BIRTH_POWER);
        return body;
    }

    private boolean isFree(double x, double y, double radius) {
        for (int unit = 0; unit < bodies.size(); unit++) {
            if (!(distance(unit, x, y) > bodies.radius[unit] + radius)) {
                return false;
            }
        }
        return true;
    }

    /** The distance of a unit's centre from a place. */
    double distance(int unit, double x, double y) {
        double dx = bodies.x[unit] - x;
        double dy = bodies.y[unit] - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Changes a unit's speed toward a place, or away from it if the power is below 0, by power / mass. */
    void thrust(int unit, double x, double y, double power) {
        double distance = distance(unit, x, y);
        if (Math.abs(distance) <= EPSILON) {
            return;
        }
        double share = power / bodies.mass[unit] / distance;
        bodies.vx[unit] += (x - bodies.x[unit]) * share;
        bodies.vy[unit] += (y - bodies.y[unit]) * share;
    }

    void cast(Skill skill, double x, double y, int looter) {
        insert(bodies.takeId(), skill, x, y, skill.turns(), bodies.id(looter));
    }

    void insert(int id, Skill skill, double x, double y, int duration, int looter) {
        int place = 0;
        while (place < effects.size() && effects.get(place).skill().compareTo(skill) <= 0) {
            place++;
        }
        SkillEffect effect = spareEffects.isEmpty() ? new SkillEffect() : spareEffects.remove(spareEffects.size() - 1);
        effects.add(place, effect.set(id, skill, x, y, duration, looter));
    }

    /** True if the centre of a place is so near that a unit is touched by an effect. */
    boolean isTouched(int unit, SkillEffect effect) {
        return distance(unit, effect.x(), effect.y()) <= SKILL_RADIUS + bodies.radius[unit];
    }

    boolean isInOil(int unit) {
        for (int k = 0; k < effects.size(); k++) {
            if (effects.get(k).skill() == Skill.OIL && isTouched(unit, effects.get(k))) {
                return true;
            }
        }
        return false;
    }

    /** All effects count down, then tar and grenades touch units; tar first, then oil, then grenades. */
    void applyEffects() {
        for (int k = 0; k < effects.size(); k++) {
            SkillEffect effect = effects.get(k);
            effect.countDown();
            for (int unit = 0; effect.skill() != Skill.OIL && unit < bodies.size(); unit++) {
                if (isTouched(unit, effect)) {
                    if (effect.skill() == Skill.TAR) {
                        bodies.setMass(unit, bodies.mass[unit] + TAR_MASS);
                    } else {
                        thrust(unit, effect.x(), effect.y(), GRENADE_POWER);
                    }
                }
            }
        }
    }

    /** Tankers steer: out when full, to the water while they are far from it. */
    void steerTankers() {
        for (int unit = 0; unit < bodies.size(); unit++) {
            if (isTanker(unit)) {
                if (bodies.columns[WATER][unit] >= bodies.columns[SIZE][unit]) {
                    thrust(unit, 0, 0, -TANKER_POWER);
                } else if (distance(unit, 0, 0) > WATER_RADIUS) {
                    thrust(unit, 0, 0, TANKER_POWER);
                }
            }
        }
    }

    /** Tankers near the centre take water; full ones outside the arena leave. @param leaving takes their indices */
    int fillTankers(int[] leaving) {
        int count = 0;
        for (int unit = 0; unit < bodies.size(); unit++) {
            if (!isTanker(unit)) {
                continue;
            }
            double distance = distance(unit, 0, 0);
            boolean full = bodies.columns[WATER][unit] >= bodies.columns[SIZE][unit];
            if (distance <= WATER_RADIUS && !full) {
                bodies.columns[WATER][unit]++;
                bodies.setMass(unit, bodies.mass[unit] + WATER_MASS);
            } else if (distance >= BIRTH_RADIUS + bodies.radius[unit] && full) {
                leaving[count++] = unit;
            }
        }
        return count;
    }

    /** Tar wears off at the end of a turn. */
    void restoreMasses() {
        for (int unit = 0; unit < bodies.size(); unit++) {
            while (bodies.mass[unit] >= TAR_MASS) {
                bodies.setMass(unit, bodies.mass[unit] - TAR_MASS);
            }
        }
    }

    /** Effects that have worked for their last turn go. */
    void removeSpentEffects() {
        for (int k = effects.size() - 1; k >= 0; k--) {
            if (effects.get(k).duration() <= 0) {
                spareEffects.add(effects.remove(k));
            }
        }
    }

    /** The index of a player's looter. @param kind 0 reaper, 1 destroyer, 2 doof */
    public int looter(int player, int kind) {
        return player * settings.looters() + kind;
    }

    public boolean isTanker(int unit) {
        return bodies.kind[unit] == UnitKind.TANKER.ordinal();
    }

    /** Looters and tankers. */
    public Bodies bodies() {
        return bodies;
    }

    /** Wrecks in the order of their creation. */
    public List<Wreck> wrecks() {
        return wrecks;
    }

    /** Skill effects: tar, oil, grenades, each in the order of their creation. */
    public List<SkillEffect> effects() {
        return effects;
    }

    /** The tankers that are still to come. */
    public TankerQueue queue() {
        return queue;
    }

    /** Adds the whole world to a hash: the counter of ids, units, wrecks, effects, the tankers to come. */
    void addTo(StateHash hash) {
        hash.add(bodies.nextId());
        for (int unit = 0; unit < bodies.size(); unit++) {
            hash.add(bodies.id(unit)).add(bodies.kind[unit]).add(bodies.x[unit]).add(bodies.y[unit])
                .add(bodies.vx[unit]).add(bodies.vy[unit]).add(bodies.mass[unit]).add(bodies.radius[unit])
                .add(bodies.columns[OWNER][unit]).add(bodies.columns[WATER][unit]).add(bodies.columns[SIZE][unit]);
        }
        for (int k = 0; k < wrecks.size(); k++) {
            Wreck wreck = wrecks.get(k);
            hash.add(wreck.id()).add(wreck.x()).add(wreck.y()).add(wreck.radius()).add(wreck.water());
            if (settings.hasWrecksOnly()) {
                hash.add(wreck.player());
            }
        }
        for (int k = 0; k < effects.size(); k++) {
            SkillEffect effect = effects.get(k);
            hash.add(effect.id()).add(effect.skill().type()).add(effect.x()).add(effect.y()).add(effect.duration())
                .add(effect.looter());
        }
        queue.addTo(hash);
    }
}

package steward.game.pokerchiprace;

import java.util.Arrays;
import steward.numerics.SineCosine;
import steward.numerics.StateHash;
import steward.physics.Bodies;
import steward.physics.PassingPairs;
import steward.physics.TurnSink;

/**
 * All chips on the table, which are bodies in the order of their ids, and the lists of chips that the players own. A
 * chip that was eaten in the last turn stays in its owner's list until {@link #forgetEaten}. The mass of a chip is its
 * area r * r * pi.
 */
public final class ChipTable {

    /** Half the width of the table, around (0, 0), in u. */
    public static final double HALF_WIDTH = 400;
    /** Half the height of the table, in u. */
    public static final double HALF_HEIGHT = 257.5;
    /** The greatest radius of a chip that is too small to push itself, in u. */
    public static final double SMALL = 5;

    /** Column of the bodies: the player who owns a chip, {@link #NEUTRAL} for none. */
    public static final int OWNER = 0;
    /** Column of the bodies: the id of the chip that it was ejected from in this turn, -1 for none. */
    public static final int PARENT = 1;
    public static final int NEUTRAL = -1;
    private static final int COLUMNS = 2;

    /** The area of an eaten chip that still stands in a list: the referee marks it by a radius of -1. */
    private static final double EATEN_AREA = -1.0 * -1.0 * Math.PI;
    /** The share of its area that a chip ejects. */
    private static final double EJECTED = 1f / 15f;
    /** The momentum of an ejected chip by its area, in u per turn. */
    private static final double EJECTION_SPEED = 200;

    private final Bodies bodies;
    private final int[][] own;
    private final int[] owned;
    private final SineCosine direction = new SineCosine();

    /** @param capacity maximum number of chips */
    ChipTable(int players, int capacity) {
        bodies = new Bodies(capacity, COLUMNS);
        own = new int[players][4];
        owned = new int[players];
    }

    private ChipTable(ChipTable other) {
        bodies = other.bodies.copy();
        own = new int[other.own.length][];
        for (int player = 0; player < own.length; player++) {
            own[player] = other.own[player].clone();
        }
        owned = other.owned.clone();
    }

    ChipTable copy() {
        return new ChipTable(this);
    }

    /** Takes ids until the next one is this. */
    public void takeIdsUpTo(int next) {
        while (bodies.nextId() < next) {
            bodies.takeId();
        }
    }

    /**
     * Adds a chip at the end of the list of chips, and of its owner's list.
     *
     * @param owner {@link #NEUTRAL} for none
     * @return its index
     */
    public int add(int owner, double radius, double x, double y, double vx, double vy) {
        int chip = bodies.add(x, y, radius, area(radius));
        bodies.setVelocity(chip, vx, vy);
        bodies.columns[OWNER][chip] = owner;
        bodies.columns[PARENT][chip] = -1;
        if (owner != NEUTRAL) {
            if (owned[owner] == own[owner].length) {
                own[owner] = Arrays.copyOf(own[owner], 2 * owned[owner]);
            }
            own[owner][owned[owner]++] = bodies.id(chip);
        }
        return chip;
    }

    /** The area of a chip, left to right as the referee computes it. */
    static double area(double radius) {
        return radius * radius * Math.PI;
    }

    /** Gives a chip the radius of a circle with this area, and the mass of the circle with that radius. */
    static void setArea(Bodies bodies, int chip, double area) {
        double radius = Math.sqrt(area / Math.PI);
        bodies.setRadius(chip, radius);
        bodies.setMass(chip, area(radius));
    }

    /** Chips forget what they were ejected from. */
    void forgetParents() {
        Arrays.fill(bodies.columns[PARENT], 0, bodies.size(), -1);
    }

    /** Players' lists lose the chips that were eaten. */
    void forgetEaten() {
        for (int player = 0; player < own.length; player++) {
            int left = 0;
            for (int k = 0; k < owned[player]; k++) {
                if (bodies.indexOf(own[player][k]) >= 0) {
                    own[player][left++] = own[player][k];
                }
            }
            owned[player] = left;
        }
    }

    /** The chips of a player become neutral. */
    void abandon(int player) {
        for (int k = 0; k < owned[player]; k++) {
            int chip = bodies.indexOf(own[player][k]);
            if (chip >= 0) {
                bodies.columns[OWNER][chip] = NEUTRAL;
            }
        }
        owned[player] = 0;
    }

    boolean isWithoutChips(int player) {
        for (int k = 0; k < owned[player]; k++) {
            if (bodies.indexOf(own[player][k]) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** The sum of the areas of a player's list; one that was eaten in this turn counts pi. */
    double areaOf(int player) {
        double sum = 0.0;
        for (int k = 0; k < owned[player]; k++) {
            int chip = bodies.indexOf(own[player][k]);
            sum += chip >= 0 ? area(bodies.radius[chip]) : EATEN_AREA;
        }
        return sum;
    }

    /** Returns how many chips stand in a player's list. */
    public int owned(int player) {
        return owned[player];
    }

    /** The id of the k-th chip in a player's list. */
    public int ownId(int player, int k) {
        return own[player][k];
    }

    /** The index of the k-th chip in a player's list; negative if it was eaten in this turn. */
    public int ownChip(int player, int k) {
        return bodies.indexOf(own[player][k]);
    }

    /** The player who owns a chip, or {@link #NEUTRAL}. */
    public int owner(int chip) {
        return (int) bodies.columns[OWNER][chip];
    }

    /**
     * A chip ejects a part of itself and moves the other way.
     *
     * @param angle to which it is pushed, in radians
     * @param sink  learns where the chips were
     * @return the index of the new chip
     */
    int push(int id, double angle, TurnSink sink) {
        int chip = bodies.indexOf(id);
        direction.turn(angle);
        double cos = direction.cos();
        double sin = direction.sin();
        double ejected = area(bodies.radius[chip]) * EJECTED;
        setArea(bodies, chip, area(bodies.radius[chip]) - ejected);
        double radius = Math.sqrt(ejected / Math.PI);
        double distance = bodies.radius[chip] - radius;
        int part = add(NEUTRAL, radius, bodies.x[chip] - cos * distance, bodies.y[chip] - sin * distance,
            bodies.vx[chip], bodies.vy[chip]);
        double strength = EJECTION_SPEED * area(radius);
        double px = cos * strength;
        double py = sin * strength;
        double inverse = 1 / area(bodies.radius[chip]);
        double inversePart = 1 / area(radius);
        bodies.vx[chip] += px * inverse;
        bodies.vy[chip] += py * inverse;
        bodies.vx[part] += px * -1 * inversePart;
        bodies.vy[part] += py * -1 * inversePart;
        bodies.columns[PARENT][part] = id;
        sink.knot(bodies.id(part), 0, bodies.x[part], bodies.y[part]);
        return part;
    }

    /** All chips in play. */
    public Bodies bodies() {
        return bodies;
    }

    /** Adds the whole table to a hash: the counter of ids, chips, lists, pairs that remember their contact. */
    void addTo(StateHash hash) {
        hash.add(bodies.nextId()).add(bodies.size());
        for (int chip = 0; chip < bodies.size(); chip++) {
            hash.add(bodies.id(chip)).add(bodies.columns[OWNER][chip]).add(bodies.x[chip]).add(bodies.y[chip])
                .add(bodies.vx[chip]).add(bodies.vy[chip]).add(bodies.radius[chip]);
        }
        for (int player = 0; player < own.length; player++) {
            hash.add(owned[player]);
            for (int k = 0; k < owned[player]; k++) {
                hash.add(own[player][k]);
            }
        }
        PassingPairs pairs = bodies.passing();
        hash.add(pairs.size());
        for (int k = 0; k < pairs.size(); k++) {
            hash.add(pairs.first(k)).add(pairs.second(k));
        }
    }
}

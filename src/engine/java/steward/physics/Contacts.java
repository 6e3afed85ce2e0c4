package steward.physics;

import java.util.Arrays;

/**
 * Table of what contacts do, per pair of kinds of bodies and per kind against walls: nothing, bounce, or ask the game.
 * Symmetric; immutable except for the {@code set} methods, which are for building it.
 */
public final class Contacts {

    /** Treatment of a touch of two bodies, or of a body and a wall. */
    public enum Meaning {
        /** Nothing: the two ignore each other. */
        NONE,
        /** An impact under the scene's law. */
        BOUNCE,
        /** The scene's {@link Reaction} decides. */
        ASK
    }

    private final int kinds;
    private final Meaning[] pairs;
    private final Meaning[] walls;
    /** Distances of centres at which contacts begin, NaN where it is the sum of the radii; null if there are none. */
    private double[] reaches;

    /**
     * All kinds bounce off each other and off walls.
     *
     * @param kinds how many kinds of bodies there are, at least 1
     */
    public Contacts(int kinds) {
        if (kinds < 1) {
            throw new IllegalArgumentException(kinds + " kinds, expected at least 1");
        }
        this.kinds = kinds;
        pairs = new Meaning[kinds * kinds];
        walls = new Meaning[kinds];
        java.util.Arrays.fill(pairs, Meaning.BOUNCE);
        java.util.Arrays.fill(walls, Meaning.BOUNCE);
    }

    /** Sets what a contact between two kinds means, in either order. */
    public Contacts set(int kindA, int kindB, Meaning meaning) {
        pairs[kindA * kinds + kindB] = meaning;
        pairs[kindB * kinds + kindA] = meaning;
        return this;
    }

    /**
     * Lets the {@link Reaction} decide contacts between two kinds that begin at a distance of their own instead of the
     * sum of the radii: a pick-up, a goal. Where the reaction answers {@code BOUNCE}, the impact is one at this
     * distance.
     *
     * @param distance of the centres, in u, above 0
     * @throws IllegalArgumentException if the distance is out of range
     */
    public Contacts askWithin(int kindA, int kindB, double distance) {
        if (!(distance > 0 && distance < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("distance " + distance + ", expected finite and above 0");
        }
        if (reaches == null) {
            reaches = new double[kinds * kinds];
            java.util.Arrays.fill(reaches, Double.NaN);
        }
        reaches[kindA * kinds + kindB] = distance;
        reaches[kindB * kinds + kindA] = distance;
        return set(kindA, kindB, Meaning.ASK);
    }

    /** True if any contact begins at a distance of its own. */
    public boolean hasReaches() {
        return reaches != null;
    }

    /** The distance of centres at which contacts of two kinds begin, or NaN where it is the sum of the radii. */
    public double reach(int kindA, int kindB) {
        return reaches == null ? Double.NaN : reaches[kindA * kinds + kindB];
    }

    public Contacts setWall(int kind, Meaning meaning) {
        walls[kind] = meaning;
        return this;
    }

    public int kinds() {
        return kinds;
    }

    /** Returns the meaning of a contact of two kinds, in either order. */
    public Meaning between(int kindA, int kindB) {
        return pairs[kindA * kinds + kindB];
    }

    public Meaning withWall(int kind) {
        return walls[kind];
    }

    /** True if any entry is {@code ASK}: only then a scene needs a {@link Reaction}. */
    public boolean containsAsk() {
        return contains(pairs, Meaning.ASK) || contains(walls, Meaning.ASK);
    }

    /** True if any two kinds of bodies react: only then pairs are scanned. */
    public boolean bodiesMeet() {
        return contains(pairs, Meaning.BOUNCE) || contains(pairs, Meaning.ASK);
    }

    /** True if any kind of body reacts to walls. */
    public boolean wallsMeet() {
        return contains(walls, Meaning.BOUNCE) || contains(walls, Meaning.ASK);
    }

    /** True if every entry is {@code BOUNCE}: then no contact has to be looked up. */
    public boolean allBounce() {
        return !contains(pairs, Meaning.NONE) && !contains(walls, Meaning.NONE) && !containsAsk();
    }

    private static boolean contains(Meaning[] table, Meaning meaning) {
        return Arrays.asList(table).contains(meaning);
    }
}

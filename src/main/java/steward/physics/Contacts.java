package steward.physics;

/**
 * What a contact means, per pair of kinds of bodies and per kind against walls. Symmetric; immutable but for the
 * {@code set} methods, which are for building it.
 */
public final class Contacts {

    /** What happens when two bodies, or a body and a wall, touch. */
    public enum Meaning {
        /** Nothing: they ignore each other. */
        NONE,
        /** An impact under the scene's law. */
        BOUNCE,
        /** The scene's {@link Reaction} is asked. */
        ASK
    }

    private final int kinds;
    private final Meaning[] pairs;
    private final Meaning[] walls;

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

    /** Says what a contact between two kinds means; the order of the two does not matter. */
    public Contacts set(int kindA, int kindB, Meaning meaning) {
        pairs[kindA * kinds + kindB] = meaning;
        pairs[kindB * kinds + kindA] = meaning;
        return this;
    }

    /** Says what a contact between a kind and any wall means. */
    public Contacts setWall(int kind, Meaning meaning) {
        walls[kind] = meaning;
        return this;
    }

    /** How many kinds of bodies there are. */
    public int kinds() {
        return kinds;
    }

    /** What a contact of two kinds means, in either order. */
    public Meaning between(int kindA, int kindB) {
        return pairs[kindA * kinds + kindB];
    }

    /** What a contact of a kind with any wall means. */
    public Meaning withWall(int kind) {
        return walls[kind];
    }

    /** Whether any contact asks: only then does a scene need a {@link Reaction}. */
    public boolean ask() {
        return contains(pairs, Meaning.ASK) || contains(walls, Meaning.ASK);
    }

    /** Whether any two bodies meet: only then are pairs looked at. */
    public boolean bodiesMeet() {
        return contains(pairs, Meaning.BOUNCE) || contains(pairs, Meaning.ASK);
    }

    /** Whether any body meets walls. */
    public boolean wallsMeet() {
        return contains(walls, Meaning.BOUNCE) || contains(walls, Meaning.ASK);
    }

    /** Whether every body bounces off everything: then nobody needs to look anything up. */
    public boolean allBounce() {
        return !contains(pairs, Meaning.NONE) && !contains(walls, Meaning.NONE) && !ask();
    }

    private static boolean contains(Meaning[] table, Meaning meaning) {
        for (Meaning entry : table) {
            if (entry == meaning) {
                return true;
            }
        }
        return false;
    }
}

package steward.game.fantasticbits;

/**
 * Kinds of bodies in Fantastic Bits, in the order of their numbers as {@link steward.physics.Bodies#kind}. A snaffle
 * changes its kind when a wizard takes or releases it and when it leaves play, since that changes its contacts.
 */
public enum EntityKind {

    /** Belongs to a player and obeys commands. */
    WIZARD("wizard", 400, 1, 0.25),
    /** A snaffle in play that no wizard holds. */
    SNAFFLE("snaffle", 150, 0.5, 0.25),
    /** Hunts wizards. */
    BLUDGER("bludger", 200, 8, 0.1),
    /** A corner of a goal, which never moves. */
    POST("post", 300, Double.POSITIVE_INFINITY, 0),
    /** A snaffle in play that a wizard holds: only bludgers meet it. */
    HELD_SNAFFLE("snaffle", 150, 0.5, 0.25),
    /** A snaffle that went through a goal: it coasts on, and only bludgers meet it. */
    LOST_SNAFFLE("snaffle", 150, 0.5, 0.25);

    private static final EntityKind[] ALL = values();

    private final String text;
    private final double radius;
    private final double mass;
    private final double friction;

    EntityKind(String text, double radius, double mass, double friction) {
        this.text = text;
        this.radius = radius;
        this.mass = mass;
        this.friction = friction;
    }

    public static EntityKind of(int number) {
        return ALL[number];
    }

    /** Its name in frames. */
    public String text() {
        return text;
    }

    /** Its radius, in u. */
    public double radius() {
        return radius;
    }

    public double mass() {
        return mass;
    }

    /** The share of its speed that it loses at the end of a turn. */
    public double friction() {
        return friction;
    }
}

package steward.game.meanmax;

import java.util.Locale;

/** Kinds of bodies in Mean Max, in the order of their numbers in frames and of {@link steward.physics.Bodies#kind}. */
public enum UnitKind {

    /** Harvests water; its skill is tar. */
    REAPER(0.5, 0.20),
    /** Sinks tankers; its skill is the grenade. */
    DESTROYER(1.5, 0.30),
    /** Collects rage; its skill is oil. */
    DOOF(1.0, 0.25),
    /** Brings water and has no owner; the border does not stop it. Its radius grows with its size. */
    TANKER(2.5, 0.40);

    /** Kinds whose bodies are steered by a player. */
    public static final int LOOTERS = 3;

    private static final UnitKind[] ALL = values();

    private final double mass;
    private final double friction;
    private final String text = name().toLowerCase(Locale.ROOT);

    UnitKind(double mass, double friction) {
        this.mass = mass;
        this.friction = friction;
    }

    /** The kind with this number, 0..3. */
    public static UnitKind of(int number) {
        return ALL[number];
    }

    /** Its mass; that of a tanker without water. */
    public double mass() {
        return mass;
    }

    /** The share of its speed that it loses at the end of a turn outside oil. */
    public double friction() {
        return friction;
    }

    /** The skill of a looter. */
    public Skill skill() {
        return switch (this) {
            case REAPER -> Skill.TAR;
            case DESTROYER -> Skill.GRENADE;
            case DOOF -> Skill.OIL;
            default -> throw new IllegalStateException("a tanker has no skill");
        };
    }

    /** Its name in frames. */
    public String text() {
        return text;
    }
}

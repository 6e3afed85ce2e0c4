package steward.scene;

/**
 * A part of the engine that a scene may need.
 *
 * @param in   whether the scene needs it; what is left out costs nothing
 * @param why  what in the scene asks for it, or what is absent
 * @param when the phase of a turn in which it works
 */
public record Part(String name, boolean in, String why, When when) {

    /** Bodies have impacts with each other. */
    public static final String PAIR_IMPACTS = "pair impacts";
    /** Bodies have impacts with walls. */
    public static final String WALLS = "walls";
    /** Some impacts have a restitution below 1. */
    public static final String RESTITUTION = "restitution";
    /** Weak impacts get a minimum impulse. */
    public static final String MINIMUM_IMPULSE = "minimum impulse";
    /** Positional correction: overlapping bodies are moved apart. */
    public static final String PUSH_OUT = "push-out";
    /** Separating pairs react, and impacts close in time react together. */
    public static final String BATCH_WINDOW = "batch window";
    /** No impulse moves some bodies. */
    public static final String INFINITE_MASSES = "infinite masses";
    /** Bodies lose a share of their speed each turn. */
    public static final String DRAG = "drag";
    /** Velocities end a turn as whole numbers. */
    public static final String VELOCITY_ROUNDING = "velocity rounding";
    /** Positions end a turn as whole numbers. */
    public static final String POSITION_ROUNDING = "position rounding";
    /** The game decides some contacts. */
    public static final String REACTIONS = "reactions";
    /** Pairs that cannot meet are set aside without a time of impact. */
    public static final String BROAD_PHASE = "broad phase";

    /** The phase of a turn in which a part works. */
    public enum When {
        /** In the game, when commands are applied, before the advance. */
        COMMANDS,
        /** In the advance. */
        PHYSICS,
        /** In the game, after the advance. */
        OUTCOME
    }

    /** A part of the physics. */
    public Part(String name, boolean in, String why) {
        this(name, in, why, When.PHYSICS);
    }
}

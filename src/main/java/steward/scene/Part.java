package steward.scene;

/**
 * A part of the engine that a scene may need.
 *
 * @param name what it is
 * @param in   whether the scene needs it; what is left out costs nothing
 * @param why  what in the scene asks for it, or what is absent
 * @param when in a turn it has its work
 */
public record Part(String name, boolean in, String why, When when) {

    /** Bodies run into each other. */
    public static final String PAIR_IMPACTS = "pair impacts";
    /** Bodies run into what never moves. */
    public static final String WALLS = "walls";
    /** Some impacts give back less than all of an approach. */
    public static final String RESTITUTION = "restitution";
    /** Weak impacts are made stronger. */
    public static final String MINIMUM_IMPULSE = "minimum impulse";
    /** Those that overlap are pushed apart. */
    public static final String PUSH_OUT = "push-out";
    /** Separating pairs react, and impacts close in time react together. */
    public static final String BATCH_WINDOW = "batch window";
    /** Some bodies are moved by no impulse. */
    public static final String INFINITE_MASSES = "infinite masses";
    /** Bodies lose a share of their speed each turn. */
    public static final String DRAG = "drag";
    /** Velocities end a turn as whole numbers. */
    public static final String VELOCITY_ROUNDING = "velocity rounding";
    /** Positions end a turn as whole numbers. */
    public static final String POSITION_ROUNDING = "position rounding";
    /** Some contacts ask the game. */
    public static final String REACTIONS = "reactions";
    /** Pairs that cannot meet are set aside without a time of impact. */
    public static final String BROAD_PHASE = "broad phase";

    /** When in a turn a part has its work. */
    public enum When {
        /** In the game, when commands are carried out, before bodies fly. */
        COMMANDS,
        /** In the physics. */
        PHYSICS,
        /** In the game, after bodies have flown. */
        OUTCOME
    }

    /** A part of the physics. */
    public Part(String name, boolean in, String why) {
        this(name, in, why, When.PHYSICS);
    }
}

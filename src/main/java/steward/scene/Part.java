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

    public static final String PAIR_IMPACTS = "pair impacts";
    public static final String WALLS = "walls";
    public static final String RESTITUTION = "restitution";
    public static final String MINIMUM_IMPULSE = "minimum impulse";
    public static final String PUSH_OUT = "push-out";
    public static final String BATCH_WINDOW = "batch window";
    public static final String INFINITE_MASSES = "infinite masses";
    public static final String DRAG = "drag";
    public static final String VELOCITY_ROUNDING = "velocity rounding";
    public static final String POSITION_ROUNDING = "position rounding";
    public static final String REACTIONS = "reactions";
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

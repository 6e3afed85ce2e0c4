package steward.scene.price;

/**
 * The price of a part.
 *
 * @param part  its name
 * @param in    whether the scene has it; otherwise it was added to the whole scene
 * @param nanos nanoseconds a turn, or a share of the turn where shares are stored; below 0 for a part that saves time
 * @param error by how much that may be wrong: half of the range of the repeats
 */
public record PartPrice(String part, boolean in, double nanos, double error) {

    /** Name of a turn in which every body flies straight: the price that the others are added to. */
    public static final String EMPTY = "flying straight";
}

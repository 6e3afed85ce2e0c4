package steward.replay.verify;

/**
 * The impacts of an imported match, compared with ours.
 *
 * @param equal   time and impulse are equal to the last bit
 * @param within  they lie in the range that moving each sine and cosine of the turn by a unit in the last place reaches
 * @param outside they do not; then the replay differs
 * @param shown   all that the server shows of them is equal, in the digits that it shows: of a game whose impacts are
 *                not recorded in full
 */
public record ImpactCounts(int equal, int within, int outside, int shown) {

    public static final ImpactCounts NONE = new ImpactCounts(0, 0, 0, 0);
}

/**
 * Circles that fly straight, touch at an exact time and exchange impulses: what a game's author needs. Bodies, walls,
 * the law of impact, contacts and reactions, observers of a turn, and {@link steward.physics.Advance}, the way to
 * advance a turn. No games, JSON, processes, files or clocks. The implementation is in the sub-packages {@code time},
 * {@code impulse}, {@code event} and {@code queue}, each above the one before.
 *
 * <p>Units: lengths in u, time in turns (speeds in u per turn), mass in pod masses, impulses in pod masses times u
 * per turn. One call of {@link steward.physics.Advance#turn} is one turn, from t = 0 to t = 1.
 *
 * <p>Begin with {@link steward.physics.TextbookSimulator}: the whole idea on a screen. Our forms of its steps, in this
 * order:
 * <ul>
 * <li>{@code timeToHit}: {@code time.CircleTime}, the same quadratic in forms that cancel less, and {@code
 *     time.ExactPairs}, which is never wrong; of walls {@code time.TimeOfImpact};
 * <li>{@code bounce}: {@code impulse.Impulse}, which knows restitution and a minimum, then {@code impulse.Collision}
 *     and {@code impulse.Rest} for heaps that would bounce for ever;
 * <li>moving all discs to {@code now}: {@code event.Flights}, where only those move that have an impact;
 * <li>{@code predict} and the queue for few bodies: {@code event.FlightSearch}, a row for each body, and {@code
 *     event.FlightLoop}, the loop of {@code play};
 * <li>the same for many: {@code queue.Cells}, so that only neighbours are predicted, {@code queue.EventBuckets}, the
 *     queue with one event a body, and {@code queue.QueueAdvance}, the loop, which knows stale events as here;
 * <li>what the textbook leaves to chance: impacts at one time, {@code time.SimultaneousImpacts}.
 * </ul>
 */
package steward.physics;

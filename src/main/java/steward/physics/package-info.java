/**
 * Circles that fly straight, touch at an exact time and exchange impulses: what a game's author needs. Bodies, walls,
 * the law of impact, contacts and reactions, observers of a turn, and {@link steward.physics.Advance}, the way to
 * advance a turn. No games, JSON, processes, files or clocks. The implementation is in the sub-packages {@code time},
 * {@code impulse}, {@code event} and {@code queue}, each above the one before.
 *
 * <p>Units: lengths in u, time in turns (speeds in u per turn), mass in pod masses, impulses in pod masses times u
 * per turn. One call of {@link steward.physics.Advance#turn} is one turn, from t = 0 to t = 1.
 */
package steward.physics;

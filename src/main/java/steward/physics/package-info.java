/**
 * Circles that fly straight, touch at an exact time and exchange impulses. Bodies, walls, the time of impact, the
 * law of impact and the ways to advance a turn; no games, JSON, processes, files or clocks.
 *
 * <p>Units: lengths in u, time in turns (speeds in u per turn), mass in pod masses, impulses in pod masses times u
 * per turn. One call of {@link steward.physics.Advance#turn} is one turn, from t = 0 to t = 1.
 */
package steward.physics;

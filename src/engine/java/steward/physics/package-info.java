/**
 * Physics of circles that fly straight, touch at an exact time and exchange impulses, for authors of games. It has
 * bodies, walls, the law of impact, contacts and reactions, observers of a turn, and {@link steward.physics.Advance},
 * the way to advance a turn. It knows no games, JSON, processes, files or clocks. The implementation is in the
 * sub-packages {@code time}, {@code impulse} and {@code event}, each above the one before.
 *
 * <p>Units: lengths in u, time in turns (speeds in u per turn), mass in pod masses, impulses in pod masses times u
 * per turn. One call of {@link steward.physics.Advance#turn} is one turn, from t = 0 to t = 1.
 *
 * <p>How a turn is computed, in the order in which to read it:
 * <ol>
 * <li><em>The whole idea</em> is a screen long: {@code play} of {@link steward.physics.TextbookSimulator}. Predict the
 *     impacts of all discs, take the earliest, move all discs there, let its two bounce, predict these two anew.
 * <li><em>The loop</em> is {@code event.EventLoop}, the only one for laws in which one impact happens at a time:
 * <pre>
 *     startAll                      all flights begin, and the impacts of all bodies are predicted
 *     while there is a next         the earliest impact; if there is none in this turn: endAll
 *         at the bound on impacts   event.Standstill ends the turn without impulses
 *         flyToImpact               its two bodies, and no others
 *         show                      the two as the law of impact sees them
 *         settles or respond        a heap comes to rest, or the two react; if others were altered: startAll
 *         take, predictAfter        the two fly on, and their next impacts are predicted
 * </pre>
 *     A body has a local clock and is moved only at its own impacts, {@code event.flight.FreeFlights}, or if all
 *     flights begin anew. In the arithmetic {@code EXACT} impacts of one instant are collected first; they react in the
 *     order of their pairs, the lowest indices first.
 * <li><em>Neighbours</em>, of which the loop knows nothing. Few bodies: {@code event.pairs}, a row of the table of all
 *     pairs for each body; rows in which something has changed are searched again. Many: {@code event.cells}, where
 *     only bodies of adjacent cells are predicted, in a queue with one event a body. A prediction with a partner whose
 *     flight has changed since is stale: when it is due, its body is predicted anew. Both give the same impacts, bit
 *     for bit.
 * <li><em>Arithmetic</em>: {@code timeToHit} is {@code time.CircleTime}, the same quadratic in forms that cancel less,
 *     and {@code time.ExactPairs}, which is never wrong; {@code time.SimultaneousImpacts} decides if two times are one.
 *     {@code event.flight.ImpactSearch} keeps the earliest. {@code bounce} is {@code impulse.Impulse}, which knows
 *     restitution and a minimum, and {@code impulse.Collision} around it.
 * <li><em>Rest</em>, which the textbook lacks: {@code impulse.Rest}, for heaps that would bounce for ever.
 * </ol>
 * Other laws and rungs have loops of their own: {@code event.BatchLoop}, {@code event.OfficialLoop},
 * {@code event.StepAdvance}.
 */
package steward.physics;

/** Everything of the game {@code bodies} that reads or writes text: its scenes, frames, answers, states and drawing. */
@Internal
package steward.game.bodies.protocol;

import steward.Internal;

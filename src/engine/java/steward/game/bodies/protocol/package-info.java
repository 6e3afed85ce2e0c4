/** Everything of the game {@code bodies} that reads or writes text: its scenes, frames, answers, states and drawing. */
package steward.game.bodies.protocol;


/** Protocol of the game {@code bodies}: scenes, frames, answers, states and drawing. */
package steward.game.bodies.protocol;


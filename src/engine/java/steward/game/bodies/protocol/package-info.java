/** Reading and writing of text for the game {@code bodies}: its scenes, frames, answers, states and drawing. */
package steward.game.bodies.protocol;


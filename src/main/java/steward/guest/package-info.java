/** Games whose referee is a program of its own, behind {@link steward.game.Game}; no particular contest. */
package steward.guest;

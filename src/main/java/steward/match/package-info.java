/**
 * The referee loop for any number of players, and the result of a match. It knows games only through
 * {@link steward.game.Game}, bots only through {@link steward.bot.Player}, and does not know how matches are stored.
 */
package steward.match;

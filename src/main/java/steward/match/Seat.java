package steward.match;

import steward.bot.Player;

/**
 * A player of a match and the language it speaks.
 *
 * @param player   sends and is sent lines
 * @param protocol what is in the lines
 */
public record Seat(Player player, Protocol protocol) {
}

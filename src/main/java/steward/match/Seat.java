package steward.match;

import steward.bot.Player;

/**
 * A player of a match and the language it speaks.
 *
 * @param player   sends and is sent lines, or is a {@link #direct} one
 * @param protocol what is in the lines
 */
public record Seat(Player player, Protocol protocol) {

    /** A bot that needs no lines; where a protocol must be named, it is {@link Protocol#JSON}. */
    public static Seat direct(String name, DirectBot bot) {
        return new Seat(new DirectPlayer(name, bot), Protocol.JSON);
    }
}

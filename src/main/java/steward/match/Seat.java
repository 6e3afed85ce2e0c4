package steward.match;

import steward.bot.Player;

/**
 * A player of a match and the protocol it uses.
 *
 * @param player exchanges lines, or is a {@link #direct} one
 */
public record Seat(Player player, Protocol protocol) {

    /** A bot that needs no lines; where a protocol must be named, it is {@link Protocol#JSON}. */
    public static Seat direct(String name, DirectBot bot) {
        return new Seat(new DirectPlayer(name, bot), Protocol.JSON);
    }
}

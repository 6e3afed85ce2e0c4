package steward.match;

import java.util.function.Function;
import steward.bot.Player;
import steward.game.Game;
import steward.scene.Time;

/**
 * Player of a match with the protocol it uses.
 *
 * @param player exchanges lines, or is a {@link #direct} one
 * @param limits of its own, or {@code null} for those of the scene
 */
public record Seat(Player player, Protocol protocol, Time limits) {

    /** A player with the limits of the scene. */
    public Seat(Player player, Protocol protocol) {
        this(player, protocol, null);
    }

    /** A bot that needs no lines; where a protocol must be named, it is {@link Protocol#JSON}. */
    public static Seat direct(String name, DirectBot bot) {
        return new Seat(new DirectPlayer(name, bot), Protocol.JSON);
    }

    /** Returns the dialogue with the player: its own, or that of its protocol. */
    Dialogue dialogue(Game game, Function<Protocol, Dialogue> ofProtocol) {
        return player instanceof DialoguePlayer own ? own.in(game) : ofProtocol.apply(protocol);
    }
}

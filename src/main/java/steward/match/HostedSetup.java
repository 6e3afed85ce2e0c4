package steward.match;

import java.util.function.Supplier;
import steward.bot.isolation.Isolation;
import steward.game.GameSetup;

/** Setup of a game whose referee is a program of its own. */
public interface HostedSetup extends GameSetup {

    /** Returns this setup with a referee that is kept apart as bots are. */
    GameSetup isolatedBy(Supplier<Isolation> isolation);

    @Override
    default boolean isHosted() {
        return true;
    }
}

package steward.match;

import java.util.List;
import java.util.function.Supplier;
import steward.bot.isolation.Isolation;
import steward.game.Game;
import steward.game.GameSetup;

/** Setup of a game whose referee is an external program. */
public interface GuestSetup extends GameSetup {

    /** Returns this setup with a referee that is kept apart as bots are. */
    GameSetup isolatedBy(Supplier<Isolation> isolation);

    /** Creates a game whose referee says what is recorded. @param outcome of the turn played, or the start, as JSON */
    Game recorded(long seed, Supplier<byte[]> outcome);

    /** Returns the class path of the referee, or the words of its command. */
    List<String> words();

    boolean isOnClassPath();

    /** Number of tests of a game for one: seed 1 plays the first, and after the last comes the first; 0 for none. */
    int tests();

    /** Returns the scene as JSON with other words of its referee. */
    String sceneWith(List<String> words);

    @Override
    default boolean isGuest() {
        return true;
    }
}

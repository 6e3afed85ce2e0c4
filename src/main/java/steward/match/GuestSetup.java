package steward.match;

import java.util.List;
import java.util.function.Supplier;
import steward.bot.isolation.Isolation;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.ServerView;

/** Setup of a game whose referee is an external program. */
public interface GuestSetup extends GameSetup {

    /** Returns this setup with a referee that is kept apart as bots are. */
    GameSetup isolatedBy(Supplier<Isolation> isolation);

    /** Creates a game whose referee says what is recorded. @param outcome of the turn played, or the start, as JSON */
    Game recorded(long seed, Supplier<byte[]> outcome);

    /** Returns the class path of the referee, or the words of its command. */
    List<String> words();

    boolean isOnClassPath();

    /** League level that its scene names; 0 if it names none. */
    int level();

    /** Number of league levels that its scene says there are, at least 1. */
    int levels();

    /**
     * Scene and seed of a game whose referee was given these lines, whatever the scene itself gives it.
     *
     * @throws IllegalArgumentException if a game cannot begin so: says what was found and expected
     */
    ServerView.Start begin(List<String> input);

    /** Number of tests of a game for one: seed 1 plays the first, and after the last comes the first; 0 for none. */
    int tests();

    /** Returns the scene as JSON with other words of its referee. */
    String sceneWith(List<String> words);

    @Override
    default boolean isGuest() {
        return true;
    }
}

package steward.game;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.scene.Plan;
import steward.scene.Scene;

/** A game with the settings of one scene, from which any number of games can be created. Immutable. */
public interface GameSetup {

    /** The scene it was made from. */
    Scene scene();

    /** The parts that the scene requires, and those left out. */
    Plan plan();

    /**
     * Looks at the places of the scene against each other, over every start that can be drawn. Not part of reading a
     * scene, so that a replay of any game that was played can be verified; done where a person names a scene.
     *
     * @return warnings, each located as an error would be: what can be played, but hardly as it was meant
     * @throws steward.scene.json.SceneException if a game that can be drawn cannot begin
     */
    default List<String> check() {
        return List.of();
    }

    /**
     * True if the referee is a program of its own: it says who is asked and how many lines, bots speak its lines only,
     * and nothing of the game is known but what it says.
     */
    default boolean isGuest() {
        return false;
    }

    /** A game before its first turn. All random draws follow from the seed. */
    Game create(long seed);

    /**
     * The physics of a turn, for measurements of it on bodies alone. A game with contacts that ask overrides this with
     * a reaction that needs no game.
     */
    default PhysicsParts physics() {
        return plan().physics(null);
    }

    /** The turns after which a game ends at the latest; 0 if that is not known. */
    default int mostTurns() {
        return 0;
    }

    /** Returns the rules for speeds and positions at the end of a turn; a game may have rules of its own. */
    default Motion motion() {
        return plan().motion();
    }

    /** Edition of the rules where the game has several and this is not the oldest; otherwise empty. */
    default String edition() {
        return "";
    }

    /** Seeded commands for measuring. Games without different aims treat every aim as WIN. */
    Pilot pilot(Pilot.Aim aim);

    /**
     * Answers tests of simulators, states and commands by the states one turn later, in the lines of this game, until
     * the end of the input or until the output is closed.
     *
     * @return whether this game has such lines
     * @throws IllegalArgumentException if a line is missing or wrong; the message names it, what was found and what was
     *                                  expected
     */
    default boolean simulate(BufferedReader in, PrintStream out) throws IOException {
        return false;
    }

    /** Reads and writes a game's frames; made by {@link #create} of the same setup. */
    GameJson codec(Game game);

    /** The line protocol of a game of the same setup, if this scene has one. */
    default Optional<TextCodec> textCodec(Game game) {
        return Optional.empty();
    }
}

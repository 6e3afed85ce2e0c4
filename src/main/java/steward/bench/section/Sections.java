package steward.bench.section;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.bench.Section;
import steward.game.Game;
import steward.game.GameSetup;

/** The parts of the table that every game has. */
public final class Sections {

    private Sections() {
    }

    /** Whole matches, and how they grow with threads. */
    public static Section matches(MatchFixture kit, int threads, int games) {
        return new MatchSection(kit, threads, games);
    }

    /**
     * Lines of one turn.
     *
     * @param next   puts a game into another state, at next to no cost
     * @param answer a good one
     */
    public static Section frames(MatchFixture kit, Consumer<Game> next, String answer) {
        return new FrameSection(kit, next, answer);
    }

    /** Replays. */
    public static Section verify(MatchFixture kit) {
        return new VerifySection(kit);
    }

    /**
     * Bot processes.
     *
     * @param longGame  a scene in which bots that never arrive play many turns
     * @param longTurns how many
     * @param oneTurn   a scene that is over after one turn
     * @param shell     a program that starts at once and answers every line with a good one
     */
    public static Section processes(MatchFixture kit, GameSetup longGame, int longTurns, GameSetup oneTurn,
                                    List<String> shell) {
        return new ProcessSection(kit, longGame, longTurns, oneTurn, shell);
    }

    /**
     * Many bodies.
     *
     * @param bodies how many, a gas of each
     * @throws IllegalArgumentException if there cannot be so many, in words for people
     */
    public static Section crowds(List<Integer> bodies) {
        return new CrowdSection(bodies);
    }

    /** Other numbers of players and turns. */
    public static Section growth(MatchFixture kit, Map<String, GameSetup> scenes) {
        return new GrowthSection(kit, scenes);
    }

    /** The start of the program. */
    public static Section start(MatchFixture kit) {
        return new StartupSection(kit);
    }
}

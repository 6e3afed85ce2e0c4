package steward.lab.bench.section;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.game.Game;
import steward.game.GameSetup;
import steward.lab.bench.Section;

/** The sections of the table that every game has. */
public final class Sections {

    private Sections() { }

    /** Whole matches, and how they scale with threads. */
    public static Section matches(MatchFixture fixture, int threads, int games) {
        return new MatchSection(fixture, threads, games);
    }

    /**
     * Lines of one turn.
     *
     * @param next   changes the game's state, at next to no cost
     * @param answer a valid one
     */
    public static Section frames(MatchFixture fixture, Consumer<Game> next, String answer) {
        return new FrameSection(fixture, next, answer);
    }

    public static Section verify(MatchFixture fixture) {
        return new VerifySection(fixture);
    }

    /**
     * Bot processes.
     *
     * @param longGame  a scene in which bots that never reach a checkpoint play many turns
     * @param longTurns how many turns
     * @param oneTurn   a scene that is over after one turn
     * @param shell     a program that starts at once and answers every line with a valid one
     */
    public static Section processes(MatchFixture fixture, GameSetup longGame, int longTurns, GameSetup oneTurn,
                                    List<String> shell) {
        return new ProcessSection(fixture, longGame, longTurns, oneTurn, shell);
    }

    /**
     * Many bodies.
     *
     * @param bodies the numbers of bodies, a gas for each
     * @throws IllegalArgumentException if so many are not possible, with a readable message
     */
    public static Section crowds(List<Integer> bodies) {
        return new CrowdSection(bodies);
    }

    /** Other numbers of players and turns. */
    public static Section growth(MatchFixture fixture, Map<String, GameSetup> scenes) {
        return new GrowthSection(fixture, scenes);
    }

    public static Section leagues(MatchFixture fixture, int threads) {
        return new LeagueSection(fixture, threads);
    }

    public static Section start(MatchFixture fixture) {
        return new StartupSection(fixture);
    }

    /** @param tools the folder of the tools of others */
    public static Section tools(MatchFixture fixture, Path tools) {
        return new ToolSection(fixture, tools);
    }

    /** @param sdk the folder with the jars of CodinGame's SDK */
    public static Section referees(MatchFixture fixture, Path sdk, int threads) {
        return new RefereeSection(fixture, sdk, threads);
    }
}

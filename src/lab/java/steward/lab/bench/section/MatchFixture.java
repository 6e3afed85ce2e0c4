package steward.lab.bench.section;

import java.util.List;
import java.util.function.Supplier;
import steward.bot.Bot;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.match.DirectBot;

/**
 * Fixture to measure whole matches, supplied by the command line, which alone knows the games.
 *
 * @param direct    makes a bot that reads the game itself
 * @param lines     makes a bot with the same commands that reads and writes lines
 * @param responder a program that answers everything with the same valid line, see {@link FixedAnswerBot}
 * @param launcher  the command that starts this program through its launcher, or {@code null}
 * @param plain     the command that starts it without the launcher's preparation
 */
public record MatchFixture(GameTypes types, GameSetup setup, Supplier<DirectBot> direct, Supplier<Bot> lines,
                           List<String> responder, List<String> launcher, List<String> plain) { }

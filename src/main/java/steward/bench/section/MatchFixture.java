package steward.bench.section;

import java.util.List;
import java.util.function.Supplier;
import steward.bot.Bot;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.match.DirectBot;

/**
 * What whole matches are measured with: the games are known to the command line alone.
 *
 * @param types     the games
 * @param setup     the scene
 * @param direct    makes a bot that looks at the game itself
 * @param lines     makes a bot of the same commands that reads and writes lines
 * @param responder a program that answers everything with the same good line, see {@link FixedAnswerBot}
 * @param launcher  the command that starts this program as a person does, or {@code null}
 * @param plain     the command that starts it without any preparation
 */
public record MatchFixture(GameTypes types, GameSetup setup, Supplier<DirectBot> direct, Supplier<Bot> lines,
                       List<String> responder, List<String> launcher, List<String> plain) {
}

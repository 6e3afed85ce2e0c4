package steward.lab.capacity;

import java.util.function.IntFunction;
import steward.bot.isolation.Isolation;
import steward.contest.BotStarter;
import steward.contest.Contest;
import steward.game.GameSetup;
import steward.game.GameTypes;

/**
 * Bots inside this JVM that play to measure.
 *
 * @param playing  starts a bot that plays; it may look at the game itself
 * @param asked    starts one with the same commands that is asked by lines
 * @param commands how the k-th bot is called in league.json, counted from 1: bundled bots, which have no files
 */
public record MeasuredBots(GameTypes types, GameSetup setup, BotStarter playing, BotStarter asked,
                           IntFunction<String> commands) {

    String command(int number) {
        return commands.apply(number);
    }

    /** The scene without deadlines, which say nothing here. */
    Contest contest() {
        return Contest.withoutBots(setup, Double.POSITIVE_INFINITY).isolatedBy(() -> Isolation.OFF);
    }
}

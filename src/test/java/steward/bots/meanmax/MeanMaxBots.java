package steward.bots.meanmax;

import java.util.function.Consumer;
import steward.bot.Bot;

/** The bundled bots of Mean Max inside this JVM. */
public final class MeanMaxBots {

    private MeanMaxBots() {
    }

    /** The plain one. */
    public static Bot gatherer() {
        return asBot(new Gatherer(), line -> { });
    }

    /** The better one. */
    public static Bot marauder() {
        return asBot(new Marauder(), line -> { });
    }

    /** The better one, which a consumer sees all lines of, sent and answered. */
    public static Bot marauder(Consumer<String> lines) {
        return asBot(new Marauder(), lines);
    }

    private static Bot asBot(MeanMaxBot bot, Consumer<String> lines) {
        return new Bot() {
            @Override
            public void setup(String line) {
                lines.accept(line);
                bot.answer(line);
            }

            @Override
            public String turn(String line) {
                lines.accept(line);
                String answer = bot.answer(line);
                lines.accept(answer);
                return answer;
            }

            @Override
            public void end(String line) {
                lines.accept(line);
                bot.answer(line);
            }
        };
    }
}

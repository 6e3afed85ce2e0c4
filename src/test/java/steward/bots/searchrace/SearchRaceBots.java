package steward.bots.searchrace;

import java.util.function.Consumer;
import steward.bot.Bot;

/** The bundled bots of the search race inside this JVM. */
public final class SearchRaceBots {

    private SearchRaceBots() {
    }

    /** The plain one. */
    public static Bot driver() {
        return asBot(new Driver(), line -> { });
    }

    /** The better one. */
    public static Bot planner() {
        return asBot(new Planner(), line -> { });
    }

    /** The plain one, which a consumer sees all lines of, sent and answered. */
    public static Bot driver(Consumer<String> lines) {
        return asBot(new Driver(), lines);
    }

    private static Bot asBot(SearchRaceBot bot, Consumer<String> lines) {
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

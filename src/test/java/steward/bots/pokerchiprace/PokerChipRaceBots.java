package steward.bots.pokerchiprace;

import java.util.function.Consumer;
import steward.bot.Bot;

/** The bundled bots of the Poker Chip Race inside this JVM. */
public final class PokerChipRaceBots {

    private PokerChipRaceBots() {
    }

    /** The plain one. */
    public static Bot nibbler() {
        return asBot(new Nibbler(), line -> { });
    }

    /** The better one. */
    public static Bot glutton() {
        return asBot(new Glutton(), line -> { });
    }

    /** The better one, which a consumer sees all lines of, sent and answered. */
    public static Bot glutton(Consumer<String> lines) {
        return asBot(new Glutton(), lines);
    }

    private static Bot asBot(ChipBot bot, Consumer<String> lines) {
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

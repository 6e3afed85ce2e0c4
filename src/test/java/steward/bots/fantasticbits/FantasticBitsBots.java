package steward.bots.fantasticbits;

import java.util.function.Consumer;
import steward.bot.Bot;

/** The bundled bots of Fantastic Bits inside this JVM. */
public final class FantasticBitsBots {

    private FantasticBitsBots() {
    }

    /** The plain one. */
    public static Bot chaser() {
        return asBot(new Chaser(), line -> { });
    }

    /** The better one. */
    public static Bot captain() {
        return asBot(new Captain(), line -> { });
    }

    /** The better one, which a consumer sees all lines of, sent and answered. */
    public static Bot captain(Consumer<String> lines) {
        return asBot(new Captain(), lines);
    }

    private static Bot asBot(FantasticBitsBot bot, Consumer<String> lines) {
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

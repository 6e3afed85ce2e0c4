package steward.bots;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import steward.bot.Bot;
import steward.bots.fantasticbits.Captain;
import steward.bots.fantasticbits.Chaser;
import steward.bots.fantasticbits.Striker;
import steward.bots.meanmax.Gatherer;
import steward.bots.meanmax.Harvester;
import steward.bots.meanmax.Marauder;
import steward.bots.pokerchiprace.Glutton;
import steward.bots.pokerchiprace.Grazer;
import steward.bots.pokerchiprace.Nibbler;
import steward.bots.searchrace.Coaster;
import steward.bots.searchrace.Driver;
import steward.bots.searchrace.Planner;

/** The bundled bots inside this JVM. */
public final class BundledBots {

    /** By scene, from the weakest to the strongest. */
    static final Map<String, List<Supplier<LineBot>>> LADDERS = Map.of(
        "search-race", List.of(Driver::new, Coaster::new, Planner::new),
        "mean-max", List.of(Gatherer::new, Harvester::new, Marauder::new),
        "fantastic-bits", List.of(Chaser::new, Striker::new, Captain::new),
        "poker-chip-race", List.of(Nibbler::new, Grazer::new, Glutton::new));

    private BundledBots() {
    }

    /** The bot as the referee knows it. */
    public static Bot of(LineBot bot) {
        return of(bot, line -> { });
    }

    /** The bot as the referee knows it; a consumer sees all lines, sent and answered. */
    public static Bot of(LineBot bot, Consumer<String> lines) {
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

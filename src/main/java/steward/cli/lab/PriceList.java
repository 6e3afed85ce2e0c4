package steward.cli.lab;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.LongSupplier;
import steward.cli.shared.Games;
import steward.cli.shared.Streams;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.calibration.PartByPartPhysics;
import steward.lab.calibration.PartPrices;
import steward.lab.calibration.PartPrices.Price;
import steward.lab.calibration.SeededPlay;
import steward.scene.Part;

/** What each part of a scene adds to a turn, measured on this machine. */
final class PriceList {

    /** Long enough for stable medians, short enough to wait for. */
    private static final long BUDGET_NANOS = 1_800_000_000;
    private static final long SEED = 1;
    private static final String CLEAR = "\r" + " ".repeat(40) + "\r";

    private final GameSetup setup;
    private final PartPrices.Prices prices;
    private final Map<String, Price> byPart = new HashMap<>();

    private PriceList(GameSetup setup, PartPrices.Prices prices) {
        this.setup = setup;
        this.prices = prices;
        prices.prices().forEach(price -> byPart.put(price.part(), price));
    }

    /** Measures for about two seconds; progress is shown on a terminal. */
    static PriceList measure(Streams streams, GameSetup setup) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return measure(streams, setup, threads.isCurrentThreadCpuTimeSupported()
            ? threads::getCurrentThreadCpuTime : System::nanoTime, System::nanoTime);
    }

    /** With two clocks in nanoseconds: one for the prices, and the wall clock. */
    static PriceList measure(Streams streams, GameSetup setup, LongSupplier work, LongSupplier wall) {
        int[] told = {-1};
        Pilot pilot = setup.pilot(Pilot.Aim.WIN);
        PartPrices.Prices prices = PartPrices.measure(setup.scene(), Games.types(),
            new SeededPlay(setup, pilot, SEED), pilot, work, wall, BUDGET_NANOS, share -> {
                int percent = (int) (100 * share);
                if (streams.errTerminal() && percent > told[0]) {
                    streams.err().print("\rmeasuring prices: " + percent + "%");
                    streams.err().flush();
                    told[0] = percent;
                }
            });
        if (streams.errTerminal()) {
            streams.err().print(CLEAR);
            streams.err().flush();
        }
        return new PriceList(setup, prices);
    }

    /** The price of a part in nanoseconds a turn, in brackets for a part that is left out; empty without a price. */
    String of(Part part) {
        Price price = byPart.get(part.name());
        return price == null ? "" : part.in() ? text(price) + " ns" : "(" + text(price) + " ns)";
    }

    /** The price of a part in nanoseconds a turn, {@code NaN} if it has none. */
    double nanos(Part part) {
        Price price = byPart.get(part.name());
        return price == null ? Double.NaN : price.nanos();
    }

    /** A number, or a text that it is below the measurable difference. */
    private static String text(Price price) {
        double least = Math.max(1, price.error());
        boolean saves = price.part().equals(Part.BROAD_PHASE) && -price.nanos() >= least;
        return saves || price.nanos() >= least ? String.format(Locale.ROOT, "%.0f", price.nanos())
            : "<" + (long) Math.ceil(least);
    }

    /** The meaning of the numbers. */
    String legend() {
        return "A turn takes " + text(prices.turn()) + " ns here, " + text(byPart.get(PartByPartPhysics.EMPTY))
            + " ns of them to fly straight; the parts add their prices (a broad phase saves), those left out would add "
            + "what is in brackets. "
            + "Measured now on " + setup.scene().accuracy() + ", medians of " + prices.rounds()
            + " rounds; < is less than can be told apart.";
    }
}

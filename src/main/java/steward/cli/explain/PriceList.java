package steward.cli.explain;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.game.GameSetup;
import steward.scene.Part;
import steward.scene.price.MeasuredPrices;
import steward.scene.price.PartPrice;
import steward.scene.price.StoredPartPrices;

/** Prices of a scene's parts in a turn: as stored with the program, or measured on this machine. */
final class PriceList {

    private static final double PERCENT = 100;

    private final Map<String, PartPrice> byPart = new HashMap<>();
    private final String legend;
    private final boolean measured;

    private PriceList(boolean measured, String legend) {
        this.measured = measured;
        this.legend = legend;
    }

    /** Shares of a turn, from the measurements that come with the program. */
    static PriceList stored(GameSetup setup) {
        StoredPartPrices stored = StoredPartPrices.of(setup.scene());
        StoredPartPrices.Row row = stored.rows().get(0);
        List<String> rungs = stored.rows().stream().map(StoredPartPrices.Row::rung).distinct().toList();
        PriceList list = new PriceList(false, "What a part adds, as a share of a turn (below 0: it saves); parts left "
            + "out would add what is in brackets; < is less than could be told apart. "
            + (stored.exact() ? "Stored for " + row.scene()
                : "Stored, the medians of " + String.join(", ", stored.scenes()))
            + " on " + String.join(", ", rungs) + ", measured " + row.date() + ": " + row.machine()
            + ". --measure measures this scene here.");
        for (Part part : setup.plan().parts()) {
            PartPrice price = stored.price(part);
            if (price != null) {
                list.byPart.put(part.name(), new PartPrice(part.name(), part.in(), PERCENT * price.nanos(),
                    PERCENT * price.error()));
            }
        }
        return list;
    }

    /** Prices measured on this machine. */
    static PriceList measured(GameSetup setup, MeasuredPrices prices) {
        Map<String, PartPrice> byPart = new HashMap<>();
        prices.prices().forEach(price -> byPart.put(price.part(), price));
        PriceList list = new PriceList(true, "");
        PriceList told = new PriceList(true, "A turn takes " + list.text(prices.turn()) + " here, "
            + list.text(byPart.get(PartPrice.EMPTY)) + " of them to fly straight; a part adds its price (below "
            + "0: it saves), parts left out would add what is in brackets. Measured now on "
            + setup.scene().accuracy() + ", each part in JVMs of its own, medians of " + prices.rounds()
            + " rounds; < is less than can be told apart.");
        told.byPart.putAll(byPart);
        return told;
    }

    /** The price of a part, in brackets for a part that is left out; empty without a price. */
    String of(Part part) {
        PartPrice price = byPart.get(part.name());
        return price == null ? "" : part.in() ? text(price) : "(" + text(price) + ")";
    }

    /** The price of a part in nanoseconds a turn, or as a share of a turn; {@code NaN} if it has none. */
    double number(Part part) {
        PartPrice price = byPart.get(part.name());
        return price == null ? Double.NaN : measured ? price.nanos() : price.nanos() / PERCENT;
    }

    /** True if the prices are in nanoseconds and of this machine. */
    boolean isMeasured() {
        return measured;
    }

    /** A number, or a text that it is below the measurable difference. */
    private String text(PartPrice price) {
        double least = Math.max(1, price.error());
        return Math.abs(price.nanos()) >= least ? unit(price.nanos()) : "<" + unit(Math.ceil(least));
    }

    private String unit(double value) {
        return String.format(Locale.ROOT, measured ? "%.0f ns" : "%.0f%%", value);
    }

    /** The meaning of the numbers. */
    String legend() {
        return legend;
    }
}

package steward.lab.capacity;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.lab.capacity.LeagueCosts.Part;
import steward.lab.capacity.SaturationTable.Row;

/** Text about measurements and simulations, for people: lines of Markdown, as they stand in the documentation. */
public final class CapacityText {

    private static final double PERCENT = 100;
    /** A share of a machine that nobody misses. */
    private static final double LITTLE = 0.05;
    /** How the rows of the prices begin; their figures are read again from the documentation by a test. */
    static final List<String> PRICES = List.of("the broker and TLS: jobs out, leases, results in",
        "reading what workers say", "playing the game again", "asking its bots again", "schedule, pairing",
        "storing");

    private CapacityText() { }

    /** All of it. @param machine where and when it was measured, in words */
    public static List<String> of(Capacity capacity, String machine) {
        List<String> lines = new ArrayList<>();
        lines.add("Measured by `steward league capacity`: " + machine + ".");
        lines.add("");
        lines.addAll(prices(capacity));
        lines.add("");
        lines.addAll(overhead(capacity));
        lines.add("");
        lines.addAll(simulation(capacity.table()));
        return lines;
    }

    private static List<String> prices(Capacity capacity) {
        LeagueCosts costs = capacity.table().costs();
        List<String> lines = new ArrayList<>(List.of(
            "What a game of a worker costs the league's process, in CPU time. A game has "
                + number(capacity.prices().turns()) + " turns and",
            number(capacity.prices().bytes()) + " bytes on its way, and " + number(capacity.served().perJob())
                + " go together; its bots are inside the process and take next to no", "time.", "",
            "| part | µs a game |", "|---|---:|"));
        double[] micros = {costs.broker(), costs.messages(), costs.check(), costs.again(), costs.schedule(),
            costs.store()};
        for (int k = 0; k < micros.length; k++) {
            lines.add("| " + PRICES.get(k) + (k == 3 ? ", in " + percent(costs.share()) + " of the games" : "") + " | "
                + number(micros[k]) + " |");
        }
        lines.add("| together, for a game on average | " + number(costs.total()) + " |");
        return lines;
    }

    private static List<String> overhead(Capacity capacity) {
        double alone = capacity.alone().threads();
        List<String> lines = new ArrayList<>(List.of("At " + number(capacity.rate()) + " games/s ("
            + number(capacity.alone().perSecond()) + " and " + number(capacity.served().perSecond())
            + " were reached" + (capacity.rounds() > 1 ? "; medians of " + capacity.rounds() + " runs in turn" : "")
            + "):", "", "| | µs a game | of one processor | of all "
            + capacity.table().processors() + " | of a game by itself |", "|---|---:|---:|---:|---:|"));
        lines.add(share(capacity, "games of a league by itself, recorded and stored", alone));
        lines.add(share(capacity, "with a worker in the same process", capacity.served().threads()));
        lines.add(share(capacity, "more with a worker, on both sides together", capacity.overhead()));
        lines.add(share(capacity, "broker, TLS and checks in the league's process", capacity.leagueOverhead()));
        lines.add("");
        double league = capacity.ofOneProcessor(capacity.leagueOverhead());
        String machine = percent(LITTLE) + " of a machine of " + number(Math.floor(league / LITTLE) + 1)
            + " processors.";
        if (capacity.overhead() < capacity.leagueOverhead()) {
            lines.add("A worker adds less overhead than the broker, TLS and the checks take together, as a league by "
                + "itself");
            lines.add("writes a replay of each game, in case it fails, and a worker sends the commands alone. Broker, "
                + "TLS and");
            lines.add("checks are under " + machine);
        } else {
            lines.add("Broker, TLS and checks are under " + machine);
        }
        lines.add("What compiles and collects took " + number(capacity.alone().process() - alone) + " and "
            + number(capacity.served().process() - capacity.served().threads()) + " µs a game besides.");
        return lines;
    }

    private static String share(Capacity capacity, String what, double micros) {
        double one = capacity.ofOneProcessor(micros);
        return "| " + what + " | " + number(micros) + " | " + percent(one) + " | "
            + percent(one / capacity.table().processors()) + " | " + percent(micros / capacity.alone().threads())
            + " |";
    }

    /** Describes the simulation from the prices, and the conclusions from it. */
    static List<String> simulation(SaturationTable table) {
        List<String> lines = new ArrayList<>(List.of(
            "Simulated from these prices, in virtual time: a machine with " + table.processors()
                + " processors for the league's process; workers with one game", "at a time each.", "",
            "| workers | could play, games/s | play | processors | messages | schedule | storing | workers busy | "
                + "a result waits |", "|---:|---:|---:|---:|---:|---:|---:|---:|---:|"));
        table.rows().forEach(row -> lines.add(row(row)));
        lines.add(row(table.last()));
        lines.add("");
        Row last = table.rows().get(table.rows().size() - 1);
        double each = last.offered() / last.workers();
        Part first = table.costs().first(table.processors());
        double most = table.costs().most(first, table.processors());
        lines.add("First to have no time left: " + first.words() + ", at " + number(most) + " games/s, which are "
            + number(Math.ceil(most / each)) + " workers that play " + number(each) + " games/s each.");
        lines.add(number(table.last().workers()) + " workers that play " + number(table.last().offered())
            + " games/s together need " + percent(table.last().load().processors()) + " of the processors.");
        lines.add("With more processors for the league's process, and " + number(last.workers()) + " workers of "
            + number(each) + " games/s:");
        lines.add("");
        lines.add("| processors | games/s | no time left |");
        lines.add("|---:|---:|---|");
        table.larger().forEach(row -> lines.add("| " + row.processors() + " | " + number(row.load().perSecond())
            + " | " + row.first().words() + " |"));
        return lines;
    }

    static String row(Row row) {
        return "| " + number(row.workers()) + " | " + number(row.offered()) + " | " + number(row.load().perSecond())
            + " | " + percent(row.load().processors()) + " | " + percent(row.load().messages()) + " | "
            + percent(row.load().schedule()) + " | " + percent(row.load().store()) + " | "
            + percent(row.load().workers()) + " | " + time(row.load().delayMs()) + " |";
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%,.0f", value);
    }

    private static String percent(double share) {
        boolean whole = share >= 0.1 || Math.rint(PERCENT * share) == PERCENT * share;
        return String.format(Locale.ROOT, whole ? "%.0f%%" : "%.1f%%", PERCENT * share);
    }

    private static String time(double ms) {
        return String.format(Locale.ROOT, ms < 10 ? "%.2f ms" : "%,.0f ms", ms);
    }
}

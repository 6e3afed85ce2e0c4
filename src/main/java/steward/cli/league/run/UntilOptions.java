package steward.cli.league.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.league.pairing.LeagueEnd;
import steward.league.pairing.StopRule;
import steward.league.play.Roster;
import steward.league.rating.Difference;
import steward.league.rating.Ratings;
import steward.text.TextFormat;

/** Options for when a league knows enough to end. */
@OptionSection("The end")
final class UntilOptions {

    private static final double MOST_ELO = 1000;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--until-bars", paramLabel = "ELO", description = "Ends when the anytime bar of every bot is at "
        + "most so wide to each side.")
    private Double bars;

    @Option(names = "--until-ranked", description = "Ends when the order of all bots is sure: "
        + "wrong in one of twenty leagues at most; see --equal.")
    private boolean ranked;

    @Option(names = "--equal", paramLabel = "ELO", description = "With --until-ranked: bots that surely differ by less "
        + "than so much count as equal (default: 5).")
    private Double equal;

    /** Refuses what cannot be. */
    StopRule rule() {
        check.that(bars == null || bars >= 1 && bars <= MOST_ELO, "--until-bars: found " + bars
            + ", expected 1 to 1000");
        check.that(equal == null || ranked, "--equal: expected --until-ranked with it");
        check.that(equal == null || equal >= 0 && equal <= MOST_ELO, "--equal: found " + equal
            + ", expected 0 to 1000");
        return new StopRule(bars == null ? Double.NaN : bars, ranked, equal == null ? StopRule.USUAL_EQUAL : equal);
    }

    /** Describes at the end how the rule was met. */
    static List<String> tell(LeagueEnd end, Roster roster) {
        List<String> lines = new ArrayList<>();
        Ratings met = end.met();
        if (end.rule().ranked()) {
            Map<Integer, String> names = new HashMap<>();
            roster.members().forEach(member -> names.put(member.version().id(), member.version().display()));
            List<Integer> order = StopRule.order(met);
            List<StopRule.Order> orders = end.rule().orders(met, order);
            StringBuilder line = new StringBuilder("Ranked: ");
            for (int k = 0; k < order.size(); k++) {
                line.append(k == 0 ? "" : orders.get(k - 1) == StopRule.Order.EQUAL ? " = " : " > ")
                    .append(names.getOrDefault(order.get(k), "?"));
            }
            lines.add(TextFormat.plain(line.toString()));
            if (orders.contains(StopRule.Order.EQUAL)) {
                lines.add("= within " + TextFormat.number(end.rule().equal(), 2) + " Elo.");
            }
        }
        if (!Double.isNaN(end.rule().bars())) {
            lines.add("All anytime bars are at most " + TextFormat.number(end.rule().bars(), 2) + " Elo.");
        }
        return lines;
    }

    /** Lists the open questions where a run ended before enough was known; nothing where little is. */
    static List<String> missing(StopRule rule, Ratings found) {
        List<String> lines = new ArrayList<>();
        if (!Double.isNaN(rule.bars())) {
            double widest = found.versions().stream().mapToDouble(version -> found.rating(version).anytimeBar()).max()
                .orElse(0);
            if (widest > rule.bars()) {
                lines.add("Not yet at --until-bars " + TextFormat.number(rule.bars(), 2)
                    + ": the widest anytime bar is "
                    + (Difference.isKnown(widest) ? Math.round(widest) + " Elo." : "not known."));
            }
        }
        if (rule.ranked()) {
            List<StopRule.Order> orders = rule.orders(found, StopRule.order(found));
            long open = orders.stream().filter(order -> order == StopRule.Order.OPEN).count();
            if (open > 0) {
                lines.add("Not yet ranked: the order of " + open + " of " + TextFormat.count(orders.size(), "pair")
                    + " of neighbours is open.");
            }
        }
        return lines;
    }
}

package steward.cli.league.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.league.pairing.BarNeed;
import steward.league.pairing.LeagueEnd;
import steward.league.pairing.StopRule;
import steward.league.play.Roster;
import steward.league.rating.Ratings;
import steward.text.TextFormat;

/** Options that end a league when its table is known well enough: narrow bars, or an order without doubt. */
@OptionSection("The end")
final class UntilOptions {

    private static final double MOST_ELO = 1000;
    /** Bots that are named in a line. */
    private static final int NAMED = 5;
    private static final Map<StopRule.Order, String> SIGNS = Map.of(StopRule.Order.ORDERED, " > ",
        StopRule.Order.EQUAL, " = ", StopRule.Order.APART, " | ");

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--until-bars", paramLabel = "ELO", description = "Ends when the anytime bar of every bot "
        + "that can have one is at most ELO wide to each side. It is the error bar of a rating against the mean "
        + "that is valid at any moment. Estimates the games that each bot needs.")
    private Double bars;

    @Option(names = "--until-ranked", description = "Ends when the order of all bots is known: it is wrong in at "
        + "most one of twenty leagues. See --equal.")
    private boolean ranked;

    @Option(names = "--equal", paramLabel = "ELO", description = "With --until-ranked: bots that surely differ by "
        + "less than ELO count as equal (default: 5).")
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
    static List<String> tell(LeagueEnd end, Roster roster, int players) {
        List<String> lines = new ArrayList<>();
        Ratings met = end.met();
        if (end.rule().ranked()) {
            Map<Integer, String> names = names(roster);
            List<Integer> order = met.order();
            List<StopRule.Order> orders = end.rule().orders(met, order,
                (one, other) -> roster.isPair(players, one, other));
            StringBuilder line = new StringBuilder("Ranked: ");
            for (int k = 0; k < order.size(); k++) {
                line.append(k == 0 ? "" : SIGNS.get(orders.get(k - 1)))
                    .append(names.getOrDefault(order.get(k), "?"));
            }
            lines.add(TextFormat.plain(line.toString()));
            if (orders.contains(StopRule.Order.EQUAL)) {
                lines.add("= within " + TextFormat.number(end.rule().equal(), 2) + " Elo.");
            }
            apart(orders).ifPresent(lines::add);
        }
        if (!Double.isNaN(end.rule().bars())) {
            List<BarNeed> needs = BarNeed.of(met, end.rule().bars());
            boolean isAll = needs.stream().noneMatch(BarNeed::isBeyondReach);
            if (!needs.stream().allMatch(BarNeed::isBeyondReach)) {
                lines.add("All anytime bars" + (isAll ? "" : " of the others") + " are at most "
                    + TextFormat.number(end.rule().bars(), 2) + " Elo.");
            }
            beyond(needs, names(roster)).ifPresent(lines::add);
        }
        return lines;
    }

    private static Optional<String> apart(List<StopRule.Order> orders) {
        long apart = orders.stream().filter(order -> order == StopRule.Order.APART).count();
        return apart == 0 ? Optional.empty() : Optional.of((apart == 1 ? "One pair" : apart + " pairs")
            + " of neighbours cannot meet, and no game compares them: not waited for.");
    }

    private static Map<Integer, String> names(Roster roster) {
        Map<Integer, String> names = new HashMap<>();
        roster.members().forEach(member -> names.put(member.version().id(), member.version().display()));
        return names;
    }

    private static Optional<String> beyond(List<BarNeed> needs, Map<Integer, String> names) {
        List<BarNeed> beyond = needs.stream().filter(BarNeed::isBeyondReach).toList();
        return beyond.isEmpty() ? Optional.empty() : Optional.of(TextFormat.plain(joined(beyond, names,
            need -> "") + (beyond.size() == 1 ? " has" : " have") + " won or lost nearly everything, and "
            + (beyond.size() == 1 ? "has a bound in place of a bar: not waited for."
            : "have bounds in place of bars: not waited for.")));
    }

    private static String joined(List<BarNeed> needs, Map<Integer, String> names, Function<BarNeed, String> more) {
        return needs.stream().limit(NAMED).map(need -> names.getOrDefault(need.version(), "?") + more.apply(need))
            .collect(Collectors.joining(", ")) + (needs.size() > NAMED ? " and " + (needs.size() - NAMED) + " more"
            : "");
    }

    /** Lists who needs how many games until the bars are narrow enough, and who is not waited for. */
    static List<String> needed(StopRule rule, Ratings found, Roster roster) {
        List<String> lines = new ArrayList<>();
        if (!Double.isNaN(rule.bars()) && found.versions().size() > 1) {
            Map<Integer, String> names = names(roster);
            List<BarNeed> needs = BarNeed.of(found, rule.bars());
            List<BarNeed> open = needs.stream().filter(BarNeed::isWaitedFor)
                .sorted(Comparator.comparingDouble((BarNeed need) -> need.games() - need.needed())).toList();
            String wanted = "--until-bars " + TextFormat.number(rule.bars(), 2);
            if (!open.isEmpty() && open.stream().allMatch(need -> Double.isNaN(need.bar()))) {
                lines.add(wanted + " takes about " + rounded(BarNeed.even(found.versions().size(), rule.bars()))
                    + " games of each bot, if all are even and seldom draw; more of one that is far ahead or behind");
            } else if (!open.isEmpty()) {
                lines.add(TextFormat.plain(wanted + " needs more games of " + joined(open, names, need ->
                    " (" + (Double.isNaN(need.bar()) ? "no bar" : "± " + Math.round(need.bar())) + " after "
                        + Math.round(need.games()) + ": about " + rounded(need.needed() - need.games()) + " more)")));
            }
            beyond(needs, names).ifPresent(lines::add);
        }
        return lines;
    }

    /** Two figures, since no more are known. */
    private static String rounded(double games) {
        double unit = Math.pow(10, Math.floor(Math.log10(Math.max(1, games))) - 1);
        return TextFormat.number(Math.max(1, Math.ceil(games / Math.max(1, unit)) * Math.max(1, unit)), 0);
    }

    /** Lists the open questions where a run ended before enough was known; nothing where little is. */
    static List<String> missing(StopRule rule, Ratings found, Roster roster, int players) {
        List<String> lines = needed(rule, found, roster);
        if (rule.ranked()) {
            List<StopRule.Order> orders = rule.orders(found, found.order(),
                (one, other) -> roster.isPair(players, one, other));
            long open = orders.stream().filter(order -> order == StopRule.Order.OPEN).count();
            if (open > 0) {
                lines.add("Not yet ranked: the order of " + open + " of " + TextFormat.count(orders.size(), "pair")
                    + " of neighbours is open.");
            }
            apart(orders).ifPresent(lines::add);
        }
        return lines;
    }
}

package steward.cli.league.view;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.files.InputException;
import steward.league.rating.LeagueTable;
import steward.league.rating.Results;
import steward.text.NearestName;

/** Options for the bot or zero to which ratings and differences refer. */
@OptionSection("Ratings")
public final class ReferenceOptions {

    private static final Pattern ANCHOR = Pattern.compile("(.+?)(?:=(-?[0-9]{1,5}(?:\\.[0-9]{1,3})?))?");

    @Option(names = "--anchor", paramLabel = "BOT[=ELO]", description = "Gives this bot the rating ELO (default: "
        + "0); error bars are then of the differences to it.")
    private String anchor;

    @Option(names = "--against", paramLabel = "BOT", description = "Prints each bot's difference to this one "
        + "(default: the anchor or, without one, the row above).")
    private String against;

    /** Rates against them. */
    LeagueTable table(Results results, List<LeagueTable.Entry> entries) {
        return LeagueTable.of(results, entries, reference(results, entries));
    }

    /** Refuses bots that would have no row. */
    public LeagueTable.Reference reference(Results results, List<LeagueTable.Entry> all) {
        List<LeagueTable.Entry> entries = LeagueTable.shown(results, all);
        Matcher words = ANCHOR.matcher(anchor == null ? "" : anchor);
        CallCheck.withHelp().that(anchor == null || words.matches() && (words.group(2) != null || entries.stream()
            .noneMatch(entry -> anchor.startsWith(entry.name() + "="))), "--anchor: found '" + anchor
            + "', expected a bot, or a bot and its rating such as mine=1500");
        return new LeagueTable.Reference(anchor == null ? -1 : version("--anchor", words.group(1), entries),
            anchor == null || words.group(2) == null ? 0 : Double.parseDouble(words.group(2)),
            against == null ? -1 : version("--against", against, entries));
    }

    private static int version(String option, String name, List<LeagueTable.Entry> entries) {
        List<String> names = entries.stream().map(LeagueTable.Entry::name).toList();
        return entries.stream().filter(entry -> entry.name().equals(name)).mapToInt(LeagueTable.Entry::version)
            .findFirst().orElseThrow(() -> new InputException(option + ": found no bot '" + name + "' in the table, "
                + "expected one of " + String.join(", ", names) + NearestName.question(name, names, "'")));
    }
}

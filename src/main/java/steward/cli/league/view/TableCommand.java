package steward.cli.league.view;

import java.util.List;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SeedFileOption;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.league.StoredGame;
import steward.league.page.LeagueJson;
import steward.league.rating.LeagueTable;
import steward.league.rating.Results;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward league table}: prints ratings and the crosstable. */
@Command(name = "table", description = "Prints the table of a league: ratings with error bars, and the crosstable.",
    footer = {"", "Examples:", "  steward league table night", "  steward league table night --csv > night.csv",
        "  steward league table night --anchor old=1500 --against veteran"})
public final class TableCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Option(names = "--csv", description = "Prints comma-separated values, a line for each bot.")
    private boolean csv;

    @Mixin
    private final PartOptions part = new PartOptions();

    @Mixin
    private final ReferenceOptions reference = new ReferenceOptions();

    @Option(names = "--values", description = "Also prints each bot's mean values with their spread: score, "
        + "turns, and those of the game, such as laps, water, goals or chips.")
    private boolean values;

    @Override
    public Integer call() {
        check.exclusive("--json", json, "--csv", csv);
        part.check();
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            LeagueTable table = part.isAny() ? reference.table(partial(opened), part.rows(opened.entries()))
                : reference.table(opened.games().results(), opened.entries());
            OwnValues own = new OwnValues();
            if (values) {
                each(opened, own::add);
            }
            if (json) {
                Fields fields = LeagueJson.table(opened.season(), table, opened.workers())
                    .with("choosers", opened.choosers());
                Json.print(streams, values ? fields.with("values", own.fields(table)) : fields);
            } else if (csv) {
                streams.out().print(own.addTo(LeagueJson.bots(table, true), row -> row.entry().version())
                    .csv(table.rows(), number -> TextFormat.number(number, 6), false));
            } else {
                TableText.whole(table, opened.season(), opened.workers(), streams.outColour())
                    .forEach(streams.out()::println);
                if (!part.isAny()) {
                    RoundText.unfinished(table, opened.settings(), opened.season().players())
                        .ifPresent(streams.out()::println);
                }
                flag(opened.choosers(), streams);
                if (values) {
                    streams.out().println();
                    own.lines(table).forEach(streams.out()::println);
                }
            }
        }
        return ExitStatus.DONE;
    }

    /** Flags a table if bots of it have chosen the seeds. */
    public static void flag(List<String> choosers, Streams streams) {
        if (!choosers.isEmpty()) {
            streams.out().println(streams.outColour().warning(SeedFileOption.flag(choosers)));
        }
    }

    private void each(LeagueOpening.Opened opened, Consumer<StoredGame> taker) {
        if (part.isAny()) {
            part.each(opened, taker);
        } else {
            opened.games().games(taker);
        }
    }

    private Results partial(LeagueOpening.Opened opened) {
        Results results = new Results(opened.season());
        part.each(opened, game -> results.add(game, LeagueTable.Entry.random(opened.entries())));
        return results;
    }
}

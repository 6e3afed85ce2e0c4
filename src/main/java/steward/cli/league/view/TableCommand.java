package steward.cli.league.view;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Json;
import steward.cli.shared.Streams;
import steward.files.OutputFiles;
import steward.league.page.LeagueJson;
import steward.league.page.LeaguePlots;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.text.CsvRow;
import steward.text.TextFormat;

/** {@code steward league table}: ratings and who beat whom. */
@Command(name = "table", description = "Prints the table of a league: ratings with their bars, and who beat whom.",
    footer = {"", "Examples:", "  steward league table night", "  steward league table night --csv > night.csv",
        "  steward league table night --plots plots"})
public final class TableCommand implements Callable<Integer> {

    private static final double NANOS_PER_MS = 1e6;

    private final Streams streams;
    private final CallCheck check = CallCheck.withHelp();

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Option(names = "--csv", description = "Prints comma-separated values, a line for each bot.")
    private boolean csv;

    @Option(names = "--html", description = "Prints the page of 'league page'.")
    private boolean html;

    @Option(names = "--plots", paramLabel = "DIR", description = "Writes the ratings with their bars and the ratings "
        + "over games into this folder, as PNG and SVG.")
    private String plots;

    public TableCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        check.that((json ? 1 : 0) + (csv ? 1 : 0) + (html ? 1 : 0) <= 1, "--json, --csv and --html exclude each other");
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            LeagueTable table = opened.table();
            if (json) {
                Json.print(streams, out -> LeagueJson.table(out, opened.season(), table, opened.workers()));
            } else if (csv) {
                printCsv(table);
            } else if (html) {
                ByteArrayOutputStream page = new ByteArrayOutputStream();
                PageCommand.write(opened, table, page);
                streams.out().print(page.toString(StandardCharsets.UTF_8));
            } else {
                TableText.whole(table, opened.season(), opened.workers(), streams.outColour())
                    .forEach(streams.out()::println);
            }
            if (plots != null) {
                writePlots(opened, table);
            }
        }
        return ExitStatus.DONE;
    }

    private void writePlots(LeagueOpening.Opened opened, LeagueTable table) {
        Path folder = OutputFiles.path(plots);
        OutputFiles.prepareFolder(folder);
        try {
            String title = opened.folder().path().getFileName() + ", " + opened.season().sceneName();
            for (Path file : LeaguePlots.write(table, opened.games().path(opened.entries()), title, folder)) {
                streams.err().println("Written: " + file);
            }
        } catch (IOException problem) {
            throw new FailedException(folder + ": cannot be written: " + OutputFiles.reason(folder, problem));
        }
    }

    private void printCsv(LeagueTable table) {
        streams.out().print(new CsvRow().words("rank", "bot", "version", "active", "random", "rating", "bar", "anytime",
            "best", "worst", "games", "points", "wins", "draws", "losses", "faults", "score", "meanMs",
            "worstMs").line());
        for (LeagueTable.Row row : table.rows()) {
            streams.out().print(new CsvRow().words(Integer.toString(row.rank()), row.entry().name(),
                Integer.toString(row.entry().version()), Boolean.toString(row.entry().active()),
                Boolean.toString(row.entry().random()), number(row.rating()), bar(row.bar()), bar(row.anytime()),
                Integer.toString(row.best()), Integer.toString(row.worst()),
                Long.toString(row.sums().games()), number(row.points()), number(row.wins()), number(row.draws()),
                number(row.losses()), Long.toString(row.sums().faults()), number(row.sums().meanScore()),
                number(row.sums().meanNanos() / NANOS_PER_MS), number(row.sums().worstNanos() / NANOS_PER_MS)).line());
        }
    }

    private static String bar(double bar) {
        return Difference.isKnown(bar) ? number(bar) : "";
    }

    private static String number(double value) {
        return Double.isNaN(value) ? "" : TextFormat.number(value, 6);
    }
}

package steward.lab.cli;

import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.ProgramVersion;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.files.OutputFiles;
import steward.lab.chart.MeasuredTable;
import steward.lab.cli.shared.RunProgress;
import steward.lab.cli.shared.TableFolder;
import steward.lab.stability.GoldenHash;
import steward.lab.stability.StabilityCases;
import steward.lab.stability.StabilityFiles;
import steward.lab.stability.StabilityRow;
import steward.lab.stability.StabilityRun;
import steward.lab.timing.Machine;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.StateHash;
import steward.text.TextFormat;

/**
 * {@code steward stability}: tests the physics in numerically extreme cases and compares each result with its
 * requirement.
 */
@Command(name = "stability", description = "Tests the physics in numerically extreme cases on every rung of "
    + "accuracy, and prints each requirement with the result.",
    footer = {"", "Examples:", "  steward stability",
        "  steward stability --quick --case masses --case 'extreme speeds'",
        "  steward stability --long --out results",
        "  steward stability --case 'crowd of 1000, 10%%' --rung double \\",
        "      --impacts 1000000000",
        "", "Exit status: 0 every demand is met; 1 one is not; 2 the call cannot be used;",
        "130 Ctrl-C."})
public final class StabilityCommand extends ProgramCommand {

    private static final long MOST_IMPACTS = 1_000_000_000_000L;
    /** How long the golden hash takes by run length, approximately; measured on a machine with two cores. */
    private static final int[] GOLDEN_SECONDS = {3, 30, 300};

    private final CallCheck brief = CallCheck.brief();

    @Option(names = "--long", description = "Plays the long versions: hours.")
    private boolean full;

    @Option(names = "--quick", description = "Plays the short versions, as in the tests: about a minute.")
    private boolean quick;

    @Option(names = "--case", paramLabel = "NAME", completionCandidates = Cases.class,
        description = "Only this case; can be repeated.")
    private List<String> names = new ArrayList<>();

    @Option(names = "--rung", paramLabel = "RUNG", completionCandidates = Rungs.class,
        description = "Only on this rung of accuracy; can be repeated.")
    private List<String> rungNames = new ArrayList<>();

    @Option(names = "--impacts", paramLabel = "N", description = "Plays each crowd for N impacts, on each event "
        + "rung (default: 1000000; with --quick 20000; with --long 10000000, in double up to 1000000000).")
    private Long impacts;

    @Option(names = "--out", paramLabel = "DIR", description = "Writes the table to " + StabilityFiles.CSV + " and "
        + StabilityFiles.JSON + " in a folder too, row by row.")
    private String out;

    @Mixin
    private final TableFolder tables = new TableFolder();

    @Option(names = "--golden", description = "Prints the hash of all computed results instead; it must be the "
        + "same on every machine.")
    private boolean golden;

    /** The names of the cases. */
    static final class Cases implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return StabilityCases.all(0).stream().map(StabilityCase::name).iterator();
        }
    }

    /** The names of the rungs. */
    static final class Rungs implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Rung.all().stream().map(Rung::name).iterator();
        }
    }

    @Option(names = "--json", description = "Prints one JSON object in place of the table, as --out writes it.")
    private boolean json;

    @Override
    public Integer call() {
        brief.exclusive("--long", full, "--quick", quick);
        tables.check(out);
        brief.range("--impacts", impacts, 1, MOST_IMPACTS);
        RunLength size = full ? RunLength.LONG : quick ? RunLength.SMALL : RunLength.NORMAL;
        if (golden) {
            brief.that(out == null && !json && names.isEmpty() && rungNames.isEmpty() && impacts == null,
                "--golden is about everything, expected no --out, --json, --case, --rung or --impacts with it");
            return golden(size);
        }
        List<StabilityCase> cases = brief.chosen("--case", names, StabilityCases.all(impacts == null ? 0 : impacts),
            StabilityCase::name, "; ");
        List<Rung> rungs = brief.chosen("--rung", rungNames, Rung.all(), Rung::name, "; ");
        RunProgress progress = new RunProgress(streams, cases.size() * rungs.size());
        if (names.isEmpty()) {
            ProgressLine.announce(streams, full ? "hours" : quick ? "about a minute" : "some minutes");
        }
        StabilityTable table = new StabilityTable(json ? streams.withoutOutput() : streams, progress);
        StabilityRun run = new StabilityRun(size, LocalDate.now(ZoneOffset.UTC).toString(), ProgramVersion.text(),
            Machine.line());
        if (out == null) {
            return table(cases, rungs, run, table, null, null);
        }
        Path folder = OutputFiles.path(out);
        try (MeasuredTable<StabilityRow> files = tables.start(folder, StabilityFiles.ALL, List.of(),
            () -> StabilityFiles.start(folder, run))) {
            return table(cases, rungs, run, table, files, folder);
        }
    }

    private int golden(RunLength size) {
        ProgressLine.announce(streams, TextFormat.about(size.pick(GOLDEN_SECONDS[0], GOLDEN_SECONDS[1],
            GOLDEN_SECONDS[2])), "prints nothing");
        Map<String, List<GoldenHash.Part>> others = new LinkedHashMap<>();
        List<GoldenHash.Part> parts;
        try (ProgressLine progress = ProgressLine.watched(streams, "golden", GoldenSuite.count())) {
            Runnable after = progress::step;
            for (String game : Games.ids()) {
                if (!game.equals(Games.FIRST)) {
                    others.put(game, GoldenSuite.parts(game, size, after));
                }
            }
            parts = GoldenSuite.parts(size, after);
        }
        others.forEach((game, itsParts) -> print(itsParts, "all of " + game));
        print(parts, "all");
        return ExitStatus.DONE;
    }

    private void print(List<GoldenHash.Part> parts, String all) {
        for (GoldenHash.Part part : parts) {
            streams.out().println(StateHash.toHex(part.hash()) + "  " + part.name());
        }
        streams.out().println(StateHash.toHex(GoldenHash.total(parts)) + "  " + all);
    }

    private int table(List<StabilityCase> cases, List<Rung> rungs, StabilityRun run, StabilityTable table,
                      MeasuredTable<StabilityRow> files, Path folder) {
        List<StabilityRow> rows = new ArrayList<>();
        try (Interruption interruption = new Interruption(streams,
            () -> "the rows so far are " + (files == null ? "above" : "in " + folder)
                + (table.unfinished().isEmpty() ? "" : "; unfinished: " + table.unfinished()))) {
            StabilityRow.tryAll(cases, rungs, run.length(), (each, rung) -> table.about(each.name(), rung.name()),
                table::reached, row -> {
                    if (files != null) {
                        files.add(List.of(row));
                    }
                    table.add(row);
                    rows.add(row);
                });
            interruption.over();
            boolean passed = table.end();
            if (json) {
                Json.print(streams, StabilityFiles.fields(run, rows));
            }
            return passed ? ExitStatus.DONE : ExitStatus.FAILED;
        }
    }
}

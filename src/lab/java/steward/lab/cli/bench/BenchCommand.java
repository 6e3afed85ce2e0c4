package steward.lab.cli.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.lab.bench.BenchFiles;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.cli.shared.RunProgress;
import steward.lab.cli.shared.TableFolder;
import steward.lab.timing.Machine;
import steward.text.TextFormat;

/** {@code steward bench}: measures the speed of matches, replays, bot processes, starts and crowds. */
@Command(name = "bench", description = "Measures the speed of matches, replays, bot processes, starts and crowds "
    + "of bodies on this machine, and of plain ways to do the same work.",
    footer = {"", "Compare ratios of one run rather than figures of different runs.",
        "", "Examples:", "  steward bench --quick", "  steward bench --only crowds --bodies 100 --bodies 1000",
        "  steward bench --long --out results",
        "", "Exit status: 0 done; 1 something could not be measured; 2 the call cannot be",
        "used; 130 Ctrl-C."})
public final class BenchCommand extends ProgramCommand {

    private static final List<Integer> BODIES = List.of(100, 1000, 10_000, 100_000);
    private static final List<Integer> QUICK_BODIES = List.of(100, 1000);
    private static final int MILLION = 1_000_000;
    private static final int MOST_BODIES = 10 * MILLION;

    /** How long an interrupted run may take to report its results so far, in milliseconds. */
    private static final long PATIENCE_MS = 2000;

    private final CallCheck brief = CallCheck.brief();
    private final Thread measuring = Thread.currentThread();
    private final CountDownLatch told = new CountDownLatch(1);
    private volatile boolean interrupted;
    private volatile boolean any;

    @Option(names = "--only", paramLabel = "NAME", completionCandidates = Parts.class,
        description = "Only this part; can be repeated.")
    private List<String> only = new ArrayList<>();

    @Option(names = "--quick",
        description = "Measures rough figures in about a minute, and says which ratios are not comparable.")
    private boolean quick;

    @Option(names = "--long", description = "Measures long enough for published tables, and a million bodies.")
    private boolean full;

    @Option(names = "--bodies", paramLabel = "N",
        description = "A crowd of N bodies; can be repeated (default: 100, 1000, 10000, 100000).")
    private List<Integer> bodies = new ArrayList<>();

    @Option(names = "--tools", paramLabel = "DIR", description = "Also measures games under cg-brutaltester. DIR "
        + "has cg-brutaltester.jar and csbref, a referee in Go.")
    private String tools;

    @Option(names = "--out", paramLabel = "DIR", description = "Writes " + BenchFiles.CSV + " and " + BenchFiles.JSON
        + " into a folder, row by row, and in the end " + BenchFiles.PAGE + ".")
    private String out;

    @Option(names = "--json", description = "Prints one JSON object in place of the table, as --out writes it.")
    private boolean json;

    @Mixin
    private final TableFolder tables = new TableFolder();

    /** The part that is measured only where its folder is named. */
    private static final String TOOLS = "tools";

    /** The names of the parts. */
    static final class Parts implements Iterable<String> {

        static final List<String> ALL = List.of("matches", "verify", "processes", "start", TOOLS, "crowds", "heaps");

        @Override
        public Iterator<String> iterator() {
            return ALL.iterator();
        }
    }

    @Override
    @SuppressWarnings("try")                           // only closed, never used
    public Integer call() {
        brief.exclusive("--long", full, "--quick", quick);
        tables.check(out);
        List<Section> sections = brief.chosen("--only", only, sections(), Section::name);
        if (tools == null) {
            brief.that(!only.contains(TOOLS), "--only " + TOOLS + ": expected --tools with it");
            sections = sections.stream().filter(section -> !section.name().equals(TOOLS)).toList();
        } else {
            brief.that(Files.isDirectory(OutputFiles.path(tools)), "--tools: found no folder '" + tools + "'");
        }
        Path folder = out == null ? null : OutputFiles.path(out);
        try (BenchFiles files = out == null ? null : tables.start(folder, BenchFiles.ALL,
                    () -> new BenchFiles(folder, Machine.line(), LocalDate.now(ZoneOffset.UTC).toString()));
                Interruption interruption = new Interruption(streams, () -> stopped(out == null
                    ? "what was measured is above" : "the rows so far are in " + folder))) {
            int status = measure(sections, files);
            if (files != null && !interrupted) {
                files.finish(sections);
            }
            return status;
        }
    }

    private List<Section> sections() {
        bodies.forEach(count -> brief.range("--bodies", count, 1, MOST_BODIES));
        List<Integer> crowds = new ArrayList<>(!bodies.isEmpty() ? bodies : quick ? QUICK_BODIES : BODIES);
        if (full && bodies.isEmpty()) {
            crowds.add(MILLION);
        }
        return InputException.of("--bodies: ", () -> BenchSuite.all(crowds, Path.of(tools == null ? "" : tools)));
    }

    /** At Ctrl-C: the measuring thread reports its results so far, unless that takes too long. */
    private String stopped(String kept) {
        interrupted = true;
        measuring.interrupt();
        try {
            told.await(PATIENCE_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException impatient) {
            Thread.currentThread().interrupt();
        }
        return any ? kept : "no row was complete";
    }

    private int measure(List<Section> sections, BenchFiles files) {
        try {
            return measureAll(sections, files);
        } finally {
            told.countDown();
        }
    }

    private int measureAll(List<Section> sections, BenchFiles files) {
        Streams shown = json ? streams.withoutOutput() : streams;
        BenchTable table = new BenchTable(shown);
        List<Row> rows = new ArrayList<>();
        Runtime.getRuntime().addShutdownHook(new Thread(table::release, "bench-interrupted"));
        Effort effort = quick ? Effort.QUICK : full ? Effort.LONG : Effort.NORMAL;
        RunProgress progress = new RunProgress(streams, sections.size());
        if (bodies.isEmpty()) {
            ProgressLine.announce(streams, quick ? "about a minute" : "some minutes");
        }
        shown.out().println(Machine.line());
        int status = ExitStatus.DONE;
        for (Section section : sections) {
            table.begin(section);
            progress.begin(section.name());
            try {
                measureOne(section, effort, progress, row -> {
                    any = true;
                    rows.add(row);
                    if (files != null) {
                        files.add(row);
                    }
                    table.add(row);
                });
            } catch (Exception | OutOfMemoryError problem) {
                if (interrupted) {
                    table.release();
                    return ExitStatus.FAILED;
                }
                streams.err().println("steward: " + section.name() + ": could not be measured: "
                    + TextFormat.plain(String.valueOf(problem.getMessage())));
                status = ExitStatus.FAILED;
            }
            table.release();
        }
        if (json) {
            Json.print(streams, BenchFiles.fields(Machine.line(), LocalDate.now(ZoneOffset.UTC).toString(), rows));
        }
        return status;
    }

    /** The line is erased at the end, so that rows and errors can be printed. */
    private static void measureOne(Section section, Effort effort, RunProgress progress, Consumer<Row> rows)
        throws Exception {
        try {
            section.run(effort, progress.steps(section.steps(effort)), rows);
        } finally {
            progress.end();
        }
    }
}

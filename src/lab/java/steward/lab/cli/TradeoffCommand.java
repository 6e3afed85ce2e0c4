package steward.lab.cli;

import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.lab.cli.shared.RunProgress;
import steward.lab.cli.shared.TableFolder;
import steward.lab.timing.Machine;
import steward.lab.timing.Timing;
import steward.lab.tradeoff.TradeoffEffort;
import steward.lab.tradeoff.TradeoffMeasurement;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;
import steward.lab.tradeoff.TradeoffScene;
import steward.lab.tradeoff.report.TradeoffReport;

/** {@code steward tradeoff}: measures cost and error of each rung of accuracy. */
@Command(name = "tradeoff", description = "Measures cost and error of each rung of accuracy, scene by scene.",
    footer = {"", "Examples:", "  steward tradeoff --out results",
        "  steward tradeoff --quick --scene bullets --scene my-scene.json",
        "  steward tradeoff --calibrate my-scene.json",
        "", "Exit status: 0 done; 2 the call or a scene cannot be used; 130 Ctrl-C: what was",
        "measured is kept."})
public final class TradeoffCommand extends ProgramCommand {

    private static final int MOST_JVMS = 99;

    private final CallCheck brief = CallCheck.brief();

    @Option(names = "--scene", paramLabel = "FILE|NAME", completionCandidates = TradeoffScenes.Names.class,
        description = "Only this scene; can be repeated. A scene file, a "
        + "shipped scene, or one of official-race, brawl, grazing.")
    private List<String> scenes = new ArrayList<>();

    @Option(names = "--quick", description = "Measures few states, with one JVM per rung: quick, rough figures "
        + "that may not be quoted.")
    private boolean quick;

    @Option(names = "--jvms", paramLabel = "N", description = "Times each rung in N JVMs, 1 to 99 (default: "
        + TradeoffEffort.JVMS + "; with --quick 1). The time of a run grows with them.")
    private Long jvms;

    @Option(names = "--out", paramLabel = "DIR", description = "Writes " + TradeoffReport.CSV + " and "
        + TradeoffReport.JSON + " into a folder, scene by scene, and in the end pictures.")
    private String out;

    @Option(names = "--json", description = "Prints one JSON object in place of the table, as --out writes it.")
    private boolean json;

    @Mixin
    private final TableFolder tables = new TableFolder();

    @Mixin
    private final CalibrateOptions calibrate = new CalibrateOptions();

    @Override
    public Integer call() throws InterruptedException {
        if (json && calibrate.isAsked()) {
            throw new InputException("--calibrate: found --json with it, expected no such option");
        }
        if (calibrate.isAsked()) {
            if (quick || !scenes.isEmpty()) {
                throw new InputException("--calibrate: found " + (quick ? "--quick" : "--scene")
                    + " with it, expected neither --quick nor --scene");
            }
            return calibrate.run(streams, out, tables.overwrite());
        }
        tables.check(out);
        brief.range("--jvms", jvms, 1, MOST_JVMS);
        brief.exclusive("--quick", quick, "--jvms", jvms != null);
        boolean all = scenes.isEmpty();
        List<TradeoffScene> chosen = all ? TradeoffScenes.all()
            : TradeoffScenes.of(scenes,
                word -> Games.warn(Games.computed(Games.open(word, null, streams), "tradeoff"), streams));
        if (out == null) {
            measure(chosen, null);
            return ExitStatus.DONE;
        }
        Path folder = OutputFiles.path(out);
        try (TradeoffReport files = files(folder); Interruption interruption = new Interruption(
            streams, "the scenes so far are in " + folder)) {
            measure(chosen, files);
            String problem = files.finish();
            if (problem != null) {
                streams.warn("this Java cannot draw the plot: " + problem);
            }
            interruption.over();
        }
        return ExitStatus.DONE;
    }

    private TradeoffReport files(Path folder) {
        return tables.start(folder, TradeoffReport.ALL, () -> new TradeoffReport(folder, Machine.line(), today()));
    }

    private static String today() {
        return LocalDate.now(ZoneOffset.UTC).toString();
    }

    private int times() {
        return jvms == null ? TradeoffEffort.JVMS : jvms.intValue();
    }

    private void measure(List<TradeoffScene> chosen, TradeoffReport files) {
        TradeoffEffort effort = quick ? TradeoffEffort.QUICK : TradeoffEffort.normal(times());
        TradeoffTable table = new TradeoffTable(json ? streams.withoutOutput() : streams);
        List<TradeoffRow> all = new ArrayList<>();
        RunProgress progress = new RunProgress(streams, chosen.size());
        ProgressLine.announce(streams, quick ? "a quarter of a minute a scene" : "some minutes a scene");
        for (TradeoffScene scene : chosen) {
            TradeoffMeasurement measurement = new TradeoffMeasurement(scene, effort,
                Timing.inJvms(effort.timing(), TimingMain.class));
            progress.begin(scene.name());
            List<TradeoffRow> rows;
            try {
                rows = measurement.run(progress.steps(measurement.steps()));
            } finally {
                progress.end();
            }
            if (files != null) {
                files.add(rows);
            }
            table.add(scene, rows);
            all.addAll(rows);
        }
        table.end(quick);
        if (json) {
            Json.print(streams, TradeoffReport.fields(new TradeoffResult(Machine.line(), today(), all)));
        }
    }
}

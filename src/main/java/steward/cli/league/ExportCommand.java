package steward.cli.league;

import java.io.BufferedOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.streams.StandardFiles;
import steward.files.OutputFiles;
import steward.league.store.GameStore.Version;

/** {@code steward league export}: writes the games for other programs. */
@Command(name = "export", description = "Writes the games of a league as CSV or JSON Lines.",
    footer = {
        "", "CSV has a line for each seat, JSON Lines one for each game; 'league import'",
        "reads the latter. Neither contains replays.",
        "", "Example:",
        "  steward league export night --out games.csv"})
final class ExportCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--out", paramLabel = "FILE", defaultValue = "-",
        description = "The file; - (the default) is the standard output. A name that ends in .csv means CSV.")
    private String out;

    @Option(names = "--format", paramLabel = "csv|jsonl",
        description = "The format (default: by the file's name; otherwise jsonl).")
    private String format;

    @Option(names = "--overwrite", description = "Replaces a file that exists.")
    private boolean overwrite;

    @Override
    public Integer call() {
        check.that(format == null || format.equals("csv") || format.equals("jsonl"),
            "--format: found '" + format + "', expected csv or jsonl");
        boolean csv = format == null ? out.endsWith(".csv") : format.equals("csv");
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            if (StandardFiles.is(out)) {
                write(opened, streams.out(), csv);
                return ExitStatus.DONE;
            }
            Path file = OutputFiles.path(out);
            try (PrintStream stream = new PrintStream(new BufferedOutputStream(OutputFiles.open(file, overwrite)),
                    false,
                    StandardCharsets.UTF_8)) {
                write(opened, stream, csv);
                if (stream.checkError()) {
                    throw new FailedException(file + ": cannot be written to its end: is the disk full?");
                }
            }
        }
        return ExitStatus.DONE;
    }

    private static void write(LeagueOpening.Opened opened, PrintStream out, boolean csv) {
        Map<Integer, Version> versions = new HashMap<>();
        opened.store().versions().forEach(version -> versions.put(version.id(), version));
        if (csv) {
            GameFile.csvHead(out);
        }
        opened.games().games(game -> {
            if (csv) {
                GameFile.csv(out, game, opened.season(), versions);
            } else {
                GameFile.json(out, game, opened.season(), versions);
            }
        });
    }
}

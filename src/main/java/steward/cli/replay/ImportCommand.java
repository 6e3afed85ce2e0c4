package steward.cli.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.CommandLine;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Streams;
import steward.codingame.GameRecordingImport;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.text.TextFormat;

/** {@code steward import}: makes a replay from an official recording. */
@Command(name = "import", description = "Makes a replay from CodinGame's own JSON of a pod race. Verifying it compares "
    + "the official game with these rules and this physics, to the last bit.",
    footer = {"", "Example:",
        "  steward import game.json --out game.jsonl && steward replay game.jsonl --verify",
        "", "Exit status: 0 imported; 2 the file or the call is wrong: the error names frame and line."})
public final class ImportCommand implements Callable<Integer> {

    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private final Streams streams;

    @Parameters(index = "0", paramLabel = "FILE", description = "The recording.")
    private String file;

    @Option(names = "--out", paramLabel = "REPLAY", required = true, description = "Where the replay goes.")
    private String out;

    @Option(names = "--overwrite", description = "Replace a replay that exists.")
    private boolean overwrite;

    public ImportCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() throws InterruptedException {
        Path replay = OutputFiles.path(out);
        Path recorded = OutputFiles.path(file);
        GameRecordingImport recording = read(recorded, replay);
        GameRecordingImport.Imported imported;
        try (OutputStream stream = OutputFiles.open(replay, overwrite)) {
            imported = recording.write(stream);
        } catch (IOException problem) {
            throw new FailedException(replay + ": cannot be closed: " + problem.getMessage());
        }
        streams.out().println("imported: " + TextFormat.count(imported.turns(), "turn") + ", "
            + (imported.ending() == null ? "and there the recording ends" : imported.ending()));
        streams.out().println("  steward replay " + CommandLine.quote(List.of(replay.toString()))
            + " --verify   compares every turn with these rules");
        return ExitStatus.DONE;
    }

    private static GameRecordingImport read(Path recorded, Path replay) {
        try {
            if (Files.exists(replay) && Files.isSameFile(recorded, replay)) {
                throw new InputException("--out: found the recording itself, expected another file");
            }
            String json = Files.readString(recorded, StandardCharsets.UTF_8);
            return GameRecordingImport.of(json.startsWith(BYTE_ORDER_MARK) ? json.substring(1) : json,
                recorded.toString(), Games.types());
        } catch (IOException problem) {
            throw new InputException(recorded + (Files.exists(recorded)
                ? ": found something else, expected a readable file in UTF-8"
                : ": found no such file, expected a recording"));
        } catch (IllegalArgumentException problem) {
            throw new InputException(problem.getMessage());
        }
    }
}

package steward.cli.replay;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPInputStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import steward.bot.command.CommandLine;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.cli.streams.StandardFiles;
import steward.codingame.recording.DifferentGameException;
import steward.codingame.recording.RecordingImport;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.podrace.RulesEdition;
import steward.replay.page.UnclosedOutputStream;
import steward.report.Fields;
import steward.text.TextFormat;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/** {@code steward import}: makes a replay from an official recording. */
@Command(name = "import", description = "Makes a replay from CodinGame's own JSON of a game. Verifying it compares "
    + "the official game with these rules and this physics, to the last bit.",
    footer = {
        "", "FILE is the JSON that the site's own page gets from its server: the answer of",
        "gameResult/findByGameId, or of any request whose answer has \"frames\". The game",
        "is recognised by its first view. The file may be packed by gzip. For a game for",
        "one player, FILE can also be {\"stdin\":[..],\"stdout\":[..]}, the lines sent and",
        "answered. Each sent line is compared with ours.",
        "", "A game with a published referee needs --scene, the scene that 'steward",
        "adopt' made. FILE can also be what the SDK's own runner writes. The recorded",
        "answers are played into the referee, and all that it says is compared at once.",
        "If anything differs, the other league levels of the scene are tried, and named.",
        "", "--json: turns, ending (null if the recording ends before), replay; with --scene",
        "also equal, difference or null, note or null, notCompared, others.",
        "", "Examples:",
        "  steward import game.json --out game.jsonl",
        "  steward replay game.jsonl --verify",
        "  steward import game.json --scene exotec.json --out game.jsonl",
        "  curl ... | steward import - --out - | steward replay - --verify",
        "", "Exit status: 0 imported; 1 a line of the server differs, or a frame from the",
        "referee of --scene; 2 wrong file or call: the error names frame and line."})
public final class ImportCommand extends ProgramCommand {

    private static final String RECORDING = "a recording";
    private static final int MOST_LEVEL = 20;
    private static final String BYTE_ORDER_MARK = "\uFEFF";

    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "FILE", description = "The recording; - is the standard input.")
    private String file;

    @Option(names = "--out", paramLabel = "REPLAY", required = true,
        description = "The file of the replay; - is the standard output.")
    private String out;

    @Option(names = "--rules", paramLabel = "live|contest",
        description = "The rules of a pod race: those of the live server (default), or those of the contest of "
            + "2016. Other games have the rules of their highest league.")
    private RulesEdition rules;

    @Option(names = "--scene", paramLabel = "FILE", description = "The scene of the game's referee, where that is an "
        + "adopted one: the game is compared at once. Named again, others to try if a frame differs.")
    private List<String> scenes = List.of();

    @Option(names = "--league-level", paramLabel = "N", description = "With --scene: the league level at which it was "
        + "played (default: the scene's).")
    private Integer level;

    @Option(names = "--overwrite", description = "Replaces a replay that exists.")
    private boolean overwrite;

    @Option(names = "--json", description = "Prints one JSON object instead of words; see below.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        boolean piped = StandardFiles.is(out);
        if (json && piped) {
            throw new ParameterException(spec.commandLine(),
                "--json is printed to the standard output, expected a file for --out");
        }
        check.that(level == null || !scenes.isEmpty(), "--league-level: expected --scene with it");
        check.that(level == null || level >= 1 && level <= MOST_LEVEL, "--league-level: found " + level
            + ", expected 1 to " + MOST_LEVEL);
        check.exclusive("--rules", rules != null, "--scene", !scenes.isEmpty());
        Path replay = piped ? null : OutputFiles.path(out);
        String source = StandardFiles.is(file) ? StandardFiles.INPUT : file;
        String text = text(replay, source);
        if (!scenes.isEmpty()) {
            if (replay != null) {
                OutputFiles.check(replay, overwrite);
            }
            return new GuestImport(streams, text, source, scenes, level).run(bytes -> write(bytes, replay),
                piped ? null : json, out);
        }
        RecordingImport recording = InputException.of(() -> RecordingImport.of(text, source, Games.types(), rules));
        RecordingImport.Imported imported;
        try (OutputStream stream = piped ? new UnclosedOutputStream(streams.out())
                : OutputFiles.open(replay, overwrite)) {
            imported = recording.write(stream);
        } catch (IOException problem) {
            throw new FailedException(replay + ": cannot be closed: " + problem.getMessage());
        } catch (DifferentGameException difference) {
            throw new FailedException(difference.getMessage());
        }
        if (json) {
            Json.print(streams, Fields.of("turns", imported.turns(), "ending", imported.ending(), "replay", out));
        } else if (!piped) {
            streams.out().println("imported: " + TextFormat.count(imported.turns(), "turn") + ", "
                + (imported.ending() == null ? "and there the recording ends" : imported.ending()));
            streams.out().println("  steward replay " + CommandLine.quote(List.of(replay.toString()))
                + " --verify   compares every turn with these rules");
        }
        return ExitStatus.DONE;
    }

    /** @param replay or {@code null} for the standard output */
    private void write(byte[] bytes, Path replay) {
        try (OutputStream stream = replay == null ? new UnclosedOutputStream(streams.out())
                : OutputFiles.open(replay, overwrite)) {
            stream.write(bytes);
        } catch (IOException problem) {
            throw new FailedException(out + ": cannot be written: " + problem.getMessage());
        }
    }

    private String text(Path replay, String source) {
        byte[] bytes = unpacked(StandardFiles.is(file) ? StandardFiles.readAll(streams, RecordingImport.MOST_BYTES,
            RECORDING) : readFile(OutputFiles.path(file), replay), source);
        try {
            String text = Utf8Text.decode(bytes, source, "CodinGame's JSON of a game");
            return text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
        } catch (NotUtf8Exception problem) {
            throw new InputException(problem.getMessage());
        }
    }

    /** Files that gzip has packed begin with two bytes of their own, which no text does. */
    private static byte[] unpacked(byte[] bytes, String source) {
        if (bytes.length < 2 || (bytes[0] & 0xFF | (bytes[1] & 0xFF) << 8) != GZIPInputStream.GZIP_MAGIC) {
            return bytes;
        }
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
            return StandardFiles.readAll(in, source, RecordingImport.MOST_BYTES, RECORDING);
        } catch (IOException problem) {
            throw new InputException(source + ": found a file of gzip that is damaged or was cut off, expected all of "
                + "it");
        }
    }

    private static byte[] readFile(Path recorded, Path replay) {
        if (OutputFiles.isSame(recorded, replay)) {
            throw new InputException("--out: found the recording itself, expected another file");
        }
        if (Files.isDirectory(recorded)) {
            throw new InputException(recorded + ": found a folder, expected a recording");
        }
        try (InputStream in = Files.newInputStream(recorded)) {
            return StandardFiles.readAll(in, recorded.toString(), RecordingImport.MOST_BYTES, RECORDING);
        } catch (IOException problem) {
            throw new InputException(recorded + (Files.exists(recorded)
                ? ": cannot be read: no permission" : ": found no such file, expected a recording"));
        }
    }
}

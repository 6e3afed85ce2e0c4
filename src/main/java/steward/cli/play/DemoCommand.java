package steward.cli.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.bot.command.CommandLine;
import steward.cli.options.AccuracyOption;
import steward.cli.options.ProgramCommand;
import steward.cli.replay.ReplayCommand;
import steward.cli.replay.TextMap;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.Verbosity;
import steward.cli.streams.StandardFiles;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.Hiccups;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.match.Protocol;
import steward.replay.ReplayReader;
import steward.replay.verify.Verification;
import steward.text.TextFormat;

/** {@code steward demo}: a match between two bots that come with the program, recorded, verified and drawn. */
@Command(name = "demo", description = "Plays two of the bots that come with the program, veteran and racer, against "
    + "each other, verifies the replay and draws a map of the race.",
    footer = {"", "--json: as in 'steward match --json'.", "", "Example:", "  steward demo --seed 7"})
public final class DemoCommand extends ProgramCommand {

    private static final String SCENE = "mad-pod-racing";
    /** Exists in the folder of the project only. */
    private static final String SOURCES = "src/main/java/steward/cli/play/DemoCommand.java";
    private static final List<String> BOTS = List.of("builtin:veteran", "builtin:racer");
    /** A demo is no contest: on a busy machine bots get the time they need. */
    private static final int TIME_FACTOR = 10;

    @Option(names = "--out", paramLabel = "FILE",
        description = "The file of the replay, replaced if it exists (default: in a temporary folder; in "
            + "Steward's source folder build/demo.jsonl).")
    private String out;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1",
        description = "The seed of the race (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Mixin
    private final AccuracyOption accuracy = new AccuracyOption();

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        if (StandardFiles.is(out)) {
            throw new InputException("--out: found -, expected a file: the replay is read again");
        }
        Path file = OutputFiles.path(out != null ? out : usualFile(Path.of("")));
        Contest contest = Contest.of(accuracy.open(SCENE, streams), BOTS, Protocol.JSON, TIME_FACTOR);
        makeFolder(file);
        OutputFiles.check(file, true);
        Streams told = json ? streams.withoutOutput() : streams;
        told.out().println("steward match --scene " + SCENE + " --bot " + BOTS.get(0) + " --bot " + BOTS.get(1)
            + " --seed " + seed + accuracy.words() + " \\");
        told.out().println("    --time-factor " + TIME_FACTOR + " --out "
            + CommandLine.quote(List.of(file.toString()))
            + " --overwrite");
        told.out().println();
        told.out().flush();
        new SingleMatch(streams, contest, json ? Verbosity.JSON : Verbosity.FULL, false, false, Hiccups.REPLAY)
            .play(seed, file, true);
        told.out().println();
        try (ReplayReader replay = ReplayCommand.open(file)) {
            Verification verification = Verification.of(replay, Games.types());
            if (!verification.verified()) {
                (json ? streams.err() : streams.out()).println(told.outColour().bad("not verified:") + " "
                    + (verification.difference() == null ? verification.warning() : verification.difference()));
                return ExitStatus.FAILED;
            }
            told.out().println(told.outColour().good("verified:") + " "
                + TextFormat.count(verification.turns(), "turn")
                + " played again, every one the same to the last bit");
        }
        told.out().println();
        try (ReplayReader replay = ReplayCommand.open(file)) {
            told.out().print(TextMap.of(replay));
        }
        return ExitStatus.DONE;
    }

    /**
     * A file for the replay: in the build folder of the project, elsewhere in a new temporary folder.
     *
     * @param here the folder in which the program was called
     */
    static String usualFile(Path here) {
        if (Files.exists(here.resolve(SOURCES))) {
            return here.resolve("build/demo.jsonl").toString();
        }
        try {
            return Files.createTempDirectory("steward-").resolve("demo.jsonl").toString();
        } catch (IOException problem) {
            throw new InputException("found no temporary folder for the replay (" + problem.getMessage()
                + "), expected --out");
        }
    }

    private static void makeFolder(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        try {
            if (folder != null) {
                Files.createDirectories(folder);
            }
        } catch (IOException problem) {
            throw new InputException(folder + ": found no folder, and it cannot be made: "
                + OutputFiles.reason(folder, problem));
        }
    }
}

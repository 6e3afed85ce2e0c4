package steward.cli.league;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SceneOptions;
import steward.cli.options.SeedFileOption;
import steward.cli.options.SeedOption;
import steward.cli.options.ShippedScenes;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.contest.KeptReplays;
import steward.contest.seeds.SeedFile;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.scene.SceneFiles;

/** {@code steward league init}: makes the folder of a league. */
@Command(name = "init", description = "Makes the folder of a league.",
    footer = {
        "", "If the scene is a file, it is copied into the folder with its CSV files.",
        "Everything else is in league.json and can be changed there.",
        "", "Example:",
        "  steward league init night --scene mad-pod-racing --keep lost"})
final class InitCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--scene", paramLabel = "FILE|NAME", defaultValue = SceneOptions.USUAL,
        completionCandidates = ShippedScenes.class, description = "The scene: a file, or one of "
            + "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private String scene;

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Option(names = SeedFileOption.NAME, paramLabel = "FILE", description = "Every group of bots plays the seeds of "
        + "this file, one a line, which is copied into the folder.")
    private String list;

    @Option(names = "--time-factor", paramLabel = "X", description = "Multiplies the scene's time limits.")
    private Double factor;

    @Option(names = "--keep", paramLabel = "all|lost|failed|none",
        description = "Which replays are kept. all; lost: games that have a loser; failed (default): games in "
            + "which a bot failed; none.")
    private KeptReplays keep;

    @Override
    public Integer call() {
        check.that(factor == null || factor > 0 && factor < Double.POSITIVE_INFINITY,
            "--time-factor: found " + factor + ", expected a finite number above 0");
        check.exclusive("--seed", seed.isGiven(), SeedFileOption.NAME, list != null);
        SeedFile seeds = list == null ? null : SeedFile.read(OutputFiles.path(list));
        KeptReplays kept = keep == null ? KeptReplays.FAILED : keep;
        Games.warn(Games.open(scene), streams);
        Path path = league.path();
        LeagueFolder folder = new LeagueFolder(path);
        prepare(path);
        boolean file = SceneFiles.file(scene).isPresent();
        LeagueSettings settings = LeagueSettings.usual(file ? LeagueFolder.SCENE : name(scene), seed.orDrawn())
            .with(null, factor == null ? 1 : factor, kept).listing(seeds == null ? null : LeagueFolder.SEEDS);
        try {
            if (file) {
                SceneFiles.copy(Path.of(scene), path.resolve(LeagueFolder.SCENE));
            }
            if (seeds != null) {
                Files.writeString(path.resolve(LeagueFolder.SEEDS), seeds.text());
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be written: "
                + OutputFiles.reason(path, problem));
        }
        folder.write(settings);
        streams.out().println("A league of " + settings.scene() + " in " + path + "; next:");
        streams.out().println("  steward league add " + path + " 'NAME=COMMAND'");
        streams.out().println("  steward league run " + path);
        return ExitStatus.DONE;
    }

    private static String name(String scene) {
        return SceneFiles.shipped().contains(scene) ? scene : scene.replaceFirst("\\.json$", "");
    }

    /** Makes the folder; one that has a league already is refused, and one with anything else. */
    private static void prepare(Path path) {
        if (Files.exists(path.resolve(LeagueFolder.SETTINGS))) {
            throw new InputException(path + ": found a league, expected a new folder");
        }
        OutputFiles.prepareFolder(path);
        LeagueFolder.refuseRemote(path);
        try (Stream<Path> files = Files.list(path)) {
            if (files.findAny().isPresent()) {
                throw new InputException(path + ": found a folder with files, expected an empty or a new one");
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be read: " + OutputFiles.reason(path, problem));
        }
        OutputFiles.privateFolder(path);
    }
}

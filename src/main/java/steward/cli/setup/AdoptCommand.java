package steward.cli.setup;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.CommandLine;
import steward.bot.isolation.Isolation;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Pages;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.guest.Adoption;
import steward.guest.RefereeFault;
import steward.guest.project.SdkProject;

/** {@code steward adopt}: writes a scene for a published referee. */
@Command(name = "adopt", description = "Makes a scene for a referee that its author has published as a project on "
    + "CodinGame's SDK. Builds the project with Maven if need be, and plays trial games with idle bots.",
    footer = {"", "Examples:", "  steward adopt SpringChallenge2021",
        "  steward adopt SpringChallenge2023 --as ants --engine 4.3.0",
        "  steward adopt Troll-Farm --engine-source codingame-game-engine",
        "", "Exit status: 0 written; 1 no trial game came to its end; 2 the project cannot be",
        "built, or the call is wrong."})
public final class AdoptCommand extends ProgramCommand {

    @Parameters(index = "0", paramLabel = "DIR|JAR",
        description = "The folder of the project, or a jar that contains everything.")
    private String project;

    @Option(names = "--as", paramLabel = "NAME", description = "The name of the scene, written into NAME.json "
        + "(default: the project's name in lower case).")
    private String name;

    @Option(names = "--engine", paramLabel = "VERSION", description = "Builds it with this version of the SDK's "
        + "engine instead of its own.")
    private String engine;

    @Option(names = "--engine-source", paramLabel = "DIR", description = "Builds the SDK's engine from a clone of "
        + "its repository, for a version that no Maven repository has. It is kept in Steward's cache.")
    private String engineSource;

    @Option(names = "--overwrite", description = "Replaces a scene that exists.")
    private boolean overwrite;

    @Override
    public Integer call() {
        Path path = OutputFiles.path(project);
        String called = name != null ? name : path.toAbsolutePath().normalize().getFileName().toString()
            .replaceFirst("\\.jar$", "").toLowerCase(Locale.ROOT);
        if (!called.matches("[\\w.-]{1,100}")) {
            throw new InputException("--as: found '" + called + "', expected letters, digits, '-', '_' and '.'");
        }
        if (engine != null && !engine.matches("[\\w.-]{1,40}")) {
            throw new InputException("--engine: found '" + engine + "', expected a version such as 4.3.0");
        }
        Path source = engineSource == null ? null : OutputFiles.path(engineSource);
        if (source != null && !Files.isDirectory(source)) {
            throw new InputException("--engine-source: found no folder " + source + ", expected a clone of "
                + SdkProject.ENGINE_REPOSITORY);
        }
        Path file = OutputFiles.path(called + ".json");
        OutputFiles.check(file, overwrite);
        Adoption.Made scene;
        try {
            scene = Adoption.scene(path, engine, source, called, Isolation::usual, this::say);
        } catch (RefereeFault fault) {
            throw new FailedException("no trial game came to its end: " + fault.getMessage());
        }
        Pages.write(file, scene.json().getBytes(StandardCharsets.UTF_8), overwrite);
        boolean bundled = !scene.boss().isEmpty();
        say("Written: " + file + (bundled ? ". To play in it with a bot that comes with the contest:"
            : ". To play in it:"));
        String boss = " --bot " + CommandLine.quote(List.of(CommandLine.quote(scene.boss())));
        say("  steward match --scene " + CommandLine.quote(List.of(file.toString())) + (bundled
            ? boss.repeat(scene.players()) : " --bot ./mine" + " --bot ./other".repeat(scene.players() - 1)));
        return ExitStatus.DONE;
    }

    private void say(String line) {
        streams.out().println(line);
        streams.out().flush();
    }
}

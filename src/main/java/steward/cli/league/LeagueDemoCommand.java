package steward.cli.league;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import steward.cli.league.run.NoServing;
import steward.cli.league.run.RunCommand;
import steward.cli.league.view.PageCommand;
import steward.cli.league.view.TableCommand;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import steward.contest.KeptReplays;
import steward.files.Folders;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;

/** {@code steward league demo}: the bundled bots in a small league. */
@Command(name = "demo", description = "Plays a small league of the bots that come with the program, in less than a "
    + "minute, and writes its page.",
    footer = {"", "--json: as in 'league table --json'.", "", "Example:", "  steward league demo --out demo"})
final class LeagueDemoCommand extends ProgramCommand {

    /** Exists in the folder of the project only. */
    private static final String SOURCES = "src/main/java/steward/cli/league/LeagueDemoCommand.java";
    private static final List<String> BOTS = List.of("racer", "regular", "contender", "veteran");
    private static final String SCENE = "mad-pod-racing";
    private static final int MOST_THREADS = 4;
    /** A demo is no contest: on a busy machine bots get the time they need. */
    private static final double TIME_FACTOR = 10;

    @Option(names = "--out", paramLabel = "DIR", description = "The folder of the league; it must be new (default: in "
        + "the folder of Steward's own sources build/league-demo, which is replaced; elsewhere a temporary one).")
    private String out;

    @Option(names = "--for", paramLabel = "TIME", defaultValue = "25s",
        description = "How long it plays, such as 25s (default: ${DEFAULT-VALUE}).")
    private String time;

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Override
    public Integer call() throws Exception {
        RunCommand.nanos(time);
        Streams told = json ? streams.withoutOutput() : streams;
        Path path = out == null ? usual() : OutputFiles.path(out);
        if (Files.exists(path)) {
            throw new InputException(path + ": exists already, and is kept; expected a new folder");
        }
        OutputFiles.privateFolder(path);
        LeagueSettings settings = LeagueSettings.usual(SCENE, 1).with(null, TIME_FACTOR, KeptReplays.LOST)
            .withBots(BOTS.stream().map(name -> new LeagueBot(name, "builtin:" + name, null, false, false)).toList());
        new LeagueFolder(path).write(settings);
        say(told, "steward league init " + path + " --scene " + SCENE + " --keep lost");
        BOTS.forEach(name -> say(told, "steward league add " + path + " builtin:" + name));
        String threads = Integer.toString(Math.min(MOST_THREADS, Runtime.getRuntime().availableProcessors()));
        say(told, "steward league run " + path + " --threads " + threads + " --for " + time);
        told.out().println();
        told.out().flush();
        int status = new RunCommand(new NoServing()).run(told, path.toString(), "--threads", threads, "--for", time);
        if (status != ExitStatus.DONE) {
            return status;
        }
        Path page = path.resolve("league.html");
        told.out().println();
        say(told, "steward league page " + path + " --out " + page);
        status = new PageCommand().run(told, path.toString(), "--out", page.toString());
        return json ? new TableCommand().run(streams, path.toString(), "--json") : status;
    }

    private static void say(Streams told, String line) {
        told.out().println("$ " + line);
    }

    private static Path usual() throws IOException {
        if (!Files.exists(Path.of(SOURCES))) {
            return Files.createTempDirectory("steward-").resolve("league-demo");
        }
        Path path = Path.of("build/league-demo");
        if (Files.exists(path)) {
            Folders.delete(path);
        }
        return path;
    }
}

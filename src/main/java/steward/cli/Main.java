package steward.cli;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import steward.cli.check.CheckCommand;
import steward.cli.explain.ExplainCommand;
import steward.cli.league.LeagueCommand;
import steward.cli.league.run.LeagueRunCommand;
import steward.cli.machines.LeagueWorkerCommand;
import steward.cli.machines.ServeOptions;
import steward.cli.machines.WorkerCommand;
import steward.cli.options.ProgramCommand;
import steward.cli.play.DemoCommand;
import steward.cli.play.MatchCommand;
import steward.cli.play.PlayCommand;
import steward.cli.play.RefereeCommand;
import steward.cli.play.RunCommand;
import steward.cli.play.SceneCommand;
import steward.cli.play.SimulateCommand;
import steward.cli.replay.FeedCommand;
import steward.cli.replay.ImportCommand;
import steward.cli.replay.KeyCommand;
import steward.cli.replay.ReplayCommand;
import steward.cli.resident.ResidentCommand;
import steward.cli.sequential.SeedsCommand;
import steward.cli.sequential.SprtCommand;
import steward.cli.sequential.TuneCommand;
import steward.cli.setup.AdoptCommand;
import steward.cli.setup.DoctorCommand;
import steward.cli.setup.NewCommand;
import steward.cli.shared.EmptyValues;
import steward.cli.shared.ErrorHandler;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Lab;
import steward.cli.shared.NumberConverter;
import steward.cli.shared.OutOfMemory;
import steward.cli.shared.WordConverter;
import steward.cli.streams.Streams;
import steward.cli.tournament.TournamentCommand;
import steward.files.InputException;

/** The program's main class: finds and runs the command that is called. {@link ExitStatus} has the exit statuses. */
@Command(name = "steward", synopsisSubcommandLabel = "COMMAND",
    description = "Referees matches between bot programs in games with exact physics.",
    footer = {
        "", "--games-path DIR, with any command: the folder with the jars of further games.",
        "The default is steward/games in your folder for data (~/.local/share).",
        "docs/new-game.md tells how to make a game.",
        "", "Examples:",
        "  steward demo",
        "  steward new python mybot",
        "  steward match --bot builtin:veteran --bot 'python3 bot.py' --out match.jsonl",
        "  steward replay match.jsonl --verify"})
public final class Main {

    /** An option that passes a whole command line as one argument. */
    private static final String WHOLE = "--cli";

    /** The columns of a terminal. */
    static final int WIDTH = 80;

    private static final List<String> COMMANDS = List.of("match", "run", "replay", "feed", "scene", "explain", "demo",
        "league", "worker", "sprt", "tune", "seeds", "check", "tournament",
        "simulate", "import", "key", "referee", "play", "resident", "tradeoff", "bench", "new", "adopt",
        "doctor",
        CompletionCommand.NAME, HelpCommand.NAME);

    /** The commands that are about all commands. */
    private static final List<String> TAKES_ALL = List.of(CompletionCommand.NAME, HelpCommand.NAME);

    private Main() { }

    /** The names of all commands, in listed order. */
    public static List<String> commands() {
        return COMMANDS;
    }

    /** Runs the program and exits with its status. */
    public static void main(String[] arguments) {
        Streams streams = Streams.standard();
        OutOfMemory.endProgram(streams);
        System.exit(run(streams, arguments));
    }

    /** Runs the program. @return the exit status */
    public static int run(Streams streams, String... arguments) {
        try {
            return call(streams, arguments);
        } catch (OutOfMemoryError problem) {
            return OutOfMemory.report(streams);
        }
    }

    private static int call(Streams streams, String... arguments) {
        List<String> words = List.of(arguments);
        if (words.size() == 2 && words.get(0).equals(WHOLE)) {
            try {
                words = steward.bot.command.CommandLine.split(words.get(1));
            } catch (IllegalArgumentException problem) {
                streams.err().println("steward: " + WHOLE + ", " + problem.getMessage());
                return ExitStatus.UNUSABLE;
            }
        }
        try (GamesPath games = GamesPath.of(words)) {
            return execute(streams, games.words());
        } catch (InputException problem) {
            streams.err().println("steward: " + problem.getMessage());
            return ExitStatus.UNUSABLE;
        }
    }

    private static int execute(Streams streams, List<String> words) {
        String called = words.isEmpty() ? null : words.get(0);
        boolean version = words.size() == 1 && StandardOptions.VERSION.contains(called);
        CommandLine program = version ? program(streams, List.of()) : program(streams, called);
        int status = ExitStatus.DONE;
        if (words.isEmpty()) {
            program.usage(streams.out());
        } else {
            status = program.execute(words.toArray(new String[0]));
        }
        String problem = streams.outProblem();
        if (problem != null) {
            streams.err().println("steward: cannot write the output: " + problem);
            return status == ExitStatus.DONE ? ExitStatus.FAILED : status;
        }
        return status;
    }

    /** The program with only the called command, or with all of them if there is none of that name. */
    public static CommandLine program(Streams streams, String called) {
        boolean one = called != null && !TAKES_ALL.contains(called) && COMMANDS.contains(called);
        return program(streams, one ? List.of(called) : COMMANDS);
    }

    private static CommandLine program(Streams streams, List<String> commands) {
        CommandLine program = new CommandLine(new Main());
        dress(program, streams);
        for (String name : commands) {
            CommandLine line = new CommandLine(command(name));
            dress(line, streams);
            program.addSubcommand(name, line);
        }
        NumberConverter.register(program);
        WordConverter.register(program);
        ErrorHandler problems = new ErrorHandler(streams);
        program.setExpandAtFiles(false);
        program.setUsageHelpWidth(WIDTH);
        program.setOut(new PrintWriter(streams.out(), true, StandardCharsets.UTF_8));
        program.setErr(new PrintWriter(streams.err(), true, StandardCharsets.UTF_8));
        program.setExecutionStrategy(new EmptyValues());
        program.setParameterExceptionHandler(problems);
        program.setExecutionExceptionHandler(problems);
        return program;
    }

    private static Object command(String name) {
        return switch (name) {
            case "match" -> new MatchCommand();
            case "run" -> new RunCommand();
            case "replay" -> new ReplayCommand();
            case "feed" -> new FeedCommand();
            case "scene" -> new SceneCommand();
            case "explain" -> new ExplainCommand();
            case "demo" -> new DemoCommand();
            case "league" -> LeagueCommand.spec(Map.of("run", new LeagueRunCommand(new ServeOptions()),
                "worker", new LeagueWorkerCommand()));
            case "worker" -> new WorkerCommand();
            case "sprt" -> new SprtCommand();
            case "tune" -> new TuneCommand();
            case "seeds" -> new SeedsCommand();
            case "check" -> new CheckCommand();
            case "tournament" -> new TournamentCommand();
            case "simulate" -> new SimulateCommand();
            case "import" -> new ImportCommand();
            case "key" -> new KeyCommand();
            case "referee" -> RefereeCommand.spec();
            case "play" -> new PlayCommand();
            case "resident" -> new ResidentCommand(Main::run);
            case "tradeoff", "bench" -> Lab.commandOrMissing(name);
            case "new" -> new NewCommand();
            case "adopt" -> new AdoptCommand();
            case "doctor" -> new DoctorCommand();
            case HelpCommand.NAME -> new HelpCommand();
            default -> new CompletionCommand();
        };
    }

    private static void dress(CommandLine line, Streams streams) {
        line.getSubcommands().values().forEach(each -> dress(each, streams));
        CommandSpec spec = line.getCommandSpec();
        if (spec.userObject() instanceof ProgramCommand command) {
            command.on(streams);
        }
        spec.addMixin("standardOptions", CommandSpec.forAnnotatedObject(new StandardOptions()));
        spec.versionProvider(new Version());
        spec.usageMessage().sortOptions(false);
        OptionForms.complete(spec, !spec.name().equals("referee"));   // its short options are those of its callers
        OptionForms.arrange(spec);
    }
}

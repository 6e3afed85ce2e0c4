package steward.cli.check;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.BotCommand;
import steward.cli.options.BotFolders;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SceneOptions;
import steward.cli.options.TimeLimitOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailureReason;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.match.Protocol;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward check}: checks whether a bot is ready to play. */
@Command(name = "check", description = "Checks a bot: whether it starts, answers in time and plays a whole game. "
    + "If not, tells what to do.",
    footer = {
        "", "The bot plays against the weakest bundled bot of the game, and against players",
        "that never answer. Its slowest answer must leave a fifth of the limit.",
        "", "--json: bot, scene, passes, steps and problems (texts), fault and failure (or",
        "null).",
        "", "Examples:",
        "  steward check 'python3 bot.py'",
        "  steward check codingame:./bot --scene duel",
        "", "Exit status: 0 the bot is ready; 1 something is wrong; 2 the call is wrong, or",
        "the program does not exist."})
public final class CheckCommand extends ProgramCommand {

    private static final int WIDTH = 80;

    @Parameters(index = "0", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "The bot, [NAME=][json:|codingame:]COMMAND.")
    private String bot;

    @Mixin
    private final BotFolders folders = new BotFolders();

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "json",
        description = "The protocol of a bot without a prefix: json or codingame (default: ${DEFAULT-VALUE}).")
    private Protocol protocol;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    @Option(names = "--json", description = "Prints one JSON object instead; see below.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        double factor = pace.factor();
        GameSetup setup = Games.warn(scene.open(streams), streams);
        Contest empty = Contest.withoutBots(setup, factor).limitedBy(pace.basis())
            .isolatedBy(sandbox.isolation(streams));
        Contest.Entrant entrant = Contest.entrant(bot, folders.folder(), null, protocol);
        return run(streams, empty, entrant.within(pace.own(List.of(entrant.name())).get(entrant.name())),
            folders.folder(), json);
    }

    /**
     * Checks a bot and says what came of it.
     *
     * @return the exit status
     * @throws InputException if it cannot be started, or the scene does not have its protocol
     */
    public static int run(Streams streams, Contest empty, Contest.Entrant entrant) throws InterruptedException {
        return run(streams, empty, entrant, Path.of(""), false);
    }

    private static int run(Streams streams, Contest empty, Contest.Entrant entrant, Path folder, boolean json)
            throws InterruptedException {
        if (entrant.problem() != null) {
            throw new InputException(entrant.problem() + Advice.missing(BotCommand.parse(entrant.bot()).words(), folder)
                .map(advice -> ". " + advice).orElse(""));
        }
        Contest.checkPlayable(empty.setup(), List.of(entrant));
        BotCheck check = BotCheck.of(empty, entrant);
        if (json) {
            Json.print(streams, Fields.of("bot", check.bot().name(), "scene", check.contest().sceneName(),
                "passes", check.passes(), "steps", check.steps(), "problems", check.problems(),
                "fault", check.failure() == null ? null : check.failure().reason(),
                "failure", FailureReason.fields(check.failure())));
        } else {
            print(streams.out(), check);
        }
        return check.passes() ? ExitStatus.DONE : ExitStatus.FAILED;
    }

    /** All that the check found, in some ten lines. */
    public static void print(PrintStream out, BotCheck check) {
        out.println(TextFormat.plain(check.bot().name() + " in " + check.contest().sceneName()));
        check.steps().forEach(step -> out.println(TextFormat.plain(step)));
        check.problems().forEach(problem -> out.println(TextFormat.wrap(TextFormat.plain(problem) + ".", " ", WIDTH,
            "")));
        if (check.failure() != null && !check.failure().stderr().isEmpty()) {
            FailureReason.print(out, check.failure(), "  ");
        }
        if (check.passes()) {
            out.println("It is ready.");
        }
    }
}

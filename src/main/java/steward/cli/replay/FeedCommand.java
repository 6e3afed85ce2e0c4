package steward.cli.replay;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.BotCommand;
import steward.bot.command.Program;
import steward.bot.process.Debugger;
import steward.cli.options.BotFolders;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.OptionSection;
import steward.cli.options.ProgramCommand;
import steward.cli.options.RefereeOption;
import steward.cli.shared.PlayerChoice;
import steward.cli.streams.StandardFiles;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.match.Protocol;
import steward.replay.RecordedMatch;
import steward.replay.ReplayReader;
import steward.replay.verify.Resimulation;

/** {@code steward feed}: sends a bot the lines that one player of a recorded match was sent. */
@Command(name = "feed", description = "Sends a bot the lines that one player of a recorded match was sent, "
    + "without deadlines, and compares its answers with the recorded ones. Or lets it play on from a turn.",
    footer = {
        "", "A bot is a command. NAME= may stand before it, and json:, codingame: or",
        "builtin:, as for 'match', to give its protocol. Without such a prefix the",
        "protocol is that of the recorded player.",
        "", "The bot's stderr and terminal are left as they are. To debug it:",
        "  gdb        'feed ... -- gdb ./a.out' gives gdb the terminal, and the bot that",
        "             it runs the frames: set breakpoints, then 'run'. With arguments:",
        "             gdb --args ./a.out x y. Ctrl-C stops the bot while it runs; at",
        "             gdb's own prompt it ends everything.",
        "  any other  with --pause or --until the bot waits while you attach to the",
        "             process whose number is printed: lldb -p PID, gdb -p PID; most",
        "             IDEs can do that too.",
        "  Java       -- java -agentlib:jdwp=transport=dt_socket,server=y,suspend=y,\\",
        "             quiet=y,address=5005 Bot",
        "  Python     breakpoint() reads the bot's own input: use a debugger that",
        "             listens on a port.",
        "", "With --replace the other players do not react: their recorded commands are",
        "applied unchanged, and a player who failed fails again. The match ends by the",
        "rules, or when a remaining player has no recorded answer. Then the new replay",
        "has no result, but can be verified. A bot that still runs a second after the",
        "end is killed, unless there is a debugger or --pause.",
        "", "--json: player, name, bot, protocol, compared, same, differing (turn,",
        "recordedFault, fault, fields: field, recorded, now). With --replace also",
        "played: turns, turnsInAll, ending or null, noResultBecause, ahead, replay.",
        "", "Examples:",
        "  steward feed match.jsonl --player 0 -- ./mybot",
        "  steward feed match.jsonl --player veteran -- builtin:contender",
        "  steward feed match.jsonl --player 0 --pause=57 -- python3 bot.py",
        "  steward feed match.jsonl --player 0 -- gdb ./a.out",
        "  steward feed match.jsonl --player 0 --from-turn 57 --replace --out new.jsonl \\",
        "      -- ./mybot",
        "", "Exit status: 0 all compared answers are equal; 1 some differ; 2 wrong call or",
        "file."})
public final class FeedCommand extends ProgramCommand {

    @Parameters(index = "0", paramLabel = "REPLAY",
        description = "The recorded match; - is the standard input.")
    private String file;

    @Parameters(index = "1..*", arity = "0..*", paramLabel = "COMMAND", completionCandidates = BuiltinBotWords.class,
        description = "The bot and its arguments, after --.")
    private List<String> command = new ArrayList<>();

    @Mixin
    private final BotFolders folders = new BotFolders();

    @Option(names = "--player", paramLabel = "P", required = true,
        description = "Which player: its number, counted from 0, or its name.")
    private String playerTyped;

    @Option(names = "--protocol", paramLabel = "W",
        description = "The protocol of a bot without a prefix: json or codingame (default: that of the player).")
    private Protocol protocol;

    @Mixin
    private final RefereeOption referee = new RefereeOption();

    @Option(names = "--until", paramLabel = "N",
        description = "Stops when turn N has been answered; the bot waits until you press Enter or it ends.")
    private Integer until;

    @Option(names = "--pause", paramLabel = "N", arity = "0..1", fallbackValue = "1",
        description = "Waits for Enter before turn N is sent (default: before everything).")
    private Integer pause;

    @OptionSection("Playing on")
    @Option(names = "--from-turn", paramLabel = "N", description = "With --replace: the first turn that the bot plays.")
    private Integer from;

    @OptionSection("Playing on")
    @Option(names = "--replace",
        description = "Lets the bot play on in place of the player; with --from-turn and --out.")
    private boolean replace;

    @OptionSection("Playing on")
    @Option(names = "--out", paramLabel = "NEW",
        description = "With --replace: where the new replay goes; - is the standard output.")
    private String out;

    @OptionSection("Playing on")
    @Option(names = "--overwrite", description = "Replaces a replay that exists.")
    private boolean overwrite;

    @Option(names = "--quiet", description = "Prints only what differs, and the summary.")
    private boolean quiet;

    @Option(names = "--json", description = "Prints one JSON object instead; see below.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        checkCall();
        Path path = StandardFiles.is(file) ? null : OutputFiles.path(file);
        RecordedMatch match;
        try (ReplayReader replay = path == null ? StandardFiles.openReplay(streams) : ReplayCommand.open(path)) {
            match = RecordedMatch.read(replay);
        }
        int player = PlayerChoice.of(playerTyped, match.header().names(), match.source());
        int last = match.lastAsked(player);
        checkTurn("--until", until, last, match, player);
        checkTurn("--pause", pause, last, match, player);
        checkTurn("--from-turn", from, last, match, player);
        if (out != null && !StandardFiles.is(out) && OutputFiles.isSame(path, OutputFiles.path(out))) {
            throw new InputException("--out: found the replay itself, expected another file");
        }
        BotCommand bot = bot(match.header().protocols().get(player));
        check.that(pause == null || !Debugger.is(bot.words()),
            "--pause is for attaching, expected none with a debugger");
        Protocol spoken = spoken(bot);
        Resimulation again = new Resimulation(match.header(), replace ? null : match.start(),
            referee.types(), match.source());
        if (spoken == Protocol.CODINGAME && again.setup().textCodec(again.game()).isEmpty()) {
            throw new InputException("--protocol: found codingame, expected json: the scene has no other");
        }
        FeedSession feeding = new FeedSession(streams, referee.types(), match, player, bot, spoken,
            program(bot, again), pause, quiet, json, StandardFiles.is(out));
        return replace ? feeding.replace(from, out, overwrite)
            : feeding.compare(until == null ? Integer.MAX_VALUE : until);
    }

    private void checkCall() {
        check.that(!command.isEmpty(), "expected the command of a bot: steward feed REPLAY --player P -- COMMAND");
        check.that(!replace || from != null && out != null, "--replace: expected --from-turn and --out with it");
        check.that(replace || from == null, "--from-turn is for --replace, expected both");
        check.that(replace || out == null, "--out is for --replace, expected both");
        check.that(!overwrite || out != null, "--overwrite: expected --out with it");
        check.exclusive("--until", until != null, "--replace", replace);
        check.that(!json || !StandardFiles.is(out),
            "--json is printed to the standard output, expected a file for --out");
        check.that(!StandardFiles.is(file) || pause == null && until == null,
            "--pause and --until wait for Enter on the standard input, expected a file for REPLAY with them");
    }

    private static void checkTurn(String option, Integer turn, int last, RecordedMatch match, int player) {
        if (turn != null && (turn < 1 || turn > last)) {
            throw new InputException(option + ": found " + turn + ", expected " + (last == 0 ? "none: there is no turn"
                : "1 to " + last + ", the last turn") + " in which player " + player + " was asked in "
                + match.source());
        }
    }

    /** A single word is split as 'match' does, unless it names a file. */
    private BotCommand bot(Protocol recorded) {
        Protocol usual = protocol == null ? recorded : protocol;
        BotCommand.Prefix prefix = usual == Protocol.CODINGAME ? BotCommand.Prefix.CODINGAME : BotCommand.Prefix.JSON;
        boolean isFile = !command.get(0).isEmpty()
            && Files.exists(folders.folder().resolve(OutputFiles.path(command.get(0))));
        return InputException.of(() -> command.size() > 1 || isFile
            ? BotCommand.of(command, prefix) : BotCommand.parse(command.get(0), prefix));
    }

    private Protocol spoken(BotCommand bot) {
        Protocol spoken = bot.prefix() == BotCommand.Prefix.CODINGAME ? Protocol.CODINGAME : Protocol.JSON;
        if (protocol != null && spoken != protocol) {
            throw new InputException("--protocol: found " + protocol.word() + ", expected " + spoken.word()
                + " or none: '" + bot + "' speaks " + spoken.word());
        }
        return spoken;
    }

    private Program program(BotCommand bot, Resimulation match) {
        return InputException.of(() -> {
            Program program = new Program(bot.resolve(folders.folder()), folders.folder(), null);
            bot.checkPlays(match.setup().scene().gameId());
            return program;
        });
    }
}

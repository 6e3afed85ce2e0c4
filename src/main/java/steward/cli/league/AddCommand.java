package steward.cli.league;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.BotCommand;
import steward.bot.command.Platform;
import steward.cli.check.CheckCommand;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.BotFolders;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.contest.Contest;
import steward.files.InputException;
import steward.league.BotIdentity;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueReader;
import steward.league.LeagueSettings;
import steward.match.OwnLimits;

/** {@code steward league add}: adds a bot to a league. */
@Command(name = "add", description = "Adds a bot to a league, also while it is played.",
    footer = {
        "", "A bot is written [NAME=][builtin:|json:|codingame:]COMMAND, as in 'steward",
        "match'. Its folder is stored with it: the one of --in, or the current one. It",
        "is started there, and paths in its command begin there. The printed files",
        "identify its version: when one changes, the bot is another version.",
        "", "Examples:",
        "  steward league add night 'mine=python3 bot.py' builtin:racer builtin:veteran",
        "  steward league add night 'net=python3 net.py' --file net.py --file model.bin",
        "  steward league add night mine=./mine-arm --platform linux-aarch64 --same"})
final class AddCommand extends ProgramCommand {

    /** Files that are named at most. */
    private static final int SHOWN = 8;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1..*", arity = "1..*", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "A bot; see below.")
    private List<String> bots;

    @Mixin
    private final BotFolders folders = new BotFolders();

    @Option(names = "--file", paramLabel = "FILE", description = "A file that belongs to the bot: when it "
        + "changes, the bot is a new version. Can be repeated (default: every word of the command that is a file).")
    private List<String> files;

    @Option(names = "--check", description = "Checks the bot first, as 'steward check' does, and adds it only if "
        + "nothing is wrong.")
    private boolean tried;

    @Option(names = "--time-limit", paramLabel = OwnLimits.FORM, description = "Gives the bot its own limits in "
        + "milliseconds: MS for each answer, FIRST for the first one (default: the scene's, but at least MS).")
    private String limit;

    @Option(names = "--random", description = "Says that the bot uses random numbers: its games cannot be "
        + "repeated exactly.")
    private boolean random;

    @Option(names = "--platform", paramLabel = "PLATFORM", description = "Adds a command for one platform, such as "
        + "linux-aarch64, as a version of its own, called NAME@PLATFORM.")
    private String platform;

    @Option(names = "--same", description = "With --platform: adds the command to the existing bot of this name, "
        + "as the same version.")
    private boolean same;

    @Override
    public Integer call() throws InterruptedException {
        check.that(!same || platform != null, "--same is for --platform, expected both");
        check.that(platform == null || Platform.isWritten(platform), "--platform: found '" + platform
            + "', expected " + Platform.FORM);
        check.that(!tried || platform == null || platform.equals(Platform.here()), "--check: found a command for "
            + platform + ", expected one for this machine, which is " + Platform.here());
        check.that(!same || limit == null, "--time-limit: expected none with --same: it is that of the version");
        check.that(!same || !random, "--random: expected none with --same: the bot draws by lot or not");
        OwnLimits limits = limit == null ? null
            : InputException.of("--time-limit: ", () -> OwnLimits.parse(limit));
        LeagueFolder folder = league.openToWrite(streams);
        if (files != null && bots.size() > 1) {
            throw new InputException("--file: found " + bots.size() + " bots with it, expected one");
        }
        for (String bot : bots) {
            int status = add(folder, bot, limits);
            if (status != ExitStatus.DONE) {
                return status;
            }
        }
        return ExitStatus.DONE;
    }

    private int add(LeagueFolder folder, String bot, OwnLimits limits) throws InterruptedException {
        LeagueSettings settings = folder.read();
        LeagueBot added = parsed(bot).within(limits);
        boolean another = !same && settings.bot(added.name()).isPresent();
        if (another) {
            throw new InputException("found a bot '" + added.name() + "' in the league, expected another name"
                + (settings.bot(added.name()).get().retired() ? "; 'steward league retire --back' lets it play again"
                : ""));
        }
        Contest.Entrant entrant = added.entrant();
        boolean programElsewhere = platform != null && !platform.equals(Platform.here())
            && added.parsed().prefix() != BotCommand.Prefix.BUILTIN;
        if (entrant.problem() != null && !programElsewhere) {
            throw new InputException(entrant.problem());
        }
        Contest.checkPlayable(LeagueOpening.setup(folder, settings), List.of(entrant));
        LeagueBot other = same ? other(settings, added) : null;
        if (other == null) {
            refuseTwins(settings, added);
        }
        int status = tried ? CheckCommand.run(streams, LeagueOpening.contest(folder, settings, streams), entrant)
            : ExitStatus.DONE;
        if (status != ExitStatus.DONE) {
            streams.err().println("steward: " + added.name() + " is not added");
            return status;
        }
        folder.write(other == null ? settings.with(added) : settings.replaced(other.name(),
            other.with(new LeagueBot.ForPlatform(platform, added.command(), added.folder(), added.files()))));
        streams.out().println(added.name() + " plays " + (same ? "on " + platform + " " : "") + "from now on: "
            + added.command() + (limits == null ? "" : ", " + limits));
        if (added.folder() != null) {
            tellFiles(added);
        }
        return ExitStatus.DONE;
    }

    /** Says which files make it this bot. */
    private void tellFiles(LeagueBot added) {
        List<Path> watched = added.program().files();
        if (watched.isEmpty()) {
            streams.warn("no file of " + added.name() + " is watched, so that it stays the same version whatever "
                + "changes: add it with --file for each file that makes it this bot");
            return;
        }
        streams.out().println("Another version when one of these changes in " + added.folder() + ": "
            + String.join(", ", watched.stream().limit(SHOWN).map(Path::toString).toList())
            + (watched.size() > SHOWN ? " and " + (watched.size() - SHOWN) + " more" : ""));
    }

    /** The bot to which a command for one platform more is added. */
    private LeagueBot other(LeagueSettings settings, LeagueBot added) {
        LeagueBot bot = LeagueOpening.bot(settings, added.name());
        if (bot.platforms().stream().anyMatch(each -> each.platform().equals(platform))) {
            throw new InputException("bot '" + bot.name() + "': found a command for " + platform + " already, expected "
                + "another platform; its commands stand in " + LeagueFolder.SETTINGS);
        }
        return bot;
    }

    private LeagueBot parsed(String bot) {
        BotCommand command = InputException.of(() -> BotCommand.parse(bot));
        String name = command.displayName(folders.folder());
        if (!LeagueReader.NAME.matcher(name).matches()) {
            throw new InputException("bot '" + bot + "': found the name '" + name + "', expected "
                + LeagueReader.NAME_FORM + "; write NAME=" + bot);
        }
        LeagueBot added = new LeagueBot(platform == null || same ? name : name + LeagueBot.AT + platform,
            new BotCommand(null, command.prefix(), command.words()).toString(), files, random, false);
        return command.prefix() == BotCommand.Prefix.BUILTIN ? added
            : added.in(none -> folders.folder().toAbsolutePath().toString());
    }

    private static void refuseTwins(LeagueSettings settings, LeagueBot added) {
        BotIdentity identity = new BotIdentity(LeagueOpening.environment(settings));
        String hash = identity.of(added);
        List<String> twins = new ArrayList<>();
        for (LeagueBot other : settings.active()) {
            try {
                if (identity.of(other).equals(hash)) {
                    twins.add(other.name());
                }
            } catch (InputException gone) {
                continue;                              // a bot without its files is another one in any case
            }
        }
        if (!twins.isEmpty()) {
            throw new InputException("bot '" + added.name() + "': found the program of '" + twins.get(0)
                + "', expected another command or other files");
        }
    }
}

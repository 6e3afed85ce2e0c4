package steward.league;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import steward.bot.command.BotCommand;
import steward.bot.command.Program;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.match.OwnLimits;
import steward.match.Protocol;

/**
 * A bot as league.json describes it: name, command and options.
 *
 * @param name      unlike the others' names; {@code NAME@PLATFORM} plays on that platform only
 * @param command   {@code [builtin:|json:|codingame:]COMMAND}
 * @param folder    in which it is started and where its words are found, absolute; {@code null} for the one from which
 *                  the league is run
 * @param files     what its identity is made of besides the command; {@code null} for every argument that is a file
 * @param random    whether it draws by lot: its games cannot be played again to the bit
 * @param retired   whether it plays no more; its games stay
 * @param resumed   the decision from which on failures in a row pause it; 0 for all
 * @param platforms its commands for some platforms, where it is the same version all the same
 * @param limits    its own time limits, or {@code null} for the scene's
 */
public record LeagueBot(String name, String command, String folder, List<String> files, boolean random,
                        boolean retired, int resumed, List<ForPlatform> platforms, OwnLimits limits) {

    /** Sign between a bot's name and the platform that it plays on. */
    public static final char AT = '@';

    /**
     * Command of a bot on one platform.
     *
     * @param platform see {@link steward.bot.command.Platform}
     * @param folder   as that of a bot
     * @param files    as those of a bot
     */
    public record ForPlatform(String platform, String command, String folder, List<String> files) {

        public ForPlatform {
            files = files == null ? null : List.copyOf(files);
        }
    }

    public LeagueBot {
        files = files == null ? null : List.copyOf(files);
        platforms = List.copyOf(platforms);
    }

    /** One whose failures all matter, with one command, in the folder from which the league is run. */
    public LeagueBot(String name, String command, List<String> files, boolean random, boolean retired) {
        this(name, command, null, files, random, retired, 0, List.of(), null);
    }

    /** Returns this bot with time limits of its own, or the scene's for {@code null}. */
    public LeagueBot within(OwnLimits other) {
        return new LeagueBot(name, command, folder, files, random, retired, resumed, platforms, other);
    }

    /** Returns this bot with folders of its own, here and on other platforms. */
    public LeagueBot in(UnaryOperator<String> folders) {
        return new LeagueBot(name, command, folders.apply(folder), files, random, retired, resumed, platforms.stream()
            .map(each -> new ForPlatform(each.platform(), each.command(), folders.apply(each.folder()), each.files()))
            .toList(), limits);
    }

    /** Returns the only platform that it plays on, or {@code null}. */
    public String platform() {
        return platform(name);
    }

    /** Returns the platform in a name, or {@code null}. */
    public static String platform(String name) {
        int at = name.indexOf(AT);
        return at < 0 ? null : name.substring(at + 1);
    }

    /** True if it has nothing to do with other platforms than this. */
    public boolean playsOn(String here) {
        return platform() == null || platform().equals(here);
    }

    /** Returns this bot with the command and the files of a platform, if there are any for it. */
    public LeagueBot on(String here) {
        return platforms.stream().filter(each -> each.platform().equals(here)).findFirst().map(each ->
            new LeagueBot(name, each.command(), each.folder(), each.files(), random, retired, resumed, List.of(),
                limits))
            .orElse(this);
    }

    public LeagueBot with(ForPlatform more) {
        return new LeagueBot(name, command, folder, files, random, retired, resumed,
            Stream.concat(platforms.stream(), Stream.of(more)).toList(), limits);
    }

    /** Returns this bot; its failures before a decision do not matter. */
    public LeagueBot resumed(int decision) {
        return new LeagueBot(name, command, folder, files, random, retired, decision, platforms, limits);
    }

    /** Returns the bot as it would be typed in a call, where no name has a platform. */
    public String typed() {
        return name.replace(AT, '.') + "=" + command;
    }

    /** @throws IllegalArgumentException if it has no command, or that cannot be split into words */
    public BotCommand parsed() {
        return BotCommand.parse(typed());
    }

    /**
     * Returns its program, with the words of its command.
     *
     * @throws IllegalArgumentException as {@link #parsed} does
     */
    public Program program() {
        return new Program(parsed().words(), path(), files);
    }

    private Path path() {
        return Path.of(folder == null ? "" : folder);
    }

    /** Returns the bot as it is started; one that cannot be has the problem. */
    public Entrant entrant() {
        return started().within(limits);
    }

    private Entrant started() {
        if (folder != null && !Files.isDirectory(path())) {
            Protocol spoken = parsed().prefix() == BotCommand.Prefix.CODINGAME ? Protocol.CODINGAME : Protocol.JSON;
            return new Entrant(name, typed(), spoken, Program.here(List.of()), "bot '" + name + "': found no folder "
                + folder + ", in which it was added, expected it; put it back, or add the bot anew");
        }
        return Contest.entrant(typed(), path(), files, Protocol.JSON);
    }

    /** Returns this bot under another name. */
    public LeagueBot named(String other) {
        return new LeagueBot(other, command, folder, files, random, retired, resumed, platforms, limits);
    }

    /** Returns this bot, to play no more or again. */
    public LeagueBot retired(boolean now) {
        return new LeagueBot(name, command, folder, files, random, now, resumed, platforms, limits);
    }
}

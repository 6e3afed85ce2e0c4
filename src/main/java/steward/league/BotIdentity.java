package steward.league;

import java.io.IOException;
import java.io.InputStream;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import steward.bot.command.BotCommand;
import steward.bot.command.BuiltinBots;
import steward.bot.command.Program;
import steward.contest.Contest;
import steward.files.InputException;

/**
 * Tells which program a bot is: a hash of its argument list, of its own time limits, of the environment that it is
 * passed, and of its files. A file is read again only when its size, time or place on the disk has changed. Not
 * thread-safe.
 */
public final class BotIdentity {

    private final Map<String, String> environment;
    private final Map<Path, Content> known = new HashMap<>();

    /**
     * A file as it was read.
     *
     * @param stamp size, time and place
     * @param hash  of its bytes
     */
    private record Content(String stamp, String hash) { }

    /** @param environment the variables that bots are passed by name, and their values */
    public BotIdentity(Map<String, String> environment) {
        this.environment = new TreeMap<>(environment);
    }

    /**
     * The identity of a bot as it is now. Its commands for other platforms do not count: they are the same version.
     *
     * @return 32 hexadecimal digits
     * @throws InputException if one of its files cannot be read
     */
    public String of(LeagueBot bot) {
        BotCommand command = bot.parsed();
        TextHash hash = new TextHash().add(command.prefix().name()).addAll(command.words());
        if (bot.platform() != null) {
            hash.add(LeagueBot.AT + bot.platform());
        }
        if (bot.limits() != null) {
            hash.add("time limit " + bot.limits().written());
        }
        environment.forEach((name, value) -> hash.add(name).add(value));
        for (Path file : files(bot)) {
            hash.add(file.toString()).add(content(bot, bot.program().folder().resolve(file)));
        }
        return hash.hex();
    }

    /** The identity of a contest's bot as a program, whatever its limits and its environment are. */
    public static String ofProgram(Contest.Entrant entrant) {
        String command = BotCommand.parse(entrant.bot()).name() == null ? entrant.bot()
            : entrant.bot().substring(entrant.bot().indexOf('=') + 1);
        return new BotIdentity(Map.of()).of(new LeagueBot("bot", command, null, false, false)
            .in(none -> entrant.program().folder().toString()));
    }

    /** Returns a stamp of the bot: it changes when a file of any platform has been touched. No file is read. */
    public String stamp(LeagueBot bot) {
        StringBuilder stamps = new StringBuilder(programStamp(bot));
        bot.platforms().forEach(each -> stamps.append('\n').append(each.platform()).append('\n')
            .append(programStamp(bot.on(each.platform()))));
        return stamps.toString();
    }

    private static String programStamp(LeagueBot bot) {
        StringBuilder stamps = new StringBuilder(bot.typed());
        BotCommand command = bot.parsed();
        if (bot.files() == null && command.prefix() == BotCommand.Prefix.BUILTIN) {
            return bot.typed();                        // does not change while the program runs
        }
        return stamps.append('\n').append(bot.program().stamp()).toString();
    }

    /** Its files, see {@link Program#files}; of a builtin bot the program's own. */
    private static List<Path> files(LeagueBot bot) {
        boolean builtin = bot.files() == null && bot.parsed().prefix() == BotCommand.Prefix.BUILTIN;
        return builtin ? bundled() : bot.program().files();
    }

    /** Returns where the bundled bots are: an archive, or their classes. */
    private static List<Path> bundled() {
        URL list = BuiltinBots.class.getClassLoader().getResource(BuiltinBots.RESOURCE);
        if (list == null) {
            return List.of();
        }
        try {
            if (list.getProtocol().equals("jar")) {
                String address = list.getPath();
                return List.of(Path.of(new URL(address.substring(0, address.indexOf("!/"))).toURI()));
            }
            Path folder = Path.of(list.toURI()).getParent();
            try (Stream<Path> classes = Files.walk(folder)) {
                return classes.filter(Files::isRegularFile).sorted().toList();
            }
        } catch (IOException | URISyntaxException problem) {
            throw new InputException("the bundled bots cannot be read: " + problem.getMessage());
        }
    }

    private String content(LeagueBot bot, Path file) {
        String stamp = Program.stamp(file);
        Content content = known.get(file);
        if (content == null || !content.stamp().equals(stamp)) {
            try (InputStream in = Files.newInputStream(file)) {
                content = new Content(stamp, TextHash.of(in));
            } catch (IOException problem) {
                throw new InputException("bot '" + bot.name() + "': its file " + file + " cannot be read: "
                    + (Files.exists(file) ? problem.getMessage() : "there is no such file"));
            }
            known.put(file, content);
        }
        return content.hash();
    }
}

package steward.league;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import steward.bot.command.BotCommand;
import steward.bot.command.BuiltinBots;
import steward.bot.command.Program;
import steward.contest.Contest;
import steward.files.InputException;
import steward.files.Sha256;

/**
 * Identity of a bot's program: a hash. The hash covers the argument list, the bot's own time limits, the environment
 * passed to it, and its files. A file is read again only if its size, time or place on the disk has changed. Not
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

    /**
     * The identity of a contest's bot as a program, however its command is written and whatever its limits and its
     * environment are: the contents of the files that its words name, or else of those that are listed, and its other
     * words. The program of the system that runs a file, such as {@code python3}, does not count beside it; a folder
     * counts by its place.
     */
    public static String ofProgram(Contest.Entrant entrant) {
        BotCommand command = BotCommand.parse(entrant.bot());
        if (command.prefix() == BotCommand.Prefix.BUILTIN) {
            String words = command.name() == null ? entrant.bot()
                : entrant.bot().substring(entrant.bot().indexOf('=') + 1);
            return new BotIdentity(Map.of()).of(new LeagueBot("bot", words, null, false, false));
        }
        Program program = entrant.program();
        TextHash hash = new TextHash();
        Set<Path> files = new LinkedHashSet<>();
        new Program(program.words(), program.folder(), null).paths().forEach(file -> files.add(real(file)));
        Path first = program.words().isEmpty() ? null : file(program, program.words().get(0));
        boolean isOfSystem = first == null || !Files.isRegularFile(first) || isOfSystem(first);
        if (isOfSystem && first != null) {
            files.remove(real(first));
        }
        if (files.isEmpty() && program.named() != null) {
            program.paths().forEach(file -> files.add(real(file)));
        }
        for (int k = isOfSystem && !files.isEmpty() ? 1 : 0; k < program.words().size(); k++) {
            String word = program.words().get(k);
            Path file = file(program, word);
            if (k == 0 && isOfSystem) {
                hash.add(word.substring(word.lastIndexOf('/') + 1));
            } else if (file == null || !Files.exists(file)) {
                hash.add(word);
            } else if (Files.isDirectory(file)) {
                hash.add(real(file).toString());
            }
        }
        files.stream().filter(Files::isRegularFile).map(file -> hash(entrant.name(), file)).forEach(hash::add);
        return hash.hex();
    }

    private static Path file(Program program, String word) {
        try {
            return word.isEmpty() ? null : program.folder().resolve(word).normalize();
        } catch (InvalidPathException none) {
            return null;
        }
    }

    /** The file without links; as it is named where it is gone. */
    private static Path real(Path file) {
        try {
            return file.toRealPath();
        } catch (IOException gone) {
            return file;
        }
    }

    /** True of a program in a folder where commands are looked for. */
    private static boolean isOfSystem(Path file) {
        String folders = System.getenv("PATH");
        return folders != null && Arrays.stream(folders.split(File.pathSeparator)).anyMatch(folder ->
            !folder.isEmpty() && Path.of(folder).normalize().equals(file.getParent()));
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
            content = new Content(stamp, hash(bot.name(), file));
            known.put(file, content);
        }
        return content.hash();
    }

    private static String hash(String bot, Path file) {
        try {
            return Sha256.hex(file);
        } catch (IOException problem) {
            throw new InputException("bot '" + bot + "': its file " + file + " cannot be read: "
                + (Files.exists(file) ? problem.getMessage() : "there is no such file"));
        }
    }
}

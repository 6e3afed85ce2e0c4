package steward.machines.bundle;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import steward.bot.command.BotCommand;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.files.Sha256;
import steward.league.LeagueBot;
import steward.machines.wire.HeaderText;
import steward.match.GuestSetup;

/**
 * Packed files of a bot: a ZIP archive for transfer to another machine. Its first entry, {@value #LIST}, has the
 * command and tells which of its words are files; a bot with commands for several platforms has all of them there. A
 * symbolic link is packed as the file that it leads to.
 *
 * @param hash  SHA-256 of the bytes, 64 hexadecimal digits
 * @param bytes the archive; not copied
 */
public record Bundle(String hash, byte[] bytes) {

    /** How large a bundle may be, packed, in bytes. */
    public static final int LARGEST = 64 << 20;
    /** How many files it may have. */
    static final int MOST_FILES = 900;
    static final String LIST = "bundle.json";
    /** Where files are in it that are in the folder of the call; and all others. */
    static final String HERE = "here/";
    private static final String ABSOLUTE = "elsewhere/";
    /** Where files of a platform are whose command has a folder of its own; the platform follows. */
    private static final String ON = "on/";

    /**
     * A file of a bundle.
     *
     * @param place    in it
     * @param typed    as a word of the command
     * @param platform whose command alone has it, or {@code null}
     */
    private record Packed(String place, Path typed, Path file, String platform) { }

    /**
     * Packs a bot.
     *
     * @throws InputException if its files cannot be read, or are too many or too large
     */
    public static Bundle of(LeagueBot bot) {
        return of(bot, "bot '" + bot.name() + "'", "pack them into an archive that it reads",
            "put large files on the workers' machines, and list in \"files\" only the others");
    }

    private static Bundle of(LeagueBot bot, String who, String ifMany, String ifLarge) {
        Map<String, Packed> packed = new LinkedHashMap<>();
        add(bot, HERE, null, packed);
        bot.platforms().forEach(each -> add(bot.on(each.platform()), folder(bot, each), isApart(bot, each)
            ? each.platform() : null, packed));
        Collection<Packed> files = packed.values();
        if (files.size() > MOST_FILES) {
            throw new InputException(who + ": found " + files.size() + " files, expected at most " + MOST_FILES
                + " for workers; " + ifMany);
        }
        HeaderText list = new HeaderText().put("command", written(bot));
        list.put("platform", bot.platform());
        if (!bot.platforms().isEmpty()) {
            list.put("platforms", bot.platforms().stream().map(each -> new HeaderText().put("platform", each.platform())
                .put("command", written(bot.on(each.platform()))).put("folder", folder(bot, each))).toList());
        }
        list.put("files", files.stream().map(each -> {
            HeaderText text = new HeaderText().put("typed", each.typed().toString()).put("place", each.place())
                .put("executable", Files.isExecutable(each.file()));
            return each.platform() == null ? text : text.put("platform", each.platform());
        }).toList());
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            entry(zip, LIST, list.text().getBytes(StandardCharsets.UTF_8));
            for (Packed each : files.stream().filter(each -> !Files.isDirectory(each.file())).toList()) {
                Path file = each.file();
                if (Files.size(file) + bytes.size() > LARGEST) {
                    throw new InputException(who + ": found " + (Files.size(file) + bytes.size()) + " bytes of files "
                        + "up to " + file + ", expected at most " + LARGEST + " (" + (LARGEST >> 20)
                        + " MiB) for workers; " + ifLarge);
                }
                entry(zip, each.place(), Files.readAllBytes(file));
            }
        } catch (IOException problem) {
            throw new InputException(who + ": its files cannot be packed for workers: "
                + OutputFiles.reason(files.iterator().next().file(), problem));
        }
        return new Bundle(Sha256.hex(bytes.toByteArray()), bytes.toByteArray());
    }

    /** Packs a guest's referee as a bot: all files of its class path, or those that its command names. */
    public static Bundle of(GuestSetup setup) {
        List<String> files = new ArrayList<>();
        for (String entry : setup.isOnClassPath() ? setup.words() : List.<String>of()) {
            try (Stream<Path> all = Files.walk(Path.of(entry), FileVisitOption.FOLLOW_LINKS)) {
                // A folder is listed too: the class path names it.
                all.filter(file -> Files.isRegularFile(file) || file.toString().equals(entry)).sorted()
                    .forEach(file -> files.add(file.toString()));
            } catch (IOException | UncheckedIOException problem) {
                throw new InputException("referee.classPath: cannot be read: " + problem.getMessage());
            }
        }
        return of(new LeagueBot("referee", new BotCommand(null, BotCommand.Prefix.CODINGAME, setup.words()).toString(),
            files.isEmpty() ? null : files, false, false), "the scene's referee",
            "pack its classes into a jar", "take what only people see from its class path");
    }

    private static boolean isApart(LeagueBot bot, LeagueBot.ForPlatform each) {
        return !Objects.equals(bot.folder(), each.folder());
    }

    private static String folder(LeagueBot bot, LeagueBot.ForPlatform each) {
        return isApart(bot, each) ? ON + each.platform() + "/" : HERE;
    }

    private static void add(LeagueBot bot, String here, String platform, Map<String, Packed> packed) {
        for (Path typed : files(bot)) {
            Path file = bot.program().folder().resolve(typed);
            String place = place(typed, file, here);
            packed.putIfAbsent(place, new Packed(place, typed, file, platform));
        }
    }

    private static List<Path> files(LeagueBot bot) {
        BotCommand command = bot.parsed();
        boolean builtin = bot.files() == null && command.prefix() == BotCommand.Prefix.BUILTIN;
        return builtin ? List.of() : bot.program().files();
    }

    /** The command word by word, since a class path is longer than a text may be; the prefix is part of the first. */
    private static List<String> written(LeagueBot bot) {
        BotCommand command = bot.parsed();
        List<String> words = new ArrayList<>(command.words());
        words.set(0, command.prefix().written() + words.get(0));
        return words;
    }

    private static void entry(ZipOutputStream zip, String name, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTime(0);
        zip.putNextEntry(entry);
        zip.write(bytes);
        zip.closeEntry();
    }

    /** Returns where a file is in the bundle. */
    private static String place(Path typed, Path file, String folder) {
        Path plain = typed.normalize();
        boolean here = !plain.isAbsolute() && !plain.startsWith("..") && !plain.toString().isEmpty();
        StringBuilder place = new StringBuilder(here ? folder : ABSOLUTE);
        for (Path part : here ? plain : file.normalize()) {
            place.append(place.charAt(place.length() - 1) == '/' ? "" : "/").append(part);
        }
        return place.toString();
    }
}

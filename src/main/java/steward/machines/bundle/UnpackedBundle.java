package steward.machines.bundle;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import steward.bot.command.BotCommand;
import steward.bot.command.Program;
import steward.files.Folders;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.files.Sha256;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/**
 * Bundle unpacked on this machine, in a folder named by its hash, and the command whose words name the files there.
 *
 * @param root    that holds all of it
 * @param folder  in which the bot is started
 * @param command as it is to be started here
 * @param files   that make it this bot
 */
public record UnpackedBundle(Path root, Path folder, BotCommand command, List<String> files) {

    /** Bytes that a bundle may have at most when it is unpacked. */
    static final long LARGEST_UNPACKED = 1L << 30;

    /**
     * Unpacks a bundle, unless it is there. It appears as a whole or not at all. Nothing is written outside its folder.
     *
     * @param hash that its bytes have to have
     * @param here the platform that its command is to be for
     * @throws InputException if it is not what it should be, or the disk is full
     */
    public static UnpackedBundle of(Path parent, String hash, byte[] bytes, String here) {
        if (!Sha256.hex(bytes).equals(hash)) {
            throw new InputException("bundle " + hash + ": found other bytes, expected those of that hash");
        }
        Path folder = parent.resolve(hash);
        try {
            Map<String, byte[]> files = files(hash, bytes);
            Block list = list(hash, files.remove(Bundle.LIST));
            Started started = started(list, here);
            if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
                Files.createDirectories(parent);
                Path part = Files.createTempDirectory(parent, "unpacking");
                try {
                    write(part, files, list);
                    Files.move(part, folder, StandardCopyOption.ATOMIC_MOVE);
                } finally {
                    Folders.delete(part);
                }
            }
            return of(folder, list, started, here);
        } catch (IOException problem) {
            throw new InputException(folder + ": the bundle cannot be unpacked: "
                + OutputFiles.reason(folder, problem));
        } catch (SceneException problem) {
            throw new InputException(problem.getMessage());
        }
    }

    /** The entries of an archive, their names checked. */
    private static Map<String, byte[]> files(String hash, byte[] bytes) throws IOException {
        Map<String, byte[]> files = new HashMap<>();
        long size = 0;
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(bytes))) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                String name = entry.getName();
                if (!isPlain(name) || entry.isDirectory()) {
                    throw new InputException("bundle " + hash + ": found the file name '" + name + "', expected one "
                        + "within the bundle");
                }
                byte[] content = zip.readNBytes((int) Math.min(Integer.MAX_VALUE - 8, LARGEST_UNPACKED - size + 1));
                size += content.length;
                if (size > LARGEST_UNPACKED || files.size() > Bundle.MOST_FILES || files.put(name, content) != null) {
                    throw new InputException("bundle " + hash + ": found more than " + (LARGEST_UNPACKED >> 20)
                        + " MiB, more than " + Bundle.MOST_FILES + " files, or a file twice, expected less");
                }
            }
        } catch (IllegalArgumentException damaged) {
            throw new IOException(damaged.getMessage(), damaged);
        }
        return files;
    }

    /** True if a name leads nowhere else: words apart by slashes, none of them empty or only dots. */
    static boolean isPlain(String name) {
        if (name.isEmpty() || name.length() > 1000 || name.indexOf('\\') >= 0 || name.indexOf(':') >= 0
            || name.chars().anyMatch(c -> c < ' ' || c == 0x7F)) {
            return false;
        }
        return Stream.of(name.split("/", -1)).noneMatch(word -> word.isEmpty() || word.chars().allMatch(c -> c == '.'));
    }

    private static Block list(String hash, byte[] list) {
        String source = "bundle " + hash + ": " + Bundle.LIST;
        if (list == null) {
            throw new InputException(source + ": found no such file, expected the list of the others");
        }
        return new Block(source, "", JsonTree.read(new String(list, StandardCharsets.UTF_8), source, "a bundle"));
    }

    /** Words of a command, and where in the bundle its folder is. */
    private record Started(List<String> command, String folder) { }

    /** The command for a platform: its own, or that for all others. */
    private static Started started(Block list, String here) {
        if (list.has("platform") && !list.text("platform").equals(here)) {
            throw new InputException("found a bot for " + list.text("platform") + ", and this machine is " + here);
        }
        Started started = new Started(list.texts("command"), Bundle.HERE);
        for (Block each : list.has("platforms") ? list.blocks("platforms") : List.<Block>of()) {
            Started other = new Started(each.texts("command"), each.text("folder"));
            started = each.text("platform").equals(here) ? other : started;
        }
        return started;
    }

    private static void write(Path folder, Map<String, byte[]> files, Block list) throws IOException {
        Files.createDirectories(folder.resolve(Bundle.HERE));
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = inside(folder, file.getKey());
            Files.createDirectories(path.getParent());
            try (OutputStream out = Files.newOutputStream(path)) {
                out.write(file.getValue());
            }
        }
        for (Block file : list.blocks("files")) {
            if (file.flag("executable", false) && files.containsKey(file.text("place"))) {
                inside(folder, file.text("place")).toFile().setExecutable(true, true);
            }
        }
    }

    private static Path inside(Path folder, String name) throws IOException {
        try {
            Path path = folder.resolve(name).normalize();
            if (isPlain(name) && path.startsWith(folder)) {
                return path;
            }
        } catch (InvalidPathException problem) {
            throw new IOException(problem.getMessage(), problem);
        }
        throw new IOException("'" + name + "' is not within the bundle");
    }

    private static UnpackedBundle of(Path folder, Block list, Started started, String here) throws IOException {
        Map<String, String> places = new LinkedHashMap<>();
        for (Block file : list.blocks("files")) {
            if (!file.has("platform") || file.text("platform").equals(here)) {
                places.put(file.text("typed"), inside(folder, file.text("place")).toAbsolutePath().toString());
            }
            file.flag("executable", false);
        }
        BotCommand typed;
        try {
            typed = BotCommand.of(started.command(), BotCommand.Prefix.JSON);
        } catch (IllegalArgumentException problem) {
            throw list.error("command", problem.getMessage(), "a program and its arguments");
        }
        list.done();
        Path own = Files.createDirectories(inside(folder, started.folder().replaceFirst("/$", "")));
        return new UnpackedBundle(folder, own, new BotCommand(typed.name(), typed.prefix(),
            typed.words().stream().map(word -> places.getOrDefault(word, word)).toList()),
            List.copyOf(places.values()));
    }

    /**
     * Returns the program.
     *
     * @throws InputException if it cannot be started here
     */
    public Program program() {
        return InputException.of(() -> new Program(command.resolve(folder), folder, files));
    }
}

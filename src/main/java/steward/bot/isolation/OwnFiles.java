package steward.bot.isolation;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;
import steward.files.UserFolders;

/**
 * Files that belong to a bot, found from its command. They are the folder of its program or its interpreter's whole
 * installation; folders and files that its arguments name, class paths included; the interpreter in a script's first
 * line; and the targets of symbolic links on the way.
 *
 * <p>If a folder is the home directory, contains it, or is a league's, only the file itself belongs to the bot.
 */
final class OwnFiles {

    /** Programs of an installation are in such a folder, and need what is beside it. */
    private static final Set<String> PROGRAM_FOLDERS = Set.of("bin", "sbin", "shims", "libexec");

    /** Installations in the home directory that also hold what is nobody else's business. */
    private static final Set<String> MIXED = Set.of(".local", ".cargo", ".config", ".cache");

    private static final int MOST_LINKS = 20;
    /** As much of a file as is read for its first lines, in bytes. */
    private static final int BEGINNING = 1024;

    /** Programs in its folder are the machine's, and not the whole of it is an installation. */
    private static final Path LOCAL = Path.of("/usr/local");
    private static final Pattern HOME = Pattern.compile("home\\s*=\\s*(/.*\\S)\\s*");
    /** The file that makes a folder that of a league, which holds games, keys and other bots. */
    private static final String LEAGUE = "league.json";

    private final Set<Path> found = new LinkedHashSet<>();

    private OwnFiles() { }

    /** Files and folders, absolute; also such as need not be hidden anywhere. */
    static Set<Path> of(Program bot) {
        OwnFiles own = new OwnFiles();
        own.program(ProgramFinder.find(bot.words().get(0), bot.folder()), true);
        Set<Path> files = named(bot.words().subList(1, bot.words().size()), bot.folder());
        bot.paths().stream().filter(Files::exists).forEach(files::add);
        for (Path file : files) {
            if (Files.isDirectory(file)) {
                own.folder(file);
            } else {
                own.program(file, false);
            }
        }
        return own.found;
    }

    /**
     * Files and folders that somebody brought: of arguments, and of the program unless it is in a folder of programs,
     * as an interpreter is.
     */
    static Set<Path> brought(Program bot) {
        Path program = ProgramFinder.find(bot.words().get(0), bot.folder());
        boolean installed = program == null || program.getParent() == null || program.getParent().getFileName() == null
            || PROGRAM_FOLDERS.contains(program.getParent().getFileName().toString());
        Set<Path> files = named(installed ? bot.words().subList(1, bot.words().size()) : bot.words(), bot.folder());
        bot.paths().stream().filter(Files::exists)
            .filter(file -> !installed || !file.equals(program)).forEach(files::add);
        return files;
    }

    /** The files and folders that words name, also several in one word with colons between. */
    static Set<Path> named(List<String> words, Path folder) {
        Set<Path> files = new LinkedHashSet<>();
        for (String word : words) {
            for (String piece : word.split("[:=]")) {
                try {
                    Path file = folder.resolve(piece).normalize();
                    if (!piece.isBlank() && Files.exists(file)) {
                        files.add(file);
                    }
                } catch (InvalidPathException noFile) {
                    continue;
                }
            }
        }
        return files;
    }

    static Path home() {
        return UserFolders.home().toAbsolutePath().normalize();
    }

    /** A program or script with its folder, the links to it, and its interpreter. */
    private void program(Path start, boolean interpreter) {
        Path file = start == null ? null : start.toAbsolutePath().normalize();
        for (int links = 0; file != null && links < MOST_LINKS; links++) {
            add(file);
            try {
                Path next = Files.isSymbolicLink(file) ? file.resolveSibling(Files.readSymbolicLink(file)).normalize()
                    : file.toRealPath();
                if (next.equals(file)) {
                    break;
                }
                file = next;
            } catch (IOException gone) {
                return;
            }
        }
        if (file != null && interpreter) {
            interpreter(file);
        }
    }

    /** {@code #!/usr/bin/env python3} finds {@code python3} along the path. */
    private void interpreter(Path script) {
        String[] words = firstLine(script).split("\\s+");
        if (words.length > 0 && words[0].startsWith("/")) {
            program(Path.of(words[0]), false);
        }
        for (int k = 1; k < words.length && words[0].endsWith("/env"); k++) {
            if (!words[k].startsWith("-") && words[k].indexOf('=') < 0) {
                program(ProgramFinder.find(words[k]), false);
                break;
            }
        }
    }

    private static String firstLine(Path script) {
        String text = beginning(script);
        return text.startsWith("#!") ? text.substring(2).lines().findFirst().orElse("").strip() : "";
    }

    private static String beginning(Path text) {
        try (InputStream file = Files.newInputStream(text)) {
            return new String(file.readNBytes(BEGINNING), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            return "";
        }
    }

    /** A file with its folder, or with the installation that it is a program of. */
    private void add(Path file) {
        Path folder = file.getParent();
        if (folder == null || isWide(folder)) {
            found.add(file);
            return;
        }
        Path above = folder.getParent();
        boolean installed = PROGRAM_FOLDERS.contains(folder.getFileName().toString());
        if (!installed) {
            found.add(folder);
        } else if (above == null || isWide(above) || above.equals(LOCAL)
            || MIXED.contains(above.getFileName().toString())) {
            found.add(file);
        } else if (found.add(above)) {
            baseOf(above, file);
        }
    }

    /** A virtual environment of Python whose interpreter is a copy: its file names the folder of the original. */
    private void baseOf(Path environment, Path program) {
        Path settings = environment.resolve("pyvenv.cfg");
        if (Files.isRegularFile(settings)) {
            for (String line : beginning(settings).split("\n")) {
                Matcher home = HOME.matcher(line);
                if (home.matches()) {
                    add(Path.of(home.group(1)).resolve(program.getFileName()));
                }
            }
        }
    }

    private void folder(Path folder) {
        if (!isWide(folder)) {
            found.add(folder);
        }
    }

    /** True if a folder is the home directory or holds it, or others' folders, or is a league's. */
    private static boolean isWide(Path folder) {
        return home().startsWith(folder) || folder.getNameCount() < 2 || Files.exists(folder.resolve(LEAGUE))
            || folder.equals(Path.of(System.getProperty("java.io.tmpdir")));
    }
}

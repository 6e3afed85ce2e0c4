package steward.bot.isolation;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;

/**
 * Guess of the files that a program lacked at {@link SandboxLevel#STRICT}, from its command and stderr: paths, missing
 * programs, modules of Python and Node.
 */
public final class MissingFiles {

    private static final int MOST = 3;
    private static final Pattern PATH = Pattern.compile("/[^\\s'\"`:;,()<>\\[\\]{}]+");
    private static final Pattern PROGRAM = Pattern.compile(
        "([\\w.+-]+)['\"’]?: (?:(?:command )?not found|No such file or directory)");
    private static final Pattern MODULE = Pattern.compile(
        "(?:No module named|Cannot find (?:module|package)) '([\\w-]+|@[\\w-]+/[\\w-]+)");

    private final Program bot;
    private final StrictView view;
    private final Set<Path> found = new LinkedHashSet<>();

    private MissingFiles(Program bot, StrictView view) {
        this.bot = bot;
        this.view = view;
    }

    /**
     * Guesses.
     *
     * @param stderr the last lines that it wrote there
     * @return at most {@value #MOST} paths, absolute
     */
    public static List<Path> of(Program bot, List<String> stderr, Isolation isolation) {
        MissingFiles missing = new MissingFiles(bot, StrictView.of(bot, List.of(), isolation));
        missing.add(OwnFiles.named(bot.words().subList(1, bot.words().size()), bot.folder()));
        for (String line : stderr) {
            missing.look(line);
        }
        return missing.found.stream().limit(MOST).toList();
    }

    private void look(String line) {
        for (Matcher path = PATH.matcher(line); path.find();) {
            boolean program = ProgramFinder.find(path.group()) != null;
            add(program ? own(path.group()) : OwnFiles.named(List.of(path.group()), bot.folder()));
        }
        for (Matcher program = PROGRAM.matcher(line); program.find();) {
            if (ProgramFinder.find(program.group(1)) != null) {
                add(own(program.group(1)));
            }
        }
        for (Matcher module = MODULE.matcher(line); module.find();) {
            modules(module.group(1));
        }
    }

    private Set<Path> own(String program) {
        return OwnFiles.of(new Program(List.of(program), bot.folder(), null));
    }

    private void modules(String name) {
        try (DirectoryStream<Path> versions = Files.newDirectoryStream(OwnFiles.home().resolve(".local/lib"),
                "python*")) {
            for (Path version : versions) {
                Path packages = version.resolve("site-packages");
                if (Files.exists(packages.resolve(name)) || Files.exists(packages.resolve(name + ".py"))) {
                    add(List.of(packages));
                }
            }
        } catch (IOException none) {
            // Nobody has installed modules for this user alone.
        }
        for (Path file : new ArrayList<>(OwnFiles.named(bot.words(), bot.folder()))) {
            for (Path folder = file.getParent(); folder != null; folder = folder.getParent()) {
                Path modules = folder.resolve("node_modules");
                if (Files.exists(modules.resolve(name))) {
                    add(List.of(modules));
                    break;
                }
            }
        }
    }

    private void add(Collection<Path> paths) {
        for (Path path : paths) {
            try {
                Path real = path.toRealPath();
                boolean around = view.entries().keySet().stream().anyMatch(each -> each.startsWith(real));
                if (!around && !view.shows(real) && !isOwnInside(real)) {
                    found.add(path);
                }
            } catch (IOException gone) {
                continue;
            }
        }
    }

    /** True for paths of which a sandbox has its own. */
    private static boolean isOwnInside(Path path) {
        return path.startsWith("/proc") || path.startsWith("/dev") || path.equals(Path.of(StrictSandbox.TEMPORARY));
    }
}

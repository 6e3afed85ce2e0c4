package steward.bot.command;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Search for programs as the system does it: by path if the name has a slash, otherwise along {@code PATH}. */
public final class ProgramFinder {

    private static final String FALLBACK_PATH = "/usr/bin:/bin";
    private static final Pattern SOURCE = Pattern.compile(".*\\.(c|cc|cpp|cs|go|java|kt|rs|swift)");

    /** Programs that run a file which is named after them, wherever they are: also in a virtual environment. */
    private static final Pattern INTERPRETER = Pattern.compile("(.*/)?(python|pypy|node|nodejs|deno|bun|ruby|perl|php"
        + "|lua|luajit|java|dotnet|mono|julia|Rscript|bash|sh|env)[0-9.]*");
    /** Files that such a program runs. */
    private static final Pattern SCRIPT = Pattern.compile(
        "[^-\\s=][^\\s=]*\\.(py|pyc|js|mjs|cjs|ts|jar|java|rb|pl|php|lua|sh|bash|dll|jl|R)");
    private static final Pattern ASSIGNMENT = Pattern.compile("[A-Za-z_]\\w*=.*", Pattern.DOTALL);

    private ProgramFinder() { }

    /** The program's file, or {@code null} if the system would find none that it may execute. */
    public static Path find(String program) {
        return find(program, Path.of(""));
    }

    /** The program's file as it is found from a folder, or {@code null} if there is none that may be executed. */
    public static Path find(String program, Path folder) {
        return candidates(program, folder).stream().filter(ProgramFinder::isExecutable).findFirst().orElse(null);
    }

    /**
     * Checks that a program can be started, and that the script which it is to run is there.
     *
     * @param words  of the command
     * @param folder in which they are found
     * @throws IllegalArgumentException when it cannot; the message says what was found and what was expected
     */
    static void check(List<String> words, Path folder) {
        String program = words.get(0);
        if (program.equals("cd")) {
            throw new IllegalArgumentException("'cd' is a word of a shell, and none reads this; leave it out, and name "
                + "the bot's folder by --in" + (words.size() > 1 ? " " + words.get(1) : ""));
        }
        if (find(program, folder) == null) {
            throw new IllegalArgumentException(problem(program, folder)
                + (!ASSIGNMENT.matcher(program).matches() ? "" : "; a variable is set by env: 'env "
                    + CommandLine.quote(words) + "'"));
        }
        List<String> rest = words.subList(1, words.size());
        if (program.equals("env")) {
            List<String> run = rest.stream().dropWhile(word -> ASSIGNMENT.matcher(word).matches()).toList();
            if (!run.isEmpty() && !run.get(0).startsWith("-")) {
                check(run, folder);
            }
            return;
        }
        for (String word : runsOthers(program) ? rest : List.<String>of()) {
            if (isFile(word, folder)) {
                return;
            }
            if (SCRIPT.matcher(word).matches()) {
                throw new IllegalArgumentException("there is no file '" + word + "'" + in(word, folder));
            }
        }
    }

    /** True if a program runs another that is named after it: one of the {@code PATH}, or an interpreter. */
    static boolean runsOthers(String program) {
        return !isPath(program) || INTERPRETER.matcher(program).matches();
    }

    private static String in(String file, Path folder) {
        return file.startsWith("/") ? "" : " in " + folder.toAbsolutePath();
    }

    private static String problem(String program, Path folder) {
        if (program.isEmpty()) {
            return "the command is an empty word; expected a program";
        }
        for (Path file : candidates(program, folder)) {
            if (Files.isDirectory(file) && isPath(program)) {
                return "'" + program + "' is a directory; expected an executable program";
            }
            String noexec = Files.isRegularFile(file) ? MountTable.noexec(file) : null;
            if (noexec != null) {
                return "'" + file + "' is on '" + noexec + "', which is mounted noexec: nothing on it can be executed;"
                    + " name its interpreter before it, or move it elsewhere";
            }
            if (Files.isRegularFile(file)) {
                return "'" + file + "' is not executable; " + (SOURCE.matcher(program).matches()
                    ? "compile it, and name the program"
                    : "make it so with chmod +x, or name its interpreter before it");
            }
        }
        if (isPath(program)) {
            return "there is no file '" + program + "'" + in(program, folder);
        }
        String problem = "there is no program '" + program + "' on the PATH";
        if (program.indexOf(' ') >= 0) {
            return problem + "; its quotes make it one word: without them it is a command and its arguments";
        }
        return isFile(program, folder) ? problem + "; for the file in this directory write ./" + program : problem;
    }

    private static boolean isPath(String program) {
        return program.indexOf('/') >= 0;
    }

    /** True if a word is the path of an ordinary file, as seen from a folder. */
    static boolean isFile(String program, Path folder) {
        try {
            return Files.isRegularFile(folder.resolve(program));
        } catch (InvalidPathException e) {
            return false;
        }
    }

    private static boolean isExecutable(Path file) {
        return Files.isRegularFile(file) && Files.isExecutable(file);
    }

    /** The files that the name can mean, in order of search; an empty entry of {@code PATH} is the folder. */
    private static List<Path> candidates(String program, Path from) {
        List<Path> files = new ArrayList<>();
        if (program.isEmpty()) {
            return files;
        }
        String searched = System.getenv("PATH") == null ? FALLBACK_PATH : System.getenv("PATH");
        String[] folders = isPath(program) ? new String[] {""} : searched.split(":", -1);
        for (String folder : folders) {
            try {
                files.add(from.resolve(folder.isEmpty() && !isPath(program) ? "." : folder).resolve(program));
            } catch (InvalidPathException e) {
                continue;
            }
        }
        return files;
    }
}

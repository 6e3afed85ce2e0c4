package steward.bot.command;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Finds programs the way the system does: by path when the name has a slash, otherwise along {@code PATH}. */
public final class ProgramFinder {

    private static final String FALLBACK_PATH = "/usr/bin:/bin";
    private static final Pattern SOURCE = Pattern.compile(".*\\.(c|cc|cpp|cs|go|java|kt|rs|swift)");

    private ProgramFinder() { }

    /** The program's file, or {@code null} if the system would find none that it may execute. */
    public static Path find(String program) {
        return candidates(program).stream().filter(ProgramFinder::isExecutable).findFirst().orElse(null);
    }

    /**
     * Checks that a program can be started.
     *
     * @throws IllegalArgumentException when it cannot; the message says what was found and what was expected
     */
    static void check(String program) {
        if (find(program) == null) {
            throw new IllegalArgumentException(problem(program));
        }
    }

    private static String problem(String program) {
        if (program.isEmpty()) {
            return "the command is an empty word; expected a program";
        }
        for (Path file : candidates(program)) {
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
            String where = program.startsWith("/") ? "" : " in " + Path.of("").toAbsolutePath();
            return "there is no file '" + program + "'" + where;
        }
        String problem = "there is no program '" + program + "' on the PATH";
        if (program.indexOf(' ') >= 0) {
            return problem + "; its quotes make it one word: without them it is a command and its arguments";
        }
        return isFile(program) ? problem + "; for the file in this directory write ./" + program : problem;
    }

    private static boolean isPath(String program) {
        return program.indexOf('/') >= 0;
    }

    /** True if a word is the path of an ordinary file, as seen from the current directory. */
    static boolean isFile(String program) {
        try {
            return Files.isRegularFile(Path.of(program));
        } catch (InvalidPathException e) {
            return false;
        }
    }

    private static boolean isExecutable(Path file) {
        return Files.isRegularFile(file) && Files.isExecutable(file);
    }

    /**
     * The files that the name can mean, in order of search; an empty entry of {@code PATH} is the current directory.
     */
    private static List<Path> candidates(String program) {
        List<Path> files = new ArrayList<>();
        if (program.isEmpty()) {
            return files;
        }
        String searched = System.getenv("PATH") == null ? FALLBACK_PATH : System.getenv("PATH");
        String[] folders = isPath(program) ? new String[] {""} : searched.split(":", -1);
        for (String folder : folders) {
            try {
                files.add(Path.of(folder.isEmpty() && !isPath(program) ? "." : folder).resolve(program));
            } catch (InvalidPathException e) {
                continue;
            }
        }
        return files;
    }
}

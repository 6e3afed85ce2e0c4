package steward.bot.isolation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;

/**
 * Description of a program to be started as a bot: the program, its isolation, and the bots that it plays against.
 *
 * @param program   what is started, and where
 * @param isolation how it is kept apart
 * @param others    the bots it plays against, whose files it is not to see
 */
public record Launch(Program program, Isolation isolation, List<Program> others) {

    /** Shared memory, and files in memory that any user may leave there for another. */
    static final Path SHARED = Path.of("/dev/shm");
    /** Bytes that a bot may keep there. */
    static final long SHARED_BYTES = 64L << 20;

    /** As many as the launcher keeps. */
    private static final int MOST_CLOSED = 4096;

    private static final String END = "--";

    /**
     * Where a JVM has a file by its number and locks it. Bots have the same numbers, each in its own namespace, and the
     * second JVM would say so on its standard output, as its first answer.
     */
    private static final String JVM_FILES = "/tmp/hsperfdata_";

    public Launch {
        others = List.copyOf(others);
    }

    /** A program that is started in the current folder. */
    public Launch(List<String> command, Isolation isolation, List<Program> others) {
        this(Program.here(command), isolation, others);
    }

    /** Without a sandbox. */
    public static Launch plain(List<String> command) {
        return new Launch(command, Isolation.OFF, List.of());
    }

    private static final class Setsid {
        static final List<String> WORDS = find();

        private static List<String> find() {
            Path program = ProgramFinder.find("setsid");
            return program == null ? List.of() : List.of(program.toString());
        }
    }

    /** The prefix of a command that gives it a session of its own; empty where that is not possible. */
    public static List<String> ownSession() {
        return Setsid.WORDS;
    }

    /** True if the first process of the bot's namespace is to be told when to stop the bot. */
    public boolean holdsByInit() {
        return HoldMeans.of(isolation) == HoldMeans.INIT;
    }

    /**
     * Returns the process to start, with its variables; streams are left to the caller.
     *
     * @param controlGroup that it joins, or {@code null}
     * @param holdSocket   on which the referee listens for its first process, or {@code null}
     * @throws IOException if a file of the bot cannot be looked at
     */
    public ProcessBuilder builder(ControlGroup controlGroup, Path holdSocket) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(words(isolation, program, others, controlGroup, holdSocket));
        builder.directory(program.folder().toFile());
        if (!program.words().contains(System.getProperty("java.class.path"))) {  // where bundled bots are found, too
            ChosenLocale.undo(builder.environment());
        }
        isolation.environment().apply(builder.environment(), isolation.level());
        return builder;
    }

    static List<String> words(Isolation isolation, Program bot, List<Program> others,
                              ControlGroup controlGroup, Path holdSocket) {
        Path join = controlGroup == null ? null : controlGroup.joinFile();
        Path program = NativeLauncher.program();
        ResourceLimits limits = controlGroup != null && controlGroup.limits()
            ? isolation.limits().withoutControlGroup() : isolation.limits().withoutLongFilesInMemory();
        List<String> words = new ArrayList<>();
        switch (isolation.level()) {
            case OFF -> words.addAll(ShellLauncher.off(join));
            case LIGHT -> {
                if (program == null) {
                    words.addAll(ShellLauncher.light(isolation.network(), limits, join, emptied(bot),
                        closed(bot, others)));
                    break;
                }
                words.addAll(List.of(program.toString(), "light", "-u", "" + UserNumbers.userInside(), "-g",
                    "" + UserNumbers.groupInside()));
                if (isolation.network()) {
                    words.add("-l");
                }
                if (emptied(bot)) {
                    words.addAll(List.of("-e", SHARED.toString()));
                }
                closed(bot, others).forEach(file -> words.addAll(List.of("-b", file)));
                ControlGroup.mountPoints().forEach(point -> words.addAll(List.of("-r", point)));
                if (UserNumbers.hasName()) {
                    words.addAll(List.of("-e", JVM_FILES + UserNumbers.nameInside()));
                }
                words.addAll(socket(holdSocket));
                words.addAll(NativeLauncher.options(limits, join));
                words.add(END);
            }
            case STRICT -> {
                if (program == null) {
                    words.addAll(ShellLauncher.outside(join));
                } else {
                    words.addAll(List.of(program.toString(), "outside"));
                    words.addAll(socket(holdSocket));
                    words.addAll(NativeLauncher.options(ResourceLimits.NONE, join));
                    words.add(END);
                }
                words.addAll(StrictSandbox.words(isolation, bot, others, program,
                    controlGroup != null && controlGroup.limits() ? join.getParent() : null));
                if (program == null) {
                    words.addAll(ShellLauncher.inside(limits));
                } else {
                    words.addAll(List.of(StrictSandbox.LAUNCHER, "inside"));
                    if (holdSocket != null) {
                        words.add("-h");
                    }
                    words.addAll(NativeLauncher.options(limits, null));
                    words.add(END);
                }
            }
        }
        words.addAll(bot.words());
        return words;
    }

    /** True if the bot gets a folder of shared memory of its own; not where its program or the referee is in that. */
    private static boolean emptied(Program bot) {
        Path program = ProgramFinder.find(bot.words().get(0), bot.folder());
        return Files.isDirectory(SHARED) && !bot.folder().startsWith(SHARED)
            && (program == null || !program.startsWith(SHARED))
            && bot.words().stream().noneMatch(word -> word.startsWith(SHARED + "/"));
    }

    /** Files that make bots what they are: none of them is to change itself, or another. */
    private static List<String> closed(Program bot, List<Program> others) {
        return Stream.concat(Stream.of(bot), others.stream()).flatMap(each -> each.paths().stream())
            .filter(Files::isRegularFile).map(Path::toString).distinct().limit(MOST_CLOSED).toList();
    }

    private static List<String> socket(Path path) {
        return path == null ? List.of() : List.of("-s", path.toString());
    }
}

package steward.bot.isolation;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;
import steward.files.Sha256;
import steward.files.UserFolders;

/**
 * Small native program, {@value #SOURCE}, that starts bots in a sandbox and stops them while others are asked. It is
 * part of the jar (in a build with {@code -PbuiltLauncher}), or compiled once for each user by the machine's C compiler
 * and kept in the user's cache. Without either, a shell does the same (see {@link ShellLauncher}), but starts several
 * programs for every bot and cannot stop any.
 *
 * <p>The program is used only if it belongs to this user and nobody else can write to it or to its folder. Its name
 * contains a digest of the source and a checksum of the program: a program that is damaged, or no longer runs, is
 * compiled again. The checksum finds accidents; owner and permissions protect against attacks.
 */
final class NativeLauncher {

    /** The system property that does without the program if it is {@code false}. */
    static final String PROPERTY = "steward.sandbox.native";

    private static final String SOURCE = "/steward/sandbox/launch.c";
    /** Where a jar may have the compiled program; architecture and digest of the source follow. */
    private static final String BUILT = "/steward/sandbox/";
    private static final List<String> COMPILERS = List.of("cc", "gcc", "clang");
    private static final long PATIENCE_MS = 60_000;
    /** The exit status of the program where it is called without words, and can set a filter of system calls. */
    private static final int NO_COMMAND = 125;
    /** That status where it can set none. */
    private static final int NO_FILTER = 124;
    private static final int DIGEST = 8;
    private static final String OWNER_ONLY = "rwx------";
    private static final Set<PosixFilePermission> OTHERS_WRITE
        = Set.of(PosixFilePermission.GROUP_WRITE, PosixFilePermission.OTHERS_WRITE);

    private static final class Found {
        static final Path PROGRAM = find();
    }

    private static final class Filter {
        static final boolean WORKS = works();

        private static boolean works() {
            try {
                return program() != null && status(program()) == NO_COMMAND;
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
                return false;
            }
        }
    }

    /** True if the program is there and sets a filter of system calls. The first call starts it. */
    static boolean filters() {
        return Filter.WORKS;
    }

    /** The program, or {@code null} where there is none. The first call may compile it. */
    static Path program() {
        return Boolean.parseBoolean(System.getProperty(PROPERTY, "true")) ? Found.PROGRAM : null;
    }

    private static Path find() {
        if (!System.getProperty("os.name", "").equals("Linux")) {
            return null;
        }
        try (InputStream stream = NativeLauncher.class.getResourceAsStream(SOURCE)) {
            if (stream == null) {
                return null;
            }
            byte[] source = stream.readAllBytes();
            return in(UserFolders.cache(), source);
        } catch (IOException | UnsupportedOperationException | LinkageError none) {
            return null;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return null;
        }
    }

    /** The program in a folder; compiled if it is not there, or not as it was made. */
    static Path in(Path folder, byte[] source) throws IOException, InterruptedException {
        String name = "launch-" + System.getProperty("os.arch") + "-" + digest(source) + "-";
        List<Path> found = named(folder, name);
        for (Path program : found) {
            if (!isOurs(folder) || !isOurs(program)) {
                return null;
            }
            if (program.getFileName().toString().equals(name + checksum(program)) && runs(program)) {
                return program;
            }
        }
        Path made = made(folder, name, source);
        for (Path program : found) {
            if (made != null && !program.equals(made)) {
                Files.deleteIfExists(program);
            }
        }
        return made;
    }

    private static List<Path> named(Path folder, String beginning) throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().startsWith(beginning)).sorted().toList();
        }
    }

    private static String checksum(Path program) throws IOException {
        CRC32 sum = new CRC32();
        sum.update(Files.readAllBytes(program));
        return String.format(Locale.ROOT, "%08x", sum.getValue());
    }

    /** True if it starts here, and is what it should be: without words it says that there is no command. */
    private static boolean runs(Path program) throws InterruptedException {
        int status = Files.isExecutable(program) ? status(program) : 0;
        return status == NO_COMMAND || status == NO_FILTER;
    }

    private static int status(Path program) throws InterruptedException {
        return ProgramTrial.of(List.of(program.toString()), PATIENCE_MS).status();
    }

    /** The program as it was built with this one, or compiled here; {@code null} where there is neither. */
    private static Path made(Path folder, String name, byte[] source) throws IOException, InterruptedException {
        String compiler = COMPILERS.stream().filter(each -> ProgramFinder.find(each) != null).findFirst().orElse(null);
        byte[] built = built(name);
        if (compiler == null && built == null) {
            return null;
        }
        if (!Files.isDirectory(folder.toAbsolutePath().getParent().getParent())) {
            return null;                               // a home that is not there is not made
        }
        Files.createDirectories(folder.getParent());
        if (!Files.exists(folder)) {
            Files.createDirectory(folder,
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(OWNER_ONLY)));
        }
        if (!isOurs(folder)) {
            return null;
        }
        Path work = Files.createTempDirectory(folder, "build-");
        try {
            Path text = Files.write(work.resolve("launch.c"), source);
            Path made = work.resolve("launch");
            if (!write(built, made) && (compiler == null || !compile(compiler, text, made, "-static")
                    && !compile(compiler, text, made, "-O2"))) {
                return null;
            }
            // Another process may be doing the same: the last one replaces it by an equal one.
            return Files.move(made, folder.resolve(name + checksum(made)), StandardCopyOption.ATOMIC_MOVE);
        } finally {
            for (Path each : List.of(work.resolve("launch.c"), work.resolve("launch"), work)) {
                Files.deleteIfExists(each);
            }
        }
    }

    /** The program in the jar for this machine and this source, or {@code null}. */
    private static byte[] built(String name) throws IOException {
        try (InputStream stream = NativeLauncher.class.getResourceAsStream(BUILT + name.substring(0,
                name.length() - 1))) {
            return stream == null ? null : stream.readAllBytes();
        }
    }

    /** True if the program is there then, and runs. */
    private static boolean write(byte[] built, Path program) throws IOException, InterruptedException {
        if (built == null) {
            return false;
        }
        Files.write(program, built);
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString(OWNER_ONLY));
        return runs(program);
    }

    private static boolean compile(String compiler, Path source, Path program, String option)
            throws InterruptedException {
        List<String> command = new ArrayList<>(List.of(compiler, "-O2", option, "-o", program.toString(),
            source.toString()));
        return ProgramTrial.of(command, PATIENCE_MS).works() && runs(program);
    }

    private static boolean isOurs(Path file) throws IOException {
        return Files.getOwner(file, LinkOption.NOFOLLOW_LINKS).equals(Files.getOwner(Path.of("/proc/self")))
            && Files.getPosixFilePermissions(file,
            LinkOption.NOFOLLOW_LINKS).stream().noneMatch(OTHERS_WRITE::contains);
    }

    private static String digest(byte[] source) {
        return HexFormat.of().formatHex(Sha256.of(source), 0, DIGEST);
    }

    /** The options of a launch, without the mode. */
    static List<String> options(ResourceLimits limits, Path controlGroup) {
        List<String> words = new ArrayList<>();
        add(words, "-m", limits.memory());
        add(words, "-p", ResourceLimits.processesAreCountedApart(System.getProperty("os.version", ""))
            ? limits.processes() : 0);
        add(words, "-f", limits.fileSize());
        add(words, "-o", limits.openFiles());
        if (controlGroup != null) {
            words.addAll(List.of("-c", controlGroup.toString()));
        }
        return words;
    }

    private static void add(List<String> words, String option, long value) {
        if (value > 0) {
            words.addAll(List.of(option, Long.toString(value)));
        }
    }
}

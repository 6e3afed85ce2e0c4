package steward.cli.tournament;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.ChosenLocale;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.ProgramRun;
import steward.cli.tournament.Programs.Program;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.scene.json.JsonLimits;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/**
 * Workshop that makes programs ready to run: it copies each source into a folder of its own and compiles it once, in
 * the sandbox. A compiler writes its result to the standard output, so that it needs no place to write but temporary
 * files.
 *
 * @param folder    of all of them
 * @param isolation of compilers
 * @param limitMs   for one program
 * @param bounds    of one program
 * @param cxxFlags  further words for the compiler of C++
 */
record Workshop(Path folder, Isolation isolation, long limitMs, HandIn.Bounds bounds, List<String> cxxFlags) {

    static final String COMPILER = "the compiler failed";
    /** So much of what a compiler says is kept, in bytes. */
    private static final int SAID = 20_000;
    /** Files of a folder whose change during the games is seen; of more, league.json could not be read. */
    private static final int WATCHED = 400;
    /** The name of the program and the digest of what was handed in: equal programs of two people are two. */
    private static final String CONTENT = "content.txt";
    /** Characters of a command that league.json can hold behind a prefix. */
    private static final int MOST_COMMAND = JsonLimits.TEXT - 20;
    /** The source that was compiled last by the same call. */
    private static final String COMPILED = "compiled";
    /** Output of the compiler; of C++ the first line is its call. */
    private static final String SAYS = "compiler.txt";
    private static final Pattern PUBLIC = Pattern.compile(
        "\\bpublic\\s+(?:final\\s+|abstract\\s+|strictfp\\s+|sealed\\s+)*(?:class|record|enum|interface)\\s+([\\w$]+)",
        Pattern.UNICODE_CHARACTER_CLASS);

    /** Headers of C++, which bots do not need and compilers do. */
    private static final List<Path> HEADERS = Stream.of("/usr/include", "/usr/local/include").map(Path::of)
        .filter(Files::isDirectory).toList();

    /** Both take the source, the compiler, and another tool or flags; that of C++ says first how it calls. */
    private static final String BEGIN = "d=$(mktemp -d) || exit 1; trap 'rm -rf \"$d\"' EXIT; ";
    private static final String CPP = BEGIN + "ulimit -v 4000000 2>/dev/null; "
        + "for std in c++20 c++2a c++17; do \"$1\" -std=$std -E -x c++ /dev/null >/dev/null 2>&1 && break; done; "
        + "cxx=$1; shift; set -- -O2 -std=$std \"$@\"; echo \"${cxx##*/} $*\" >&2; "
        + "\"$cxx\" \"$@\" -o \"$d/bot\" \"$0\" >&2 && cat \"$d/bot\"";
    private static final String JAVA = BEGIN + "mkdir \"$d/classes\"; "
        + "\"$1\" -J-Xmx512m -encoding UTF-8 -proc:none -nowarn -d \"$d/classes\" \"$0\" >&2 "
        + "&& \"$2\" -J-Xmx512m --create --file \"$d/bot.jar\" -C \"$d/classes\" . >&2 "
        + "&& cat \"$d/bot.jar\"";

    /**
     * A program that was made ready.
     *
     * @param folder  in which it is started
     * @param command its words, or {@code null} if it cannot run
     * @param files   that it consists of, relative to the folder
     * @param problem why it cannot run, what the compiler said; or {@code null}
     * @param source  what was handed in, as it was copied; or {@code null}
     */
    record Ready(Program program, Path folder, List<String> command, List<Path> files, String problem, HandIn source) {

        private static Ready of(Program program, Path folder, List<String> command, Path file) {
            return new Ready(program, folder, command, List.of(folder.relativize(file)), null, null);
        }

        /** True if the source is another one now. */
        boolean isChanged(HandIn.Bounds bounds) {
            return source != null && source.isChanged(bounds);
        }
    }

    /** Makes a program ready; what has been compiled from the same source is not compiled again. */
    Ready make(Program program) throws InterruptedException {
        Path own = folder.resolve(program.name());
        HandIn source = null;
        try {
            source = HandIn.of(program.source(), bounds);
            Path copy = Files.createDirectories(own).resolve(program.kind().copy);
            String digest = source.copy(copy);
            Path content = Files.writeString(own.resolve(CONTENT), program.name() + "\n" + digest + "\n");
            Files.writeString(own.resolve(Programs.HANDED_IN_AS), program.source().getFileName().toString());
            Ready ready = make(program, own, copy, source);
            return ready.problem() != null ? ready : new Ready(program, ready.folder(), ready.command(), Stream.concat(
                Stream.of(ready.folder().relativize(content)), ready.files().stream().limit(WATCHED)).toList(), null,
                source);
        } catch (InputException problem) {
            return new Ready(program, null, null, List.of(), problem.getMessage(), source);
        } catch (IOException problem) {
            return failed(program, "cannot be copied: " + OutputFiles.reason(program.source(), problem));
        } catch (InvalidPathException problem) {
            return failed(program, "found the class " + problem.getInput() + ", expected one whose name can be that of "
                + "a file here, as with LANG=C.UTF-8");
        }
    }

    private Ready make(Program program, Path own, Path copy, HandIn source) throws IOException, InterruptedException {
        return switch (program.kind()) {
            case PYTHON -> script(program, copy, "python3");
            case JS, MODULE -> script(program, copy, "node");
            case CPP -> cpp(program, own, copy);
            case JAVA -> java(program, own, copy);
            case FOLDER -> folder(program, copy, source);
        };
    }

    private static Ready failed(Program program, String problem) {
        return new Ready(program, null, null, List.of(), problem, null);
    }

    private static Ready script(Program program, Path copy, String interpreter) {
        return ProgramFinder.find(interpreter) == null
            ? failed(program, "there is no program '" + interpreter + "' on the PATH of this machine")
            : Ready.of(program, copy.getParent(), List.of(interpreter, copy.getFileName().toString()), copy);
    }

    private Ready cpp(Program program, Path own, Path source) throws IOException, InterruptedException {
        Path compiler = Stream.of("g++", "clang++", "c++").map(ProgramFinder::find).filter(each -> each != null)
            .findFirst().orElse(null);
        Path made = own.resolve("bot");
        String problem = compiler == null ? "there is no C++ compiler (g++ or clang++) on the PATH of this machine"
            : compile(source, made, CPP, Stream.concat(Stream.of(compiler.toString()), cxxFlags.stream())
                .toArray(String[]::new));
        if (problem != null) {
            return failed(program, problem);
        }
        return made.toFile().setExecutable(true) ? Ready.of(program, own, List.of("./" + made.getFileName()), made)
            : failed(program, made + " cannot be made executable");
    }

    private Ready java(Program program, Path own, Path copy) throws IOException, InterruptedException {
        String text = new String(Files.readAllBytes(copy), StandardCharsets.UTF_8)
            .replaceFirst("^\uFEFF", "");
        Matcher named = PUBLIC.matcher(text);
        Path source = own.resolve((named.find() ? named.group(1) : "Bot") + ".java");
        Path made = own.resolve("bot.jar");
        if (!Files.exists(source) || !Files.readString(source).equals(text)) {
            Files.writeString(source, text);
        }
        Path javac = tool("javac");
        Path jar = tool("jar");
        String problem = javac == null || jar == null
            ? "there is no Java compiler (javac and jar, of a JDK) on this machine"
            : compile(source, made, JAVA, javac.toString(), jar.toString());
        if (problem != null) {
            return failed(program, problem);
        }
        String main = main(made);
        if (main == null) {
            return failed(program, "found no class with a method 'public static void main(String[] args)'");
        }
        List<String> command = new ArrayList<>(ChosenLocale.wordsIn(own));
        command.addAll(List.of(java(), "-cp", made.getFileName().toString(), main));
        return Ready.of(program, own, command, made);
    }

    private static Path tool(String name) {
        Path own = Path.of(System.getProperty("java.home"), "bin", name);
        return Files.isExecutable(own) ? own : ProgramFinder.find(name);
    }

    /** By its name where that means the same, so that a tournament can be moved to another machine. */
    private static String java() throws IOException {
        Path java = tool("java");
        Path usual = ProgramFinder.find("java");
        return usual != null && Files.isSameFile(java, usual) ? "java" : java.toString();
    }

    /** The first class in which both the name and the type of a main method stand. */
    private static String main(Path made) throws IOException {
        try (JarFile jar = new JarFile(made.toFile())) {
            for (Enumeration<JarEntry> entries = jar.entries(); entries.hasMoreElements();) {
                JarEntry entry = entries.nextElement();
                if (entry.getName().endsWith(".class") && !entry.getName().contains("$")) {
                    try (InputStream in = jar.getInputStream(entry)) {
                        String bytes = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
                        if (bytes.contains("\1\0\4main") && bytes.contains("([Ljava/lang/String;)V")) {
                            return entry.getName().replaceFirst("\\.class$", "").replace('/', '.');
                        }
                    }
                }
            }
        }
        return null;
    }

    private static Ready folder(Program program, Path copy, HandIn source) throws IOException {
        if (!source.files().containsKey("run")) {
            return failed(program, "run: found no regular file, expected one with a command such as 'python3 main.py'");
        }
        List<Path> files = source.files().keySet().stream().map(Path::of).toList();
        List<String> words = new ArrayList<>();
        try {
            String run = Utf8Text.decode(Files.readAllBytes(copy.resolve("run")), "run", "a command in UTF-8")
                .replaceFirst("^\uFEFF", "");
            if (run.startsWith("#!") && !copy.resolve("run").toFile().setExecutable(true)) {
                return failed(program, "run: cannot be made executable");
            }
            words.addAll(run.startsWith("#!") ? List.of("./run")
                : CommandLine.split(run.lines().map(String::strip).filter(line -> !line.isEmpty()).findFirst()
                    .orElse("")));
        } catch (NotUtf8Exception problem) {
            return failed(program, problem.getMessage());
        } catch (IllegalArgumentException problem) {
            return failed(program, "run: " + problem.getMessage());
        }
        int length = CommandLine.quote(words).length();
        if (length > MOST_COMMAND) {
            return failed(program, "run: found a command that is " + length + " characters long as it is called, "
                + "expected at most " + MOST_COMMAND + "; a script beside it can have a longer one");
        }
        return words.isEmpty()
            ? failed(program, "run: found an empty file, expected a command such as 'python3 main.py'")
            : new Ready(program, copy, words, files, null, null);
    }

    /** Compiles, unless it was compiled from the same source; returns what the compiler said if that failed. */
    private String compile(Path source, Path made, String script, String... tools)
            throws IOException, InterruptedException {
        Path known = made.resolveSibling(COMPILED + "." + Integer.toHexString(
            (script + String.join("\0", tools)).hashCode()));
        if (Files.isRegularFile(made) && Files.isRegularFile(known) && Files.mismatch(source, known) < 0) {
            return null;
        }
        Path part = made.resolveSibling("bot.part");
        Path said = made.resolveSibling(SAYS);
        List<String> command = new ArrayList<>(ChosenLocale.words());
        command.addAll(List.of("sh", "-c", script, source.toString()));
        command.addAll(List.of(tools));
        OptionalInt status = ProgramRun.of(new Launch(command,
            isolation.showing(HEADERS), List.of()), part, said, limitMs);
        String text = beginning(said);
        if (status.isEmpty() || status.getAsInt() != 0) {
            Files.deleteIfExists(part);
            return (status.isPresent() ? COMPILER + ": " + firstError(text, source)
                : "the compiler did not end within " + TimeUnit.MILLISECONDS.toSeconds(limitMs) + " s") + "\n" + text;
        }
        Files.move(part, made, StandardCopyOption.ATOMIC_MOVE);
        Files.copy(source, known, StandardCopyOption.REPLACE_EXISTING);
        return null;
    }

    /** How a program of C++ was compiled, or {@code null}. */
    static String call(Ready ready) throws IOException {
        Path said = ready.program().kind() != Programs.Kind.CPP || ready.folder() == null ? null
            : ready.folder().resolve(SAYS);
        return said == null || !Files.isRegularFile(said) ? null
            : beginning(said).lines().findFirst().orElse(null);
    }

    /** First line of a compiler that names an error, with the bare name of the source; empty if there is none. */
    static String firstError(String text, Path source) {
        return text.lines().filter(line -> line.contains("error")).findFirst().orElse("")
            .replace(source.toString(), source.getFileName().toString()).strip();
    }

    private static String beginning(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return new String(in.readNBytes(SAID), StandardCharsets.UTF_8);
        }
    }
}

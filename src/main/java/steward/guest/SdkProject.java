package steward.guest;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.function.Consumer;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Launch;
import steward.bot.process.ProgramRun;
import steward.files.InputException;
import steward.files.Remedied;

/**
 * A project on the SDK as its author has published it: what has been compiled, or what its Maven makes of it, and what
 * its {@code config} says.
 *
 * @param classPath   the project first, absolute
 * @param mostPlayers of a game; the fewest is {@code fewestPlayers}
 * @param mode        multi, or solo for a game for one with tests
 * @param levels      folders of league levels, at least 1
 * @param testIn      lines of its first test, in a game for one
 */
record SdkProject(List<String> classPath, int fewestPlayers, int mostPlayers, String mode, int levels,
                  List<String> testIn) {

    private static final String SDK_CLASS = GuestProgram.SDK_MAIN.replace('.', '/') + ".class";
    private static final Pattern ENGINE = Pattern.compile(
        "<groupId>com\\.codingame\\.gameengine</groupId>\\s*<artifactId>core</artifactId>\\s*"
        + "<version>(?:\\$\\{([^}<]+)\\}|([^<]+))</version>");
    private static final String PART = "com\\.codingame\\.gameengine:[\\w-]+:(?:jar|pom):[\\w.-]+";
    /** A part of an engine that Maven has looked for in vain, now or a short time ago. */
    private static final Pattern NOT_TO_BE_HAD = Pattern.compile(
        "(?<=ould not find artifact )" + PART + "|" + PART + "(?= was not found in )");
    /** A first build fetches all that a project needs. */
    private static final long PATIENCE_MS = 900_000;
    /** The newest engine on Maven Central. */
    private static final String PUBLISHED = "4.3.0";
    private static final Pattern TEST_IN = Pattern.compile("\"testIn\"\\s*:\\s*\"((?:[^\"\\\\]|\\\\.)*)\"");

    /**
     * Finds a project.
     *
     * @param path   its folder, or a jar that has all in it
     * @param engine version to build with in place of the project's, or {@code null}
     */
    static SdkProject find(Path path, String engine, Consumer<String> told) {
        Path whole = path.toAbsolutePath().normalize();
        if (Files.isRegularFile(whole)) {
            return configured(whole.getParent(), checked(path, List.of(whole)));
        }
        if (!Files.isDirectory(whole)) {
            throw new InputException(path + ": found no such file, expected the folder of a project on the SDK or "
                + "its jar");
        }
        Path classes = whole.resolve("target/classes");
        List<Path> jars = new ArrayList<>();
        for (String folder : List.of("target/dependency", "target/lib", "lib")) {
            jars.addAll(list(whole.resolve(folder)).filter(file -> file.toString().endsWith(".jar")).toList());
        }
        if (Files.isDirectory(classes) && !jars.isEmpty() && engine == null) {
            jars.add(0, classes);
            return configured(whole, checked(path, jars));
        }
        if (!Files.isRegularFile(whole.resolve("pom.xml"))) {
            throw new InputException(path + ": found neither a pom.xml nor target/classes with jars in "
                + "target/dependency, target/lib or lib, expected a project on the SDK");
        }
        return configured(whole, checked(path, build(whole, engine, told)));
    }

    private static Stream<Path> list(Path folder) {
        try (Stream<Path> files = Files.isDirectory(folder) ? Files.list(folder) : Stream.empty()) {
            return files.sorted().toList().stream();
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be read: " + problem.getMessage());
        }
    }

    private static List<Path> checked(Path path, List<Path> classPath) {
        for (Path entry : classPath) {
            if (Files.isDirectory(entry)) {
                continue;
            }
            try (JarFile jar = new JarFile(entry.toFile())) {
                if (jar.getEntry(SDK_CLASS) != null) {
                    return classPath;
                }
            } catch (IOException problem) {
                throw new InputException(entry + ": cannot be read as a jar: " + problem.getMessage());
            }
        }
        throw new InputException(path + ": found no " + GuestProgram.SDK_MAIN
            + " in it, expected the SDK with the project");
    }

    /** Builds a project with its Maven, and asks for the class path. */
    private static List<Path> build(Path project, String engine, Consumer<String> told) {
        Path maven = ProgramFinder.find("mvn");
        if (maven == null) {
            throw new InputException(project + ": found no mvn on the PATH, expected Maven, or what it compiles to: "
                + "target/classes with all jars in target/dependency");
        }
        try {
            Path said = Files.createTempFile("steward-adopt", ".txt");
            try {
                Path found = project.resolve("target/steward-class-path.txt");
                List<String> words = new ArrayList<>(List.of(maven.toString(), "-q", "-B", "-f",
                    project.resolve("pom.xml").toString()));
                if (engine != null) {
                    words.add("-D" + property(project) + "=" + engine);
                }
                words.addAll(List.of("compile", "dependency:build-classpath", "-Dmdep.outputFile=" + found));
                told.accept("running: " + String.join(" ", words));
                if (ProgramRun.of(Launch.plain(words), said, said, PATIENCE_MS).orElse(-1) != 0) {
                    throw refusal(project, Files.readString(said), engine);
                }
                List<Path> classPath = new ArrayList<>(List.of(project.resolve("target/classes")));
                Stream.of(Files.readString(found).strip().split(System.getProperty("path.separator")))
                    .forEach(entry -> classPath.add(Path.of(entry)));
                return classPath;
            } finally {
                Files.delete(said);
            }
        } catch (IOException problem) {
            throw new InputException(project + ": cannot be built: " + problem.getMessage());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new InputException(project + ": the build was interrupted");
        }
    }

    private static String property(Path project) throws IOException {
        Matcher engine = ENGINE.matcher(Files.readString(project.resolve("pom.xml")));
        if (!engine.find() || engine.group(1) == null) {
            throw new InputException("engine", "found a pom.xml that writes the version of the engine out, expected a "
                + "property for it");
        }
        return engine.group(1);
    }

    /** @param said what Maven wrote, whose first line may begin with colours */
    static InputException refusal(Path project, String said, String engine) {
        Matcher missing = NOT_TO_BE_HAD.matcher(said);
        if (missing.find() && !PUBLISHED.equals(engine)) {
            String absent = missing.group() + ", which is not to be had";
            return engine == null ? new InputException(project + ": needs " + absent + ": build it yourself, or try "
                + "another engine, such as " + PUBLISHED + ", the newest that is published",
                List.of(new Remedied.Remedy("engine", PUBLISHED + " takes that")))
                : new InputException("engine", "found " + engine + ", which needs " + absent + ", expected a version "
                + "such as " + PUBLISHED + ", the newest that is published");
        }
        List<String> errors = said.lines().filter(line -> line.matches(".*\\[ERROR\\] +\\S.*"))
            .map(line -> line.substring(line.indexOf("[ERROR]"))).limit(5).toList();
        return new InputException(project + ": its Maven failed: " + String.join(" | ", errors));
    }

    private static SdkProject configured(Path folder, List<Path> classPath) {
        Properties config = new Properties();
        Path file = folder.resolve("config/config.ini");
        try {
            if (Files.isRegularFile(file)) {
                config.load(Files.newBufferedReader(file, StandardCharsets.UTF_8));
            }
            boolean solo = List.of("opti", "solo").contains(config.getProperty("type", "multi").strip());
            int fewest = number(config, "min_players", solo ? 1 : 2);
            int levels = (int) list(folder.resolve("config"))
                .filter(level -> level.getFileName().toString().matches("level\\d+")).count();
            return new SdkProject(classPath.stream().map(Path::toString).toList(), fewest,
                Math.max(fewest, number(config, "max_players", fewest)), solo ? "solo" : "multi", Math.max(1, levels),
                solo ? testIn(folder.resolve("config/test1.json")) : List.of());
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be read: " + problem.getMessage());
        }
    }

    private static int number(Properties config, String key, int usual) {
        String text = config.getProperty(key, "").strip();
        return text.matches("[1-9]|1[0-6]") ? Integer.parseInt(text) : usual;
    }

    private static List<String> testIn(Path test) throws IOException {
        Matcher found = Files.isRegularFile(test) ? TEST_IN.matcher(Files.readString(test)) : null;
        return found == null || !found.find() ? List.of("")
            : List.of(found.group(1).replace("\\\"", "\"").split("\\\\n"));
    }
}

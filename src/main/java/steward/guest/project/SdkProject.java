package steward.guest.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;
import steward.files.InputException;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.json.JsonMapper;

/**
 * Project of a referee on CodinGame's SDK as its author has published it. It has compiled classes, or its Maven makes
 * them, and its {@code config} has the settings.
 *
 * @param classPath     the project first, absolute
 * @param engine        engine that was built from source for it, for people; or {@code null}
 * @param mostPlayers   of a game; the fewest is {@code fewestPlayers}
 * @param mode          multi, or solo for a game for one with tests
 * @param config        its folder of settings
 * @param levels        highest number among the folders of league levels; 0 for none
 * @param tests         lines of each test, in a game for one
 * @param criterion     key of the value that orders results of a game for one; empty for its scores
 * @param lowerIsBetter whether a lower value of it is better
 */
public record SdkProject(List<String> classPath, String engine, int fewestPlayers, int mostPlayers, String mode,
                         Path config, int levels, List<List<String>> tests, String criterion, boolean lowerIsBetter) {

    /** Main class of a referee on the SDK. */
    public static final String MAIN = "com.codingame.gameengine.core.RefereeMain";

    /** Repository in which the SDK itself is developed. */
    public static final String ENGINE_REPOSITORY = "https://github.com/CodinGame/codingame-game-engine";

    private static final String SDK_CLASS = MAIN.replace('.', '/') + ".class";
    private static final String LEVEL = "level\\d{1,4}";
    private static final String TEST = "test(\\d{1,4})\\.json";

    /**
     * Finds a project.
     *
     * @param path   its folder, or a jar that has all in it
     * @param engine version to build with in place of the project's, or {@code null}
     * @param source clone of the engine's repository to build the engine from, or {@code null}
     */
    public static SdkProject find(Path path, String engine, Path source, Consumer<String> told) {
        Path whole = path.toAbsolutePath().normalize();
        if (Files.isRegularFile(whole)) {
            return configured(whole.getParent(), checked(path, List.of(whole)), null);
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
        if (Files.isDirectory(classes) && !jars.isEmpty() && engine == null && source == null) {
            jars.add(0, classes);
            return configured(whole, checked(path, jars), null);
        }
        if (!Files.isRegularFile(whole.resolve("pom.xml"))) {
            throw new InputException(path + ": found neither a pom.xml nor target/classes with jars in "
                + "target/dependency, target/lib or lib, expected a project on the SDK");
        }
        ProjectBuild build = ProjectBuild.of(whole, engine, source, told);
        return configured(whole, checked(path, build.classPath()), build.engine());
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
        throw new InputException(path + ": found no " + MAIN + " in it, expected the SDK with the project");
    }

    private static SdkProject configured(Path folder, List<Path> classPath, String engine) {
        Properties settings = new Properties();
        Path config = folder.resolve("config");
        Path file = config.resolve("config.ini");
        try {
            if (Files.isRegularFile(file)) {
                settings.load(Files.newBufferedReader(file, StandardCharsets.UTF_8));
            }
            boolean solo = List.of("opti", "solo").contains(settings.getProperty("type", "multi").strip());
            int fewest = number(settings, "min_players", solo ? 1 : 2);
            int levels = list(config).map(level -> level.getFileName().toString()).filter(level -> level.matches(LEVEL))
                .mapToInt(level -> Integer.parseInt(level.substring("level".length()))).max().orElse(0);
            return new SdkProject(classPath.stream().map(Path::toString).toList(), engine, fewest,
                Math.max(fewest, number(settings, "max_players", fewest)), solo ? "solo" : "multi", config, levels,
                solo ? tests(config) : List.of(), solo ? settings.getProperty("criteria", "").strip() : "",
                settings.getProperty("sorting_order", "").strip().equalsIgnoreCase("asc"));
        } catch (IOException | IllegalArgumentException problem) {
            throw new InputException(file + ": cannot be read: " + problem.getMessage());
        }
    }

    /** A bot of the contest, of its highest level that has one in a language without a compiler; or {@code null}. */
    public Program boss() {
        for (int level = levels; level >= 0; level--) {
            Path folder = level == 0 ? config : config.resolve("level" + level);
            for (String ending : List.of(".py", ".js", ".java")) {
                Path program = ProgramFinder.find(Map.of(".py", "python3", ".js", "node", ".java", "java").get(ending));
                if (program != null && Files.isRegularFile(folder.resolve("Boss" + ending))) {
                    return new Program(List.of(program.toString(), "Boss" + ending), folder, null);
                }
            }
        }
        return null;
    }

    private static int number(Properties config, String key, int usual) {
        String text = config.getProperty(key, "").strip();
        return text.matches("[1-9]|1[0-6]") ? Integer.parseInt(text) : usual;
    }

    /** The lines of all tests in the order of their numbers; one empty test where there is none. */
    private static List<List<String>> tests(Path config) throws IOException {
        TreeMap<Integer, List<String>> tests = new TreeMap<>();
        for (Path file : list(config).filter(each -> each.getFileName().toString().matches(TEST)).toList()) {
            try {
                String lines = JsonMapper.shared().readTree(Files.readString(file)).path("testIn").asString("");
                tests.put(Integer.parseInt(file.getFileName().toString().replaceFirst(TEST, "$1")),
                    List.of(lines.replace("\\n", "\n").split("\r?\n")));
            } catch (JacksonException problem) {
                throw new InputException(file + ": cannot be read: " + problem.getOriginalMessage());
            }
        }
        return tests.isEmpty() ? List.of(List.of("")) : List.copyOf(tests.values());
    }
}

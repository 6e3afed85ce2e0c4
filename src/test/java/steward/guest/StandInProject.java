package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/**
 * A project on a stand-in for the SDK as its author leaves it: the contest in target/classes, the SDK's jar in lib.
 *
 * @param folder of the project
 */
public record StandInProject(Path folder) {

    private static final Path SOURCES = Path.of("src/test/resources/referees/sdk");
    private static final String MAIN = "com/codingame/gameengine/core/RefereeMain";

    /** Classes that a source was compiled to for an earlier test, by their names. */
    private static final Map<String, Map<String, byte[]>> COMPILED = new ConcurrentHashMap<>();

    /** Compiles it with the referee among the resources. */
    public static StandInProject compiled(Path folder) throws IOException {
        return compiled(folder, SOURCES.resolve("Referee.java"));
    }

    /** Compiles it with a referee. */
    static StandInProject compiled(Path folder, Path referee) throws IOException {
        Path sdk = folder.resolve("sdk");
        compile(SOURCES.resolve(MAIN + ".java"), sdk);
        compile(referee, folder.resolve("target/classes"));
        Files.createDirectories(folder.resolve("lib"));
        try (OutputStream file = Files.newOutputStream(folder.resolve("lib/core.jar"));
                JarOutputStream jar = new JarOutputStream(file)) {
            jar.putNextEntry(new JarEntry(MAIN + ".class"));
            jar.write(Files.readAllBytes(sdk.resolve(MAIN + ".class")));
        }
        for (int level = 1; level <= 2; level++) {
            Files.createDirectories(folder.resolve("config/level" + level));
        }
        Files.writeString(folder.resolve("config/config.ini"), "min_players=2\nmax_players=3\ntype=multi");
        return new StandInProject(folder);
    }

    private static void compile(Path source, Path folder) throws IOException {
        Files.createDirectories(folder);
        String text = Files.readString(source);
        Map<String, byte[]> compiled = COMPILED.get(text);
        if (compiled == null) {
            JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
            assumeTrue(compiler != null, "skipped: this is no JDK");
            Path made = Files.createTempDirectory(folder, "made");
            assertEquals(0, compiler.run(null, null, null, "-d", made.toString(), source.toString()));
            compiled = new TreeMap<>();
            try (Stream<Path> files = Files.walk(made)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    if (Files.isRegularFile(file)) {
                        compiled.put(made.relativize(file).toString(), Files.readAllBytes(file));
                    }
                    Files.delete(file);
                }
            }
            COMPILED.put(text, compiled);
        }
        for (Map.Entry<String, byte[]> type : compiled.entrySet()) {
            Path file = folder.resolve(type.getKey());
            Files.createDirectories(file.getParent());
            Files.write(file, type.getValue());
        }
    }

    /** Returns a scene of it. @param more fields of the referee, each behind a comma */
    public String scene(int players, String more) {
        return """
            {"name": "small", "game": "guest", "players": %d,
             "referee": {"classPath": ["%s", "%s"]%s}}""".formatted(players, folder.resolve("target/classes"),
            folder.resolve("lib/core.jar"), more);
    }

    /** Returns a bot that says a word whenever it is sent a line. */
    public static String bot(Path folder, String name, String word) throws IOException {
        return name + "=codingame:sh " + Files.writeString(folder.resolve("echo.sh"),
            "while IFS= read -r line; do echo \"$1\"; done\n") + " " + word;
    }

    /** Ends the JVMs that wait for another game. */
    public static void end() {
        GuestType.endIdle();
    }
}

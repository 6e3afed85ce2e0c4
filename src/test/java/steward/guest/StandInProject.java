package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
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

    /** Compiles it with the referee among the resources. */
    public static StandInProject compiled(Path folder) throws IOException {
        return compiled(folder, SOURCES.resolve("Referee.java"));
    }

    /** Compiles it with a referee. */
    static StandInProject compiled(Path folder, Path referee) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this is no JDK");
        Path classes = Files.createDirectories(folder.resolve("target/classes"));
        Path sdk = Files.createDirectories(folder.resolve("sdk"));
        assertEquals(0, compiler.run(null, null, null, "-d", sdk.toString(),
            SOURCES.resolve(MAIN + ".java").toString()));
        assertEquals(0, compiler.run(null, null, null, "-d", classes.toString(), referee.toString()));
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

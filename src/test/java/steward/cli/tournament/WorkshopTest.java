package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;

/** Source files become programs. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class WorkshopTest {

    private static final HandIn.Bounds BOUNDS = new HandIn.Bounds(1, 20);
    private static final List<String> FLAGS = List.of("-DVALUE=7", "-DNAME=a b");

    @TempDir
    private Path folder;

    private Workshop.Ready made(String file, Programs.Kind kind, Isolation isolation, String text)
            throws IOException, InterruptedException {
        Path source = Files.writeString(Files.createDirectories(folder.resolve("in")).resolve(file), text);
        return new Workshop(Files.createDirectories(folder.resolve("out")), isolation, 120_000, BOUNDS, FLAGS)
            .make(new Programs.Program("bot", source, kind));
    }

    @Test
    @Tag("campaign")
    void aPublicClassIsCompiledAsTheFileOfItsName() throws IOException, InterruptedException {
        assumeTrue(ProgramFinder.find("javac") != null, "there is no Java compiler");
        Workshop.Ready ready = made("x.java", Programs.Kind.JAVA, Isolation.OFF,
            "public class Fr\u00fchling { public static void main(String[] words) { } }\n");
        assertNull(ready.problem());
        assertEquals("Fr\u00fchling", ready.command().get(3));
    }

    @Test
    void aCompilerFindsItsHeadersAtStrict() throws IOException, InterruptedException {
        assumeTrue(ProgramFinder.find("g++") != null, "there is no C++ compiler");
        assumeTrue(SandboxSupport.problem(SandboxLevel.STRICT) == null, "strict does not work here");
        Workshop.Ready ready = made("x.cpp", Programs.Kind.CPP, Isolation.at(SandboxLevel.STRICT),
            "#include <iostream>\n#include <concepts>\nint main() { std::cout << VALUE << std::endl; }\n");
        assertNull(ready.problem());
        assertEquals("g++ -O2 -std=c++20 -DVALUE=7 -DNAME=a b", Workshop.call(ready));
    }

    @Test
    void aProgramThatCannotBeReadIsTold() throws Exception {
        Workshop.Ready ready = new Workshop(folder, Isolation.OFF, 1, BOUNDS, List.of()).make(
            new Programs.Program("bot", folder.resolve("gone.py"), Programs.Kind.PYTHON));
        assertTrue(ready.problem().startsWith("cannot be copied: "), ready.problem());
    }

    @Test
    void theFirstErrorIsToldWithTheBareNameOfTheSource() {
        assertEquals("bot.cpp:3:1: error: no",
            Workshop.firstError("In file /a/b/bot.cpp:\n/a/b/bot.cpp:3:1: error: no\n", Path.of("/a/b/bot.cpp")));
        assertEquals(List.of("", ""), List.of(Workshop.firstError("", Path.of("x")),
            Workshop.firstError("warning\n", Path.of("x"))));
    }
}

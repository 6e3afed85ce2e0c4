package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;

/** The program that starts bots is compiled once, and used only if nobody else can change it. */
@Tag("process")
class NativeLauncherTest {

    private static final byte[] SOURCE = "int main(void) { return 7; }\n".getBytes(StandardCharsets.US_ASCII);

    @TempDir
    private Path folder;

    @BeforeEach
    void compiler() {
        assumeTrue(ProgramFinder.find("cc") != null || ProgramFinder.find("gcc") != null, "skipped: no C compiler");
        assumeTrue(Files.isDirectory(Path.of("/proc/self")), "skipped: there is no /proc");
    }

    @Test
    void itIsCompiledOnceAndKept() throws IOException, InterruptedException {
        Path cache = folder.resolve("cache/steward");
        Path program = NativeLauncher.in(cache, SOURCE);
        assertEquals(7, ProgramTrial.of(List.of(program.toString()), 60_000).status());
        Object when = Files.getLastModifiedTime(program);
        assertEquals(program, NativeLauncher.in(cache, SOURCE));
        assertEquals(when, Files.getLastModifiedTime(program));
        try (Stream<Path> files = Files.list(cache)) {
            assertEquals(1, files.count(), "what was needed to compile it is left");
        }
    }

    /** A machine that lost power can leave an empty file; that one ends with status 0 and starts nothing. */
    @Test
    void anEmptyOneIsCompiledAgain() throws IOException, InterruptedException {
        Path cache = folder.resolve("steward");
        Files.write(NativeLauncher.in(cache, SOURCE), new byte[0]);
        Path program = NativeLauncher.in(cache, SOURCE);
        assertEquals(7, ProgramTrial.of(List.of(program.toString()), 60_000).status());
    }

    @Test
    void oneThatOthersCanChangeIsNotUsed() throws IOException, InterruptedException {
        Path cache = folder.resolve("steward");
        Path program = NativeLauncher.in(cache, SOURCE);
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxrwxrwx"));
        assertNull(NativeLauncher.in(cache, SOURCE));
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwx------"));
        assertEquals(program, NativeLauncher.in(cache, SOURCE));
        Files.setPosixFilePermissions(cache, PosixFilePermissions.fromString("rwxrwxrwx"));
        assertNull(NativeLauncher.in(cache, SOURCE));
    }

    @Test
    void aSourceThatDoesNotCompileGivesNoProgram() throws IOException, InterruptedException {
        Path cache = folder.resolve("steward");
        assertNull(NativeLauncher.in(cache, "int main(".getBytes(StandardCharsets.US_ASCII)));
        try (Stream<Path> files = Files.list(cache)) {
            assertTrue(files.findAny().isEmpty(), "something is left");
        }
    }
}

package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;

/** The program that starts bots is compiled once, and used only if nobody else can change it. */
@Tag("process")
class NativeLauncherTest {

    private static final byte[] SOURCE = "int main(void) { return 125; }\n".getBytes(StandardCharsets.US_ASCII);

    @TempDir
    private Path folder;

    @BeforeEach
    void compiler() {
        assumeTrue(ProgramFinder.find("cc") != null || ProgramFinder.find("gcc") != null, "skipped: no C compiler");
        assumeTrue(Files.isDirectory(Path.of("/proc/self")), "skipped: there is no /proc");
    }

    private static List<Path> listed(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }

    @Test
    void itIsCompiledOnceAndKept() throws IOException, InterruptedException {
        Path cache = folder.resolve("cache/steward");
        Path program = NativeLauncher.in(cache, SOURCE);
        assertEquals(125, ProgramTrial.of(List.of(program.toString()), 60_000).status());
        Object when = Files.getLastModifiedTime(program);
        assertEquals(program, NativeLauncher.in(cache, SOURCE));
        assertEquals(when, Files.getLastModifiedTime(program));
        assertEquals(List.of(program), listed(cache), "what was needed to compile it is left");
    }

    /**
     * A machine that lost power, or a bad disk, can leave something else: nothing (which ends with status 0 and starts
     * none), a beginning, other bytes. It was never compiled again unless it was empty.
     */
    @Test
    void aBrokenOneIsCompiledAgain() throws IOException, InterruptedException {
        Path cache = folder.resolve("steward");
        Path first = NativeLauncher.in(cache, SOURCE);
        byte[] right = Files.readAllBytes(first);
        byte[] bytes = right.clone();
        bytes[bytes.length / 2] ^= 1;
        for (String damage : List.of("empty", "half", "text", "one byte", "not executable")) {
            switch (damage) {
                case "empty" -> Files.write(first, new byte[0]);
                case "half" -> Files.write(first, Arrays.copyOf(right, right.length / 2));
                case "text" -> Files.writeString(first, "exit 125\n");
                case "one byte" -> Files.write(first, bytes);
                default -> Files.setPosixFilePermissions(first, PosixFilePermissions.fromString("rw-------"));
            }
            Path program = NativeLauncher.in(cache, SOURCE);
            assertEquals(first, program, damage);
            assertEquals(125, ProgramTrial.of(List.of(program.toString()), 60_000).status(), damage);
            assertArrayEquals(right, Files.readAllBytes(program), damage);
            assertEquals(List.of(program), listed(cache), damage);
        }
    }

    /** A library that it needs may be gone, or it is of another machine: it is as it was made, and does not run. */
    @Test
    void oneThatDoesNotRunIsCompiledAgain() throws IOException, InterruptedException {
        Path cache = folder.resolve("steward");
        Path right = NativeLauncher.in(cache, SOURCE);
        String name = right.getFileName().toString();
        byte[] other = ("#!" + folder + "/no/interpreter\n").getBytes(StandardCharsets.US_ASCII);
        CRC32 sum = new CRC32();
        sum.update(other);
        Path wrong = cache.resolve(name.substring(0, name.lastIndexOf('-') + 1)
            + String.format("%08x", sum.getValue()));
        Files.move(right, wrong);
        Files.write(wrong, other);
        assertEquals(right, NativeLauncher.in(cache, SOURCE));
        assertFalse(Files.exists(wrong), "the one that does not run is kept");
    }

    /** A launcher that is compiled here, and does not run here, is not used: a shell does the same. */
    @Test
    void aNewOneThatDoesNotRunIsNotUsed() throws IOException, InterruptedException {
        Path cache = folder.resolve("steward");
        assertNull(NativeLauncher.in(cache, "int main(void) { return 0; }\n".getBytes(StandardCharsets.US_ASCII)));
        assertEquals(List.of(), listed(cache));
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
        assertEquals(List.of(), listed(cache));
    }
}

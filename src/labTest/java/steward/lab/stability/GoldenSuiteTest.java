package steward.lab.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The golden hash in its short form, under flags of the JVM. */
@Tag("process")
@Tag("campaign")
@Execution(ExecutionMode.CONCURRENT)
class GoldenSuiteTest {

    private static String golden(String flag) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), flag,
            "-XX:+IgnoreUnrecognizedVMOptions", "-cp", System.getProperty("java.class.path"),
            GoldenSuite.class.getName(), "small").redirectError(ProcessBuilder.Redirect.INHERIT).start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor());
        return out;
    }

    @Test
    void theHashIsTheSameWithoutFusedMultiplyAddAndInterpreted() throws IOException, InterruptedException {
        String usual = golden("-XX:+UseSerialGC");
        assertTrue(usual.lines().allMatch(line -> line.matches("[0-9a-f]{16}  .+")) && usual.endsWith("  all\n"),
            usual);
        assertEquals(usual, golden("-XX:-UseFMA"));
        assertEquals(usual, golden("-Xint"));
    }
}

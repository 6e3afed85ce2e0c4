package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The script that starts the program, with a Java that only prints what it was called with. */
@Tag("process")
class LauncherTest {

    private static final String LINUX = "/proc/self/exe";
    private static final String VFORK = "-Djdk.lang.Process.launchMechanism=VFORK";

    @TempDir
    private Path folder;

    @BeforeEach
    void shell() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Files.createDirectories(folder.resolve("java/bin"));
        Path java = Files.writeString(folder.resolve("java/bin/java"), "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
        assertTrue(java.toFile().setExecutable(true));
    }

    /** @param linux the file by which the script knows Linux */
    private String started(String version, String linux) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("java/release"), "JAVA_VERSION=\"" + version + "\"\n");
        Path script = Files.writeString(folder.resolve("steward"),
            Files.readString(Path.of("src/launcher/steward")).replace(LINUX, linux));
        ProcessBuilder shell = new ProcessBuilder("/bin/sh", script.toString(), "help").redirectErrorStream(true);
        shell.environment().put("JAVA_HOME", folder.resolve("java").toString());
        Process process = shell.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        assertTrue(said.endsWith("steward.cli.Main\nhelp\n"), said);
        return said;
    }

    /** Elsewhere Java knows no VFORK, and could start no bot; from 25 on it warns about it. */
    @Test
    void vforkIsAskedForOnLinuxUpToJava24() throws IOException, InterruptedException {
        String there = Files.createFile(folder.resolve("there")).toString();
        assertTrue(started("17.0.1", there).contains(VFORK));
        assertTrue(started("24", there).contains(VFORK));
        assertEquals(-1, started("25", there).indexOf(VFORK));
        assertEquals(-1, started("17.0.1", folder + "/no/such/file").indexOf(VFORK));
    }
}

package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;

/** Examples of {@code src/examples} that a shell runs as they are; those of the library's page have tests of theirs. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class ExamplesTest {

    @TempDir
    private Path folder;
    private PageShell shell;

    @BeforeEach
    void prepare() throws IOException {
        shell = new PageShell(folder, "");
    }

    private static String example(String name) {
        return CommandLine.quote(List.of(Path.of("src/examples", name).toAbsolutePath().toString()));
    }

    /** Without air a ball that falls h = 100 u at g = 2 arrives at t = 10 and jumps to e^2 h = 64 u, at t = 18. */
    @Test
    void aDroppedBallJumpsToTheSquareOfItsRestitution() throws IOException, InterruptedException {
        String java = CommandLine.quote(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp", System.getProperty("java.class.path")));
        String[] lines = shell.runLine(0, java + " " + example("library/DroppedBall.java")).strip().split("\\R");
        assertEquals(100, lines.length);
        assertEquals(0, gap(lines[9]), 1e-9);
        assertEquals(64, gap(lines[17]), 1e-9);
        assertEquals(0, gap(lines[99]), 1e-9);
    }

    private static double gap(String line) {
        return Double.parseDouble(line.split(" ")[1]);
    }

    @Test
    void aSceneOfOnesOwnBecomesAMovingPicture() throws IOException, InterruptedException {
        shell.runLine(0, "sh " + example("shell/moving-picture.sh"));
        String picture = Files.readString(folder.resolve("corner.svg"));
        assertTrue(picture.startsWith("<svg") && picture.split("<animate").length > 12, "12 discs move");
    }

    @Test
    @Tag("campaign")
    void fiveVersionsPlayALeague() throws IOException, InterruptedException {
        PageShell.need("python3");
        String said = shell.runLine(0, "sh " + example("shell/league-of-five.sh"));
        for (int thrust : new int[] {100, 120, 140, 160, 200}) {
            assertTrue(said.contains(" thrust" + thrust + " "), said);
        }
        assertTrue(said.contains("20 games of mad-pod-racing"), said);
    }
}

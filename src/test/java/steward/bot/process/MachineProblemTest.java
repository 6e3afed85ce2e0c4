package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Answer;
import steward.bot.Player;

/** Trouble of the referee's own machine is no fault of a bot. */
@Tag("process")
class MachineProblemTest {

    /** Run in a JVM of its own, because the folder for temporary files is looked up once. */
    static final class AskOnce {

        private AskOnce() {
        }

        public static void main(String[] arguments) {
            try (BotProcess bot = new BotProcess("sh", List.of("/bin/sh", "-c", "read x; echo y"))) {
                Player.Ending ending = bot.ask(new byte[] {'\n'}, 1, 1, Long.MAX_VALUE, new Answer());
                System.out.println("ended with " + ending);
            } catch (java.io.UncheckedIOException trouble) {
                System.out.println("trouble: " + trouble.getMessage());
            }
        }
    }

    /** Text between the last answer and the exit was once lost. */
    @Test
    void stderrAfterTheLastAnswerIsCollected() {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "skipped: there is no /bin/sh");
        BotProcess bot = new BotProcess("sh",
            List.of("/bin/sh", "-c", "read x; echo y; while read x; do :; done; echo '[PDATA] last = 7' >&2"), 10_000);
        assertEquals(Player.Ending.ANSWERED, bot.ask(new byte[] {'\n'}, 1, 1, Long.MAX_VALUE, new Answer()));
        bot.finish(new byte[] {'e', '\n'}, 2);

        assertEquals("[PDATA] last = 7\n", bot.finalStderr());
    }

    /** Messages of JDK 17 and 25. A machine without processes left was counted as a bot that is not executable. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "Cannot run program \"/a/b\": error=2, No such file or directory | 127",
        "Cannot run program \"/a/b\": error=13, Permission denied | 126",
        "Cannot run program \"/a/b\": error=8, Exec format error | 126",
        "Cannot run program \"/a/b\": Exec failed, error: 2 (No such file or directory)  | 127",
        "Cannot run program \"/a/b\": error=11, Resource temporarily unavailable | 0",
        "Cannot run program \"/a/b\": error=12, Cannot allocate memory | 0",
        "Cannot run program \"/a/b\": error=24, Too many open files | 0",
        "Too many open files | 0"})
    void onlyAProgramThatIsRefusedIsABotsFault(String message, int status) {
        assertEquals(status, StartRefusal.of(message).status());
    }

    /** It was counted as both bots' fault, and a match without a result as a draw. */
    @Test
    void noFolderForTemporaryFilesIsNoFault(@TempDir Path folder) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "skipped: there is no /bin/sh");
        Process child = new ProcessBuilder(JavaProcess.words(List.of("-Djava.io.tmpdir=" + folder.resolve("none")),
            AskOnce.class, List.of()))
            .redirectErrorStream(true).start();
        String said = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertEquals(0, child.waitFor(), said);
        assertTrue(said.contains("trouble: no temporary file for the stderr of sh"), said);
    }
}

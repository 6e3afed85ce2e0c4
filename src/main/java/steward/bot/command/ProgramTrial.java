package steward.bot.command;

import java.io.File;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Whether a program runs here: it is started once, without input, and waited for.
 *
 * @param status of its exit, or {@value #NONE} if it did not start or did not end in time
 * @param line   the first line that is not blank of what it wrote to stdout or stderr; empty for none
 */
public record ProgramTrial(int status, String line) {

    private static final int NONE = -1;
    private static final Path NOTHING = Path.of("/dev/null");

    /** Whether it ended with status 0. */
    public boolean works() {
        return status == 0;
    }

    /** @param patienceMs after which it is killed, in milliseconds */
    public static ProgramTrial of(List<String> command, long patienceMs) throws InterruptedException {
        Path output = null;
        try {
            output = Files.createTempFile("steward-", ".txt");
            File file = output.toFile();
            Process process = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(file)
                .redirectInput(Files.exists(NOTHING) ? Redirect.from(NOTHING.toFile()) : Redirect.PIPE).start();
            if (!process.waitFor(patienceMs, TimeUnit.MILLISECONDS)) {
                process.descendants().forEach(ProcessHandle::destroyForcibly);
                process.destroyForcibly();
                return new ProgramTrial(NONE, "did not end within " + patienceMs + " ms");
            }
            String text = new String(Files.readAllBytes(output), StandardCharsets.UTF_8);
            return new ProgramTrial(process.exitValue(),
                text.lines().filter(line -> !line.isBlank()).findFirst().orElse("").strip());
        } catch (IOException problem) {
            return new ProgramTrial(NONE, String.valueOf(problem.getMessage()));
        } finally {
            delete(output);
        }
    }

    private static void delete(Path file) {
        try {
            if (file != null) {
                Files.deleteIfExists(file);
            }
        } catch (IOException kept) {
            file.toFile().deleteOnExit();
        }
    }
}

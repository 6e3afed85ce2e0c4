package steward.bot.command;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Trial of a program on this machine: it is started once, without input, and its end awaited.
 *
 * @param status of its exit, or {@value #NONE} if it did not start or did not end in time
 * @param line   the first line that is not blank of what it wrote to stdout or stderr; empty for none
 */
public record ProgramTrial(int status, String line) {

    private static final int NONE = -1;
    /** Bytes of the output that are kept. */
    private static final int KEPT = 1 << 16;
    /** How often the output is read, in milliseconds: a program whose pipe is full waits so long. */
    private static final long LOOK_MS = 10;
    private static final Path NOTHING = Path.of("/dev/null");

    /** True if it ended with status 0. */
    public boolean works() {
        return status == 0;
    }

    /** @param patienceMs after which it is killed, in milliseconds */
    public static ProgramTrial of(List<String> command, long patienceMs) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true)
                .redirectInput(Files.exists(NOTHING) ? Redirect.from(NOTHING.toFile()) : Redirect.PIPE).start();
            ByteArrayOutputStream said = new ByteArrayOutputStream();
            long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(patienceMs);
            while (!process.waitFor(LOOK_MS, TimeUnit.MILLISECONDS)) {
                read(process.getInputStream(), said);
                if (System.nanoTime() >= end) {
                    process.descendants().forEach(ProcessHandle::destroyForcibly);
                    process.destroyForcibly();
                    return new ProgramTrial(NONE, "did not end within " + patienceMs + " ms");
                }
            }
            read(process.getInputStream(), said);
            return new ProgramTrial(process.exitValue(), said.toString(StandardCharsets.UTF_8).lines()
                .filter(line -> !line.isBlank()).findFirst().orElse("").strip());
        } catch (IOException problem) {
            return new ProgramTrial(NONE, String.valueOf(problem.getMessage()));
        }
    }

    /**
     * Reads what is there, and keeps the beginning. Never waits: a process that the program has started may hold the
     * pipe.
     */
    private static void read(InputStream from, ByteArrayOutputStream said) throws IOException {
        for (int count = from.available(); count > 0; count = from.available()) {
            byte[] bytes = from.readNBytes(count);
            said.write(bytes, 0, Math.min(bytes.length, Math.max(0, KEPT - said.size())));
        }
    }
}

package steward.lab.bench.section;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.ProcessBuilder.Redirect;
import java.util.List;
import steward.bot.process.BotProcess;

/**
 * Baseline for measuring {@link BotProcess}: a program that answers each line with a line over bare pipes, without
 * deadline, limit, group or stderr.
 */
final class PipeRoundTrip implements AutoCloseable {

    private final Process process;
    private final OutputStream input;
    private final InputStream output;
    private final byte[] buffer = new byte[1 << 13];

    /** @throws IOException if the program cannot be started */
    PipeRoundTrip(List<String> command) throws IOException {
        process = new ProcessBuilder(command).redirectError(Redirect.DISCARD).start();
        input = process.getOutputStream();
        output = process.getInputStream();
    }

    /**
     * Sends lines and waits for one line.
     *
     * @throws IOException if the program has ended
     */
    void exchange(byte... lines) throws IOException {
        input.write(lines);
        input.flush();
        int came;
        do {
            came = output.read(buffer);
            if (came <= 0) {
                throw new EOFException("the program has ended");
            }
        } while (buffer[came - 1] != '\n');
    }

    /** Closes its input and waits for it to exit. */
    @Override
    public void close() {
        try (input; output) {
            input.close();
            process.waitFor();
        } catch (IOException gone) {
            process.destroyForcibly();
        } catch (InterruptedException interrupted) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}

package steward.bot.process;

import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import steward.bot.isolation.Launch;

/** Single run of a program, without input and with its output in files. */
public final class ProgramRun {

    private ProgramRun() { }

    /**
     * Runs a program.
     *
     * @param patienceMs after which it is killed, in milliseconds
     * @return its exit status; empty if it was killed
     */
    public static OptionalInt of(Launch launch, Path stdout, Path stderr, long patienceMs)
            throws IOException, InterruptedException {
        Process process = launch.builder(null, null).redirectOutput(stdout.toFile()).redirectError(stderr.toFile())
            .start();
        process.getOutputStream().close();
        if (process.waitFor(patienceMs, TimeUnit.MILLISECONDS)) {
            return OptionalInt.of(process.exitValue());
        }
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly().waitFor();
        return OptionalInt.empty();
    }
}

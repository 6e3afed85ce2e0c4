package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/** Bots as contestants write them, from resources, made ready in a folder; absent without their language. */
record ContestantPrograms(String resources, Path folder) {

    /** The command of a bot, by the ending of its source. */
    Optional<List<String>> command(String source) throws IOException, InterruptedException {
        Path file = folder.resolve(source);
        try (InputStream in = ContestantPrograms.class.getResourceAsStream("/" + resources + "/" + source)) {
            assertNotNull(in, source);
            Files.copy(in, file);
        }
        if (source.endsWith(".py")) {
            return isThere("python3", "-c", "import math, sys") ? Optional.of(List.of("python3", file.toString()))
                : Optional.empty();
        }
        if (source.endsWith(".cpp")) {
            String program = folder.resolve("program").toString();
            boolean isCompiled = isThere("g++", "-O1", "-o", program, file.toString());
            assertEquals(isThere("g++", "--version"), isCompiled, source);
            return isCompiled ? Optional.of(List.of(program)) : Optional.empty();
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            return Optional.empty();
        }
        assertEquals(0, compiler.run(null, null, null, "-d", folder.toString(), file.toString()));
        return Optional.of(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", folder.toString(), "Player"));
    }

    /** True if a program is there and ends well. */
    private static boolean isThere(String... command) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
            process.getOutputStream().close();
            process.getInputStream().readAllBytes();
            return process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException notInstalled) {
            return false;
        }
    }
}

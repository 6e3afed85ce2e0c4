package steward.lab.timing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** The machine of a measurement: processor, cores, system, JDK. */
public final class Machine {

    private static final Path LINUX = Path.of("/proc/cpuinfo");

    private Machine() { }

    /** A readable line. */
    public static String line() {
        int cores = Runtime.getRuntime().availableProcessors();
        return processor() + ", " + cores + (cores == 1 ? " core, " : " cores, ") + System.getProperty("os.name")
            + ", JDK " + System.getProperty("java.version") + " ("
            + System.getProperty("java.vm.name") + ")";
    }

    private static String processor() {
        try (Stream<String> lines = Files.lines(LINUX, StandardCharsets.UTF_8)) {
            return lines.filter(line -> line.startsWith("model name")).map(line -> line.replaceFirst("[^:]*:\\s*", ""))
                .findFirst().orElse(System.getProperty("os.arch"));
        } catch (IOException | RuntimeException elsewhere) {
            return System.getProperty("os.arch");
        }
    }
}

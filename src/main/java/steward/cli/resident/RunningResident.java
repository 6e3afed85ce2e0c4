package steward.cli.resident;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Running resident referee of this user, found through {@code /proc}.
 *
 * @param folder    the folder whose matches it plays
 * @param megabytes its memory
 */
public record RunningResident(long pid, String folder, long megabytes) {

    private static final Path PROCESSES = Path.of("/proc");
    private static final String MEMORY = "VmRSS:";
    private static final long KILOBYTES = 1024;

    /** All of them; none where the system does not tell. */
    public static List<RunningResident> all() {
        List<RunningResident> found = new ArrayList<>();
        try (DirectoryStream<Path> processes = Files.newDirectoryStream(PROCESSES, "[0-9]*")) {
            Object user = Files.getOwner(PROCESSES.resolve("self"));
            for (Path process : processes) {
                RunningResident resident = of(process, user);
                if (resident != null) {
                    found.add(resident);
                }
            }
        } catch (IOException unknown) {
            return List.of();
        }
        return found;
    }

    /** The resident that a process is, or {@code null}. */
    private static RunningResident of(Path process, Object user) {
        try {
            List<String> words = Arrays.asList(read(process, "cmdline").split("\0"));
            int socket = words.indexOf("--socket");
            if (socket < 1 || !words.get(socket - 1).equals("resident") || !Files.getOwner(process).equals(user)) {
                return null;
            }
            String memory = read(process, "status").lines().filter(line -> line.startsWith(MEMORY)).findFirst()
                .map(line -> line.replaceAll("\\D", "")).orElse("0");
            return new RunningResident(Long.parseLong(process.getFileName().toString()),
                Files.readSymbolicLink(process.resolve("cwd")).toString(), Long.parseLong(memory) / KILOBYTES);
        } catch (IOException ended) {
            return null;
        }
    }

    private static String read(Path process, String file) throws IOException {
        return Files.readString(process.resolve(file), StandardCharsets.ISO_8859_1);
    }
}

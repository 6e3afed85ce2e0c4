package steward.lab.bench.section;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import steward.files.Folders;
import steward.lab.timing.Stretch;

/**
 * Games under cg-brutaltester, in a folder of their own with two compiled bots. CPU time is counted by Linux, in ticks
 * of 10 ms. It is that of programs that this JVM has started and that have ended, with their children; and that of the
 * resident referee, which is nobody's child.
 */
final class ToolGames implements AutoCloseable {

    private static final Path PROCESSES = Path.of("/proc");
    private static final double NANOS_PER_TICK = 1e7;
    /** Fields of {@code /proc/PID/stat} behind the name in parentheses: utime, stime, cutime, cstime. */
    private static final int OWN_TICKS = 11;
    private static final int CHILDREN_TICKS = 13;
    private static final int END_OF_TICKS = 15;
    /** Files in the folder of tools: the tool, and the referee which ours is compared with. */
    static final List<String> FILES = List.of("cg-brutaltester.jar", "csbref");

    private final Path folder = Files.createTempDirectory("steward-");     // short: a socket is in it
    /** By referee, so that all play the games with the same seeds. */
    private final int[] seeds = new int[Referee.values().length];

    /** Referees; that in Go is the one the others are compared with. */
    enum Referee {
        IN_GO("Go referee", "./csbref"), PLAIN("steward", "./steward referee"),
        COLD("resident, its start included", "./steward-referee"), WARM("resident", COLD.call);

        private final String word;
        private final String call;

        Referee(String word, String call) {
            this.word = word;
            this.call = call;
        }

        String word() {
            return word;
        }
    }

    /** @param launcher the installed program, or {@code null} */
    ToolGames(List<String> launcher, Path tools) throws IOException, InterruptedException {
        if (launcher == null) {
            throw new IOException("found no launcher, expected the installed program");
        }
        Path steward = Path.of(launcher.get(0)).toRealPath();
        for (Path file : List.of(steward, steward.resolveSibling("steward-referee"), tools.resolve(FILES.get(0)),
                tools.resolve(FILES.get(1)))) {
            Files.createSymbolicLink(folder.resolve(file.getFileName()), file.toRealPath());
        }
        run("./steward new cpp bot && g++ -O2 -o mine bot/bot.cpp && cp mine other");
    }

    /** Measures the CPU time of a game, with or without the start of the resident. */
    Stretch play(Referee referee, int games) throws IOException, InterruptedException {
        seeds[referee.ordinal()]++;
        if (referee == Referee.COLD) {
            endResident();
        } else if (referee == Referee.WARM && residents().isEmpty()) {
            nanos(referee, 1);
        }
        return new Stretch(nanos(referee, games), Double.NaN);
    }

    private double nanos(Referee referee, int games) throws IOException, InterruptedException {
        String call = "java -jar cg-brutaltester.jar" + (referee == Referee.IN_GO ? " -o" : "") + " -r '" + referee.call
            + "' -p1 ./mine -p2 ./other -n " + games + " -i " + seeds[referee.ordinal()];
        double before = ticks();
        List<String> said = run(call);
        double spent = ticks() - before;
        long played = said.stream().filter(line -> line.contains("End of game ")).count();
        if (played < games) {
            throw new IOException("cg-brutaltester has played " + played + " games of " + games + ", and said: "
                + String.join(" ", said));
        }
        return spent * NANOS_PER_TICK / played;
    }

    private List<String> run(String call) throws IOException, InterruptedException {
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", call).directory(folder.toFile());
        Map<String, String> environment = shell.environment();
        environment.put("XDG_RUNTIME_DIR", folder.toString());
        environment.put("LC_ALL", "C.UTF-8");
        Path said = folder.resolve("said");
        Process process = shell.redirectErrorStream(true).redirectOutput(Redirect.to(said.toFile())).start();
        try {
            int status = process.waitFor();
            List<String> lines = Files.readAllLines(said, StandardCharsets.ISO_8859_1);
            if (status != 0) {
                throw new IOException("'" + call + "' ended with status " + status + ": " + String.join(" ", lines));
            }
            return lines;
        } finally {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
    }

    private double ticks() throws IOException {
        double sum = ticks(PROCESSES.resolve("self"), CHILDREN_TICKS);
        for (Path process : residents()) {
            sum += ticks(process, OWN_TICKS);
        }
        return sum;
    }

    private static double ticks(Path process, int from) throws IOException {
        String stat = Files.readString(process.resolve("stat"), StandardCharsets.ISO_8859_1);
        String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
        return IntStream.range(from, END_OF_TICKS).mapToLong(k -> Long.parseLong(fields[k])).sum();
    }

    /** Residents, by the path of their socket, which is in this folder. */
    private List<Path> residents() throws IOException {
        List<Path> found = new ArrayList<>();
        try (DirectoryStream<Path> processes = Files.newDirectoryStream(PROCESSES, "[0-9]*")) {
            for (Path process : processes) {
                List<String> words = words(process);
                int socket = words.indexOf("--socket") + 1;
                if (socket > 0 && socket < words.size() && words.get(socket).startsWith(folder + "/")) {
                    found.add(process);
                }
            }
        }
        return found;
    }

    private static List<String> words(Path process) {
        try {
            return Arrays.asList(Files.readString(process.resolve("cmdline"), StandardCharsets.ISO_8859_1).split("\0"));
        } catch (IOException ended) {
            return List.of();
        }
    }

    /** Ends the resident, if there is one, and waits for its end. */
    void endResident() throws IOException {
        for (Path process : residents()) {
            ProcessHandle.of(Long.parseLong(process.getFileName().toString())).ifPresent(each -> {
                each.destroy();
                each.onExit().join();
            });
        }
    }

    @Override
    public void close() throws IOException {
        endResident();
        Folders.delete(folder);
    }
}

package steward.hostile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.Main;

/**
 * Ends a series of matches at random moments, by SIGKILL, SIGTERM and SIGINT, and looks at what is left: no process and
 * no temporary file, and replays that all verify up to their cut. Prints a row for each signal and level. Exit status 1
 * if anything is left or does not verify.
 *
 * <p>{@code --times N} (200) is how often each signal is sent, {@code --seed S} (17) chooses the moments, and
 * {@code --signals KILL,TERM} some of the signals. SIGINT is skipped where this process, and so what it starts, ignores
 * it: a shell starts what runs in the background so.
 */
public final class KilledSeries {

    private static final String HEAD = "%-7s %-7s %5s  %9s %5s  %7s %5s %7s %6s  %-18s %s%n";

    /** The latest moment, in milliseconds after the start of the JVM, or after the first replay was made. */
    private static final int LATEST_MS = 1500;
    /** For the first replay. */
    private static final int PATIENCE_MS = 60_000;

    private final Path work;
    private final Programs programs;
    private final List<String> problems = new ArrayList<>();

    private KilledSeries(Path work) {
        this.work = work;
        programs = new Programs(work);
    }

    /** Findings after a signal at one level. */
    private static final class Row {
        private int rounds;
        private int processes;
        private int files;
        private int replays;
        private int whole;
        private int cut;
        private int empty;
        private long longestMs;
        private final TreeMap<Integer, Integer> statuses = new TreeMap<>();
    }

    /** Reads the options, plays, prints. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        List<String> options = List.of(arguments);
        int times = option(options, "--times", 200);
        SplittableRandom random = new SplittableRandom(option(options, "--seed", 17));
        KilledSeries series = new KilledSeries(Files.createTempDirectory("killed-"));
        System.out.printf(HEAD, "signal", "level", "times", "processes", "files", "replays", "whole", "cut at", "empty",
            "exit status", "gone after");
        List<SandboxLevel> levels = Stream.of(SandboxLevel.values())
            .filter(level -> SandboxSupport.problem(level) == null).toList();
        int signals = options.indexOf("--signals");
        List<String> chosen = List.of((signals < 0 ? "KILL,TERM,INT" : options.get(signals + 1)).split(","));
        for (String signal : chosen) {
            if (signal.equals("INT") && ignoresInterrupts()) {
                System.out.println("INT is skipped: this process ignores it");
                continue;
            }
            for (SandboxLevel level : levels) {
                Row row = new Row();
                int first = levels.indexOf(level);
                for (int round = first; round < times; round += levels.size()) {
                    // By turns from the start on, and while it surely plays, however slow the machine is.
                    boolean playing = round / levels.size() % 2 == 1;
                    series.round(signal, level, playing, (playing ? 0 : 100) + random.nextInt(LATEST_MS), row);
                }
                System.out.printf(HEAD, signal, level.word(), row.rounds, row.processes, row.files, row.replays,
                    row.whole, row.cut, row.empty, row.statuses, row.longestMs + " ms");
            }
        }
        series.problems.forEach(problem -> System.out.println("PROBLEM: " + problem));
        System.out.println(series.problems.size() + " problems");
        System.exit(series.problems.isEmpty() ? 0 : 1);
    }

    static int option(List<String> options, String name, int otherwise) {
        int place = options.indexOf(name);
        return place < 0 ? otherwise : Integer.parseInt(options.get(place + 1));
    }

    private static boolean ignoresInterrupts() throws IOException {
        return Files.readAllLines(Path.of("/proc/self/status")).stream().filter(line -> line.startsWith("SigIgn:"))
            .anyMatch(line -> (Long.parseUnsignedLong(line.substring("SigIgn:".length()).strip(), 16) & 2) != 0);
    }

    private void round(String signal, SandboxLevel level, boolean playing, int millis, Row row) throws IOException,
            InterruptedException {
        String mark = "killed" + Long.toUnsignedString(System.nanoTime(), 36);
        Path temporary = Files.createDirectory(work.resolve(mark));
        Path replays = Files.createDirectory(work.resolve(mark + "-replays"));
        List<String> words = JavaProcess.words(List.of("-Djava.io.tmpdir=" + temporary), Main.class, List.of("match",
            "--scene", "duel", "--games", "2000", "--threads", "2", "--no-deadline", "--sandbox", level.word(),
            "--quiet", "--out", replays.toString(), "--bot", programs.honest(mark), "--bot", programs.honest(mark)));
        Process process = new ProcessBuilder(words).redirectErrorStream(true)
            .redirectOutput(work.resolve("out").toFile()).start();
        for (int waited = 0; playing && waited < PATIENCE_MS && replays.toFile().list().length == 0; waited++) {
            process.waitFor(1, TimeUnit.MILLISECONDS);
        }
        process.waitFor(millis, TimeUnit.MILLISECONDS);
        new ProcessBuilder("kill", "-s", signal, "" + process.pid()).start().waitFor();
        long sent = System.nanoTime();
        if (!process.waitFor(1, TimeUnit.MINUTES)) {
            problems.add(signal + ", " + level.word() + ": the referee does not end after " + millis + " ms");
            process.destroyForcibly();
        }
        String when = signal + " after " + millis + " ms" + (playing ? " of play, " : ", ") + level.word() + ": ";
        row.rounds++;
        row.statuses.merge(process.waitFor(), 1, Integer::sum);
        // The sentinel has the folder for temporary files in its command line, and so the mark.
        if (!Machine.await(() -> Machine.marked(mark).isEmpty())) {
            row.processes += Machine.marked(mark).size();
            problems.add(when + "processes are left: " + Machine.marked(mark));
            Machine.end(mark);
        }
        row.longestMs = Math.max(row.longestMs, TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - sent));
        String[] files = temporary.toFile().list();
        if (files.length > 0) {
            row.files += files.length;
            problems.add(when + "files are left: " + List.of(files));
        }
        try (Stream<Path> all = Files.list(replays)) {
            all.sorted().forEach(replay -> verify(replay, when, row));
        }
    }

    private void verify(Path replay, String when, Row row) {
        row.replays++;
        try {
            if (Files.size(replay) == 0) {
                row.empty++;                           // killed between the call that makes it and that which writes
                if (row.empty > 1 || !when.startsWith("KILL")) {
                    problems.add(when + replay.getFileName() + " is empty");
                }
                Files.delete(replay);
                return;
            }
            List<String> call = List.of("replay", replay.toString(), "--verify", "--quiet");
            boolean isWhole = Cli.run(call).status() == 0;
            Cli partial = Cli.run(call, "--partial");
            boolean verified = isWhole || partial.status() == 0;
            row.whole += isWhole ? 1 : 0;
            row.cut += !isWhole && verified ? 1 : 0;
            if (!verified) {
                problems.add(when + replay.getFileName() + " does not verify: " + partial.out() + partial.err());
            } else {
                Files.delete(replay);
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }
}

package steward.hostile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.cli.Cli;

/**
 * Plays thousands of quick matches between two programs in one JVM and prints how many threads, descriptors and files
 * there are after each tenth of them, and how much memory is in use after a collection. Exit status 1 unless all are
 * flat from the second tenth on.
 *
 * <p>{@code --matches N} (20,000) is how many. To be run with {@code -Xmx48m}.
 */
public final class Soak {

    private static final int PARTS = 10;
    private static final String ROW = "%7s %8s %12s %6s %14s%n";

    /** The JDK closes its ends of pipes a little later; class loading may have opened a file. */
    private static final int MORE_DESCRIPTORS = 5;
    /** Threads that wait for work may be one more or less. */
    private static final int MORE_THREADS = 4;
    /** Compiled code and caches of the JDK: far less than a kilobyte for each match would be. */
    private static final long MORE_BYTES = 3 << 20;

    private Soak() {
    }

    private record Sample(int threads, int descriptors, int files, long bytes) {

        static Sample now(Path temporary) {
            System.gc();
            Runtime runtime = Runtime.getRuntime();
            return new Sample(Thread.activeCount(), Machine.descriptors(), Machine.temporaryFiles(temporary).size(),
                runtime.totalMemory() - runtime.freeMemory());
        }

        boolean isFlat(Sample before) {
            return threads <= before.threads + MORE_THREADS && descriptors <= before.descriptors + MORE_DESCRIPTORS
                && files <= before.files && bytes <= before.bytes + MORE_BYTES;
        }
    }

    /** Reads the option, plays, prints. */
    public static void main(String[] arguments) throws IOException {
        int matches = KilledSeries.option(List.of(arguments), "--matches", 20_000);
        Path temporary = Path.of(System.getProperty("java.io.tmpdir"));
        Path work = Files.createTempDirectory("soak-");
        Programs programs = new Programs(work);
        Path scene = work.resolve("quick.json");
        Files.writeString(scene, Files.readString(Path.of("config/scenes/duel.json"))
            .replaceFirst("\"maximumTurns\": [0-9]+", "\"maximumTurns\": 5"));
        System.out.printf(ROW, "matches", "threads", "descriptors", "files", "memory, bytes");
        List<Sample> samples = new ArrayList<>();
        boolean flat = true;
        for (int part = 1; part <= PARTS; part++) {
            play(matches / PARTS, part, scene, programs);
            Sample sample = Sample.now(temporary);
            samples.add(sample);
            System.out.printf(ROW, part * (matches / PARTS), sample.threads(), sample.descriptors(), sample.files(),
                sample.bytes());
            flat &= part <= 2 || sample.isFlat(samples.get(1));
        }
        System.out.println(flat ? "flat" : "PROBLEM: not flat");
        System.exit(flat ? 0 : 1);
    }

    private static void play(int matches, int seed, Path scene, Programs programs) {
        Cli played = Cli.run("match", "--scene", scene.toString(), "--games", "" + matches, "--threads", "2",
            "--no-deadline", "--seed", "" + seed, "--quiet", "--bot", programs.honest("a"), "--bot",
            programs.honest("b"));
        if (played.status() != 0) {
            throw new IllegalStateException(played.toString());
        }
    }
}

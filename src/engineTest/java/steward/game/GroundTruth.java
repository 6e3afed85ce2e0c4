package steward.game;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.TestReporter;

/**
 * Folders of what official referees did, read where they lie: a root with one folder per game. Tests of it are skipped,
 * saying so, where there is none.
 */
public enum GroundTruth {

    /** Matches of published referees at full precision. */
    VECTORS("steward.vectors", "../shared/vectors"),
    /** Games of the server, as it shows them. */
    RECORDINGS("steward.recordings", "../shared/recordings");

    /** The first game, whose folder could be named itself before there were others. */
    private static final String FIRST = "pod-race";
    /** System property that is true if the call of the build names a folder. */
    private static final String TELL = "steward.tell";

    private final String property;
    private final String usual;

    GroundTruth(String property, String usual) {
        this.property = property;
        this.usual = usual;
    }

    /** The files of a game whose names end in one of these ways, in the order of their names. */
    public List<Path> files(String game, String... endings) throws IOException {
        Path root = Path.of(System.getProperty(property, usual));
        Path own = root.resolve(game);
        Path folder = Files.isDirectory(own) || !game.equals(FIRST) ? own : root;
        assumeTrue(Files.isDirectory(folder),
            () -> "skipped: no folder of " + property.replace("steward.", "") + ", -P" + property + "=FOLDER");
        try (Stream<Path> files = Files.list(folder)) {
            List<Path> named = files.filter(file -> Arrays.stream(endings).anyMatch(file.toString()::endsWith))
                .sorted().toList();
            assumeTrue(!named.isEmpty(), () -> "skipped: no " + String.join(" or ", endings) + " in "
                + folder.toAbsolutePath());
            return named;
        }
    }

    /** Matches of a game: of the folder that the call of the build names, or those of the sample in this project. */
    public static List<Path> matches(String game) throws IOException {
        if (Boolean.getBoolean(TELL)) {
            return VECTORS.files(game, ".jsonl.gz");
        }
        try (Stream<Path> files = Files.list(sample(game))) {
            return files.sorted().toList();
        }
    }

    /** A file or folder of the sample in this project; fails where it is missing. */
    public static Path sample(String name) {
        try {
            return Path.of(GroundTruth.class.getResource("/truth/" + name).toURI());
        } catch (URISyntaxException problem) {
            throw new IllegalStateException(problem);
        }
    }

    /** A file of the folder of official recordings of the pod race. */
    public static Path replay(String name) {
        Path file = Path.of(System.getProperty("steward.replays", "../shared/replays")).resolve(name);
        assumeTrue(Files.isRegularFile(file), "skipped: no folder of replays, -Psteward.replays=FOLDER");
        return file;
    }

    /** The text of a file, which may be compressed. */
    public static String text(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file);
             InputStream text = file.toString().endsWith(".gz") ? new GZIPInputStream(in) : in) {
            return new String(text.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** Reports what was compared; on the console too if the call of the build named a folder. */
    public static void tell(TestReporter report, String line) {
        report.publishEntry(line);
        if (Boolean.getBoolean(TELL)) {
            System.out.println(line);
        }
    }

    /** Report of what was compared, file by file, told as it comes. */
    public static final class Report {

        private final TestReporter to;
        private final String game;
        private final List<String> differences = new ArrayList<>();
        private long values;

        public Report(TestReporter to, String game) {
            this.to = to;
            this.game = game;
        }

        /** @param difference the first, or {@code null} */
        public void add(String file, int turns, long compared, String difference, List<String> notCompared) {
            values += compared;
            if (difference != null) {
                differences.add(file + ": " + difference);
            }
            tell(to, game + ", " + file + ": " + turns + " turns, " + compared + " values, first difference: "
                + (difference == null ? "none" : difference)
                + (notCompared.isEmpty() ? "" : "; not compared: " + String.join("; ", notCompared)));
        }

        /** Number of values of all files. */
        public long values() {
            return values;
        }

        /** The first of each file that has one. */
        public List<String> differences() {
            return differences;
        }
    }
}

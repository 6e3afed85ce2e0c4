package steward.game;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
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

    private final String property;
    private final String usual;

    GroundTruth(String property, String usual) {
        this.property = property;
        this.usual = usual;
    }

    /** The files of a game whose names end so, in the order of their names. */
    public List<Path> files(String game, String ending) throws IOException {
        Path root = Path.of(System.getProperty(property, usual));
        Path own = root.resolve(game);
        Path folder = Files.isDirectory(own) || !game.equals(FIRST) ? own : root;
        assumeTrue(Files.isDirectory(folder),
            () -> "skipped: no folder " + folder.toAbsolutePath() + " (set -P" + property + ")");
        try (Stream<Path> files = Files.list(folder)) {
            List<Path> named = files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
            assumeTrue(!named.isEmpty(), () -> "skipped: no " + ending + " in " + folder.toAbsolutePath());
            return named;
        }
    }

    /** Reports what was compared; on the console too if the call of the build named a folder. */
    public static void tell(TestReporter report, String line) {
        report.publishEntry(line);
        if (Boolean.getBoolean("steward.tell")) {
            System.out.println(line);
        }
    }
}

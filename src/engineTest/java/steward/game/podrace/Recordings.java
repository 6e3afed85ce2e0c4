package steward.game.podrace;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;

/** Official recordings: where they are, how they are read, and the race they are compared with. */
public final class Recordings {

    /** A command whose thrust is one of the pseudo-thrusts of {@link PodRace}, or 0..200. */
    public record Command(double x, double y, int thrust) {
    }

    /** One round of a game of 2016: four states, four commands, four states. Rows are the recording's columns. */
    public record Round(double[][] before, Command[] commands, double[][] after) {
    }

    /** A whole game of 2016. */
    public record Recording(String name, double[][] checkpoints, List<Round> rounds) {
    }

    private Recordings() {
    }

    /** The folder of recordings; the test is skipped, saying so, where there is none. */
    static Path folder() {
        Path folder = Path.of(System.getProperty("steward.replays", "../shared/replays"));
        assumeTrue(Files.isDirectory(folder), "skipped: no folder of replays, -Psteward.replays=FOLDER");
        return folder;
    }

    public static List<Recording> all() {
        try (Stream<Path> files = Files.list(folder())) {
            List<Path> named = files.filter(file -> file.getFileName().toString().startsWith("replay_")).sorted()
                .toList();
            assumeTrue(!named.isEmpty(), () -> "skipped: no replay_* in " + folder().toAbsolutePath());
            return named.stream().map(Recordings::read).toList();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    static List<String> lines(Path file) {
        try {
            return Files.readAllLines(file);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private static Recording read(Path file) {
        double[][] checkpoints = null;
        List<Round> rounds = new ArrayList<>();
        List<double[]> before = new ArrayList<>();
        List<Command> commands = new ArrayList<>();
        List<double[]> after = new ArrayList<>();
        for (String line : lines(file)) {
            String[] words = line.trim().split(" +");
            switch (words[0]) {
                case "CHECKPOINTS" -> checkpoints = points(Arrays.copyOfRange(words, 1, words.length));
                case "IN" -> before.add(numbers(words));
                case "MOV" -> commands.add(command(words[1], words[2], words[3]));
                case "OUT" -> {
                    after.add(numbers(words));
                    if (after.size() == 4) {
                        rounds.add(new Round(before.toArray(new double[0][]), commands.toArray(new Command[0]),
                            after.toArray(new double[0][])));
                        before.clear();
                        commands.clear();
                        after.clear();
                    }
                }
                default -> { }
            }
        }
        return new Recording(file.getFileName().toString(), checkpoints, rounds);
    }

    static Command command(String x, String y, String thrust) {
        int power = switch (thrust) {
            case "SHIELD" -> PodRace.SHIELD;
            case "BOOST" -> PodRace.BOOST;
            default -> Integer.parseInt(thrust);
        };
        return new Command(Double.parseDouble(x), Double.parseDouble(y), power);
    }

    private static double[] numbers(String[] words) {
        return Arrays.stream(words, 1, words.length).mapToDouble(Double::parseDouble).toArray();
    }

    private static double[][] points(String[] words) {
        double[][] points = new double[words.length / 2][];
        for (int k = 0; k < points.length; k++) {
            points[k] = new double[] {Double.parseDouble(words[2 * k]), Double.parseDouble(words[2 * k + 1])};
        }
        return points;
    }

    /** The shipped official scene, which has the rules of the live server. */
    public static PodRaceType.PodRaceSetup official() {
        return (PodRaceType.PodRaceSetup) TestScenes.open("mad-pod-racing");
    }

    /** Returns the scene with the rules of the contest of 2016. */
    public static PodRaceType.PodRaceSetup contest() {
        return (PodRaceType.PodRaceSetup) TestScenes.contest("mad-pod-racing");
    }
}

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
import steward.game.podrace.simulator.PodCommands;
import steward.match.TestScenes;
import steward.physics.Impact;

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
                case "CHECKPOINTS" -> checkpoints = map(words);
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

    public static Command command(String x, String y, String thrust) {
        int power = switch (thrust) {
            case "SHIELD" -> PodRace.SHIELD;
            case "BOOST" -> PodRace.BOOST;
            default -> Integer.parseInt(thrust);
        };
        return new Command(Double.parseDouble(x), Double.parseDouble(y), power);
    }

    /** Commands of all pods for a simulator. */
    public static PodCommands commands(Command... of) {
        PodCommands commands = new PodCommands(of.length);
        for (int pod = 0; pod < of.length; pod++) {
            commands.set(pod, of[pod].x(), of[pod].y(), of[pod].thrust());
        }
        return commands;
    }

    private static double[] numbers(String[] words) {
        return Arrays.stream(words, 1, words.length).mapToDouble(Double::parseDouble).toArray();
    }

    /** The map of a line: places behind its first word. */
    public static double[][] map(String[] words) {
        double[][] map = new double[words.length / 2][];
        Arrays.setAll(map, k -> new double[] {Double.parseDouble(words[1 + 2 * k]),
            Double.parseDouble(words[2 + 2 * k])});
        return map;
    }

    /** Rows of four pods in a line, from a word on: x, y, vx, vy, heading, shield, next checkpoint. */
    public static double[][] rows(String[] words, int from) {
        double[][] rows = new double[4][7];
        for (int k = 0; k < 4 * 7; k++) {
            String word = words[from + k];
            rows[k / 7][k % 7] = word.equals("null") ? Double.NaN : Double.parseDouble(word);
        }
        return rows;
    }

    /** Numbers of an impact as a line tells them: time a ax ay b bx by impulse, then its mean velocity. */
    static double[] numbers(Impact impact) {
        return new double[] {impact.time(), impact.a(), Math.round(impact.ax()), Math.round(impact.ay()), impact.b(),
            Math.round(impact.bx()), Math.round(impact.by()), impact.impulse(),
            Math.round((impact.vaxBefore() + impact.vbxBefore()) / 2),
            Math.round((impact.vayBefore() + impact.vbyBefore()) / 2)};
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

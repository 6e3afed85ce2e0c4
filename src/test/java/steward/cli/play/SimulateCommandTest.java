package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.Timeout;
import steward.bot.process.JavaProcess;
import steward.cli.Main;
import steward.cli.ProcessTest;
import steward.cli.shared.ExitStatus;

/**
 * {@code steward simulate} as a process of its own, driven over pipes like the community's script: official recordings
 * of 2016 go in, test by test, and the values that come back are counted.
 */
@Timeout(120)
class SimulateCommandTest {

    private static final int PODS = 4;
    private static final int COLUMNS = 8;
    private static final int ANGLE = 4;
    private static final int NEXT_CHECKPOINT = 5;
    /** Recorded headings are decimals of radians that went on unrounded: what that loses in a turn, in degrees. */
    private static final double ANGLE_TOLERANCE = 1e-9;

    /** The rows of a recording without their first words. */
    private record Recording(String name, List<String> checkpoints, List<String> in, List<String> moves,
                             List<String> out) {

        int tests() {
            return in.size() / PODS;
        }
    }

    private static List<Recording> recordings() {
        Path folder = Path.of(System.getProperty("steward.replays", "../shared/replays"));
        assumeTrue(Files.isDirectory(folder), "skipped: no folder of replays, -Psteward.replays=FOLDER");
        try (Stream<Path> files = Files.list(folder)) {
            List<Path> named = files.filter(file -> file.getFileName().toString().startsWith("replay_")).sorted()
                .toList();
            assumeTrue(!named.isEmpty(), () -> "skipped: no replay_* in " + folder.toAbsolutePath());
            return named.stream().map(SimulateCommandTest::read).toList();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private static Recording read(Path file) {
        Recording recording = new Recording(file.getFileName().toString(), new ArrayList<>(), new ArrayList<>(),
            new ArrayList<>(), new ArrayList<>());
        try {
            for (String line : Files.readAllLines(file)) {
                String[] words = line.split(" ", 2);
                switch (words[0]) {
                    case "CHECKPOINTS" -> {
                        String[] numbers = words[1].split(" ");
                        for (int k = 0; k < numbers.length; k += 2) {
                            recording.checkpoints().add(numbers[k] + " " + numbers[k + 1]);
                        }
                    }
                    case "IN" -> recording.in().add(words[1]);
                    case "MOV" -> recording.moves().add(words[1]);
                    case "OUT" -> recording.out().add(words[1]);
                    default -> { }
                }
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        return recording;
    }

    private static Process simulator(ProcessBuilder.Redirect errors) throws IOException {
        return new ProcessBuilder(JavaProcess.words(Main.class, "simulate")).redirectError(errors).start();
    }

    /** One process for all games; each test is sent only when the answer to the last has come. */
    @Test
    @Tag("process")
    void everyValueOfTheOfficialRecordings(TestReporter report) throws IOException, InterruptedException {
        List<Recording> recordings = recordings();
        Process process = simulator(ProcessBuilder.Redirect.INHERIT);
        int values = 0;
        int different = 0;
        try (OutputStream in = process.getOutputStream();
             BufferedReader out = new BufferedReader(new InputStreamReader(process.getInputStream()))) {
            for (Recording recording : recordings) {
                List<String> differences = new ArrayList<>();
                int digits = count(recording, in, out, differences);
                int all = recording.tests() * PODS * COLUMNS;
                report.publishEntry("simulate, " + recording.name() + ": " + (all - differences.size()) + " of " + all
                    + " values equal, " + digits + " of them to the last digit; different: " + differences);
                values += all;
                different += differences.size();
                assertTrue(differences.stream().allMatch(difference ->
                    difference.startsWith("last test, nextCheckpoint: recorded 0")), differences::toString);
            }
        } finally {
            process.waitFor(10, TimeUnit.SECONDS);
        }
        assertEquals(0, process.exitValue());
        assertTrue(values > 0, "the folder holds games");
        assertTrue(different <= recordings.size(), "at most that of the winner in the last round of each");
    }

    /** Plays one recording; returns how many values are the very same, and adds those that are not equal. */
    private static int count(Recording recording, OutputStream in, BufferedReader out, List<String> differences)
            throws IOException {
        write(in, recording.checkpoints().size() + "\n" + String.join("\n", recording.checkpoints()) + "\n"
            + recording.tests() + "\n");
        int same = 0;
        for (int test = 0; test < recording.tests(); test++) {
            int from = test * PODS;
            write(in, String.join("\n", recording.in().subList(from, from + PODS)) + "\n"
                + String.join("\n", recording.moves().subList(from, from + PODS)) + "\n");
            for (int pod = 0; pod < PODS; pod++) {
                String[] recorded = recording.out().get(from + pod).split(" ");
                String[] found = out.readLine().split(" ");
                assertEquals(COLUMNS, found.length);
                for (int column = 0; column < COLUMNS; column++) {
                    double difference = Math.abs(Double.parseDouble(recorded[column])
                        - Double.parseDouble(found[column]));
                    same += difference == 0 ? 1 : 0;
                    if (difference > (column == ANGLE ? ANGLE_TOLERANCE : 0)) {
                        differences.add((test == recording.tests() - 1 ? "last test" : "test " + test) + ", "
                            + (column == NEXT_CHECKPOINT ? "nextCheckpoint" : "column " + column) + ": recorded "
                            + recorded[column] + ", found " + found[column] + ", pod " + pod);
                    }
                }
            }
        }
        return same;
    }

    private static void write(OutputStream in, String lines) throws IOException {
        in.write(lines.getBytes(StandardCharsets.UTF_8));
        in.flush();
    }

    private static final String STATE = "0 0 0 0 0 1 0 0\n";
    private static final String STATES = STATE + "9000 0 0 0 0 1 0 0\n9000 9000 0 0 0 1 0 0\n0 9000 0 0 0 1 0 0\n";
    private static final String MAP = "2\n100 100\n5000 5000\n";

    @Test
    @Tag("process")
    void aWrongInputEndsTheProgramWithStatus2AndTheAnswersBeforeAreThere() throws IOException, InterruptedException {
        Process process = simulator(ProcessBuilder.Redirect.PIPE);
        write(process.getOutputStream(), MAP + "2\n\n" + STATES + "5000 0 100\n5000 0 0\n0 0 SHIELD\n0 0 BOOST\nx\n");
        process.getOutputStream().close();
        List<String> out = new String(process.getInputStream().readAllBytes()).lines().toList();
        String err = new String(process.getErrorStream().readAllBytes());
        assertTrue(process.waitFor(30, TimeUnit.SECONDS));
        // Thrust 100 from rest: 100 u on, then 100 x 0.85; checkpoint 1 is not passed. Headings turn by at most 18.
        assertEquals(List.of("100 0 85 0 0 1 0 0", "9000 0 0 0 342 1 0 0"), out.subList(0, 2));
        assertEquals("9000 9000 0 0 342 1 3 0", out.get(2));
        assertTrue(out.get(3).startsWith("618 8799 525 -170 34") && out.get(3).endsWith(" 1 0 1"), out.get(3));
        assertEquals(4, out.size());
        assertEquals("steward: input line 14: found \"x\", expected x y vx vy angleDegrees nextCheckpointId shield "
            + "boosted\n", err);
        assertEquals(ExitStatus.UNUSABLE, process.exitValue());
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void aFolderIsNoInput() throws IOException, InterruptedException {
        String call = ProcessTest.steward("simulate") + " </tmp 2>&1";
        assertEquals("steward: standard input: found a folder, expected a file or a pipe\nstatus 2\n",
            ProcessTest.shell(call));
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void noInputIsNoTest() throws IOException, InterruptedException {
        Process process = simulator(ProcessBuilder.Redirect.INHERIT);
        process.getOutputStream().close();
        assertEquals(0, process.getInputStream().readAllBytes().length);
        assertEquals(ExitStatus.DONE, process.waitFor());
    }
}

package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.cli.Recorded;
import steward.cli.shared.ExitStatus;
import steward.match.TestSize;
import steward.replay.ReplayReader;

/** {@code steward replay} on a duel of two in-process bots that both drive. */
@Execution(ExecutionMode.CONCURRENT)
class ReplayCommandTest {

    @TempDir
    private static Path folder;
    private static Recorded duel;
    private static Path whole;

    @BeforeAll
    static void record() throws IOException {
        duel = Recorded.duel(3);
        whole = Files.write(folder.resolve("duel.jsonl"), duel.bytes());
    }

    private static Cli replay(Path file, String... more) {
        return Cli.run(List.of("replay", file.toString()), more);
    }

    /** As git with autocrlf, an editor of Windows and gzip leave it. */
    @Test
    void aReplayThatGitGzipOrAnEditorTouchedIsRead() throws IOException {
        String text = new String(duel.bytes(), StandardCharsets.UTF_8);
        byte[] windows = ("\uFEFF" + text.replace("\n", "\r\n")).getBytes(StandardCharsets.UTF_8);
        ByteArrayOutputStream zipped = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(zipped)) {
            gzip.write(windows);
        }
        Path file = folder.resolve("touched.jsonl");
        for (byte[] each : List.of(windows, zipped.toByteArray())) {
            assertArrayEquals(duel.bytes(), ReplayReader.asWritten(each));
            Files.write(file, each);
            replay(file, "--verify").done();
            assertEquals(ExitStatus.DONE, replay(file, "--view", folder.resolve("touched.html").toString(),
                "--overwrite").status());
        }
        Files.write(file, Arrays.copyOf(zipped.toByteArray(), 2000));
        assertTrue(replay(file).err().contains("cannot read: Unexpected end of ZLIB"));
    }

    /** Found by {@code gradle fuzz}, seed 99, input 7157: a number too large for a double ended in a stack trace. */
    @Test
    void numbersTooLargeAreShownAsInfinite() throws IOException {
        String text = new String(duel.bytes(), StandardCharsets.UTF_8);
        int impacts = text.indexOf("\"impacts\":[");
        assertTrue(impacts > 0, "no impact");
        String broken = text.substring(0, impacts) + text.substring(impacts)
            .replaceFirst("\"time\":[^,]*", "\"time\":1e999").replaceFirst("\"impulse\":[^,]*", "\"impulse\":-1e999");
        Path file = Files.writeString(folder.resolve("large.jsonl"), broken);
        Cli cli = replay(file, "--impacts").done();
        assertTrue(cli.out().contains(" Infinity ") && cli.out().contains(" -Infinity"), cli.out());
    }

    /** A file from elsewhere may have names of megabytes, up to the longest line; they were printed whole. */
    @Test
    @Tag("slow")
    void longNamesAreShortened() throws IOException {
        String text = new String(duel.bytes(), StandardCharsets.UTF_8);
        String name = duel.result().players().get(0).name();
        String big = "n".repeat(1_000_000);
        for (String[] change : new String[][] {{"\"name\":\"" + name + "\"", "\"name\":\"" + big + "\""},
            {"\"bot\":\"", "\"bot\":\"" + big}, {"\"name\":\"duel\"", "\"name\":\"" + big + "\""},
            {"\"game\":\"pod-race\"", "\"game\":\"" + big + "\""}, {"\"seed\":\"", "\"seed\":\"x" + big}}) {
            assertTrue(text.contains(change[0]), change[0]);
            int place = text.indexOf(change[0]);
            Path file = Files.writeString(folder.resolve("big.jsonl"),
                text.substring(0, place) + change[1] + text.substring(place + change[0].length()));
            for (String option : new String[] {"--from=0", "--verify", "--turn=3", "--impacts", "--quiet"}) {
                Cli cli = replay(file, option);
                int longest = (cli.out() + "\n" + cli.err()).lines().mapToInt(String::length).max().orElse(0);
                assertTrue(longest < 1200, change[0] + " " + option + ": a line of " + longest);
            }
            Cli frames = replay(file, "--frames", "--player", "9");
            assertTrue(frames.err().length() < 1000, change[0] + ": " + frames.err().length());
        }
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void aFileCutAnywhereIsReadUpToTheCut() throws IOException {
        int step = TestSize.of(1009, 101);
        Path file = folder.resolve("cut.jsonl");
        byte[] bytes = duel.bytes();
        int last = -1;
        int header = new String(bytes, StandardCharsets.UTF_8).indexOf('\n');
        int complete = bytes.length - 1;           // all but the last line end, see the next test
        for (int size = 1; size < complete; size += size < 40 ? 1 : step) {
            Files.write(file, Arrays.copyOf(bytes, size));
            Cli cli = replay(file, "--verify");
            assertEquals(ExitStatus.FAILED, cli.status(), size + ": " + cli.err() + cli.out());
            assertTrue(cli.err().startsWith("steward: warning: " + file + ": cut off "), size + ": " + cli.err());
            Cli partly = replay(file, "--verify", "--partial");
            if (size < header) {
                assertEquals("not verified: the header is cut off\n", cli.out(), "at " + size);
                assertEquals(cli, partly);
            } else {
                boolean start = cli.out().equals("verified up to the cut: only the start, since no turn was "
                    + "recorded\n");
                assertTrue(start || cli.out().matches("verified up to the cut: states of ([1-9]\\d*) of \\1 turns?\n"),
                    size + ": " + cli.out());
                assertEquals(new Cli(ExitStatus.DONE, cli.out(), cli.err()), partly);
                int turns = start ? 0 : Integer.parseInt(cli.out().replaceAll("\\D*(\\d+).*\n", "$1"));
                assertTrue(turns >= last, size + ": " + turns);
                last = turns;
            }
            for (String mode : new String[] {"--quiet", "--impacts", "--to=3"}) {
                Cli other = replay(file, mode);
                assertEquals(ExitStatus.DONE, other.status(), size + mode + other.err());
                assertTrue(other.err().startsWith("steward: warning: "), size + mode + other.err());
            }
        }
        assertTrue(last >= duel.result().turns() - 1, "turns verified before the last cut: " + last);
    }

    @Test
    void whatVerificationProvesIsSaidInItsHelp() {
        String help = Cli.run("replay", "--help").out();
        assertTrue(help.contains("does not prove who gave the commands"), help);
        assertTrue(help.contains("only as good as the signature"), help);
    }

    @Test
    void aLostLineEndLosesNothing() throws IOException {
        byte[] bytes = duel.bytes();
        Path file = Files.write(folder.resolve("end.jsonl"), Arrays.copyOf(bytes, bytes.length - 1));
        assertEquals(replay(whole, "--verify"), replay(file, "--verify"));
    }
}

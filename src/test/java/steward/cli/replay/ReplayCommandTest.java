package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
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
import steward.text.TextFormat;

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
        String[] arguments = new String[2 + more.length];
        arguments[0] = "replay";
        arguments[1] = file.toString();
        System.arraycopy(more, 0, arguments, 2, more.length);
        return Cli.run(arguments);
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
            Cli verified = replay(file, "--verify");
            assertEquals(ExitStatus.DONE, verified.status(), verified.err());
            assertEquals(ExitStatus.DONE, replay(file, "--view", folder.resolve("touched.html").toString(),
                "--overwrite").status());
        }
        Files.write(file, Arrays.copyOf(zipped.toByteArray(), 2000));
        assertTrue(replay(file).err().contains("cannot read: Unexpected end of ZLIB"));
    }

    @Test
    void theTableHasARowPerBodyAndTurn() {
        Cli cli = replay(whole);
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        int turns = duel.result().turns();
        for (int turn = 0; turn <= turns; turn++) {
            String start = String.format("%4d", turn);
            assertEquals(2, cli.out().lines().filter(line -> line.startsWith(start + "     ")).count(), start);
        }
        assertTrue(cli.out().contains("turn  body  player       x       y      vx      vy heading\u00b0 "), cli.out());
        assertTrue(cli.out().contains(duel.result().ending()), cli.out());
        assertTrue(cli.out().lines().allMatch(line -> line.length() <= 100), cli.out());
        assertFalse(replay(whole, "--quiet").out().contains("turn  body"));
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
        Cli cli = replay(file, "--impacts");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
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

    /** Such is left of a match that was interrupted before its first turn. */
    @Test
    void aHeaderAloneCanBeReadVerifiedAndShown() throws IOException {
        String header = new String(duel.bytes(), StandardCharsets.UTF_8).lines().findFirst().orElseThrow();
        Path only = Files.writeString(folder.resolve("header.jsonl"), header + "\n");
        String warning = "steward: warning: " + only + ": cut off before the first turn: there is only the header\n";
        Cli table = replay(only);
        assertEquals(warning, table.err());
        assertEquals(ExitStatus.DONE, table.status());
        assertTrue(table.out().endsWith("\nno turn was recorded\n0 impacts in all\n"), table.out());
        assertEquals(new Cli(ExitStatus.FAILED, "verified up to the cut: only the start, since no turn was recorded\n",
            warning), replay(only, "--verify"));
        assertEquals(ExitStatus.DONE, replay(only, "--verify", "--partial").status());
        assertEquals(replay(only, "--verify"), replay(only, "--verify", "--quiet"));
        Path page = folder.resolve("header.html");
        assertEquals(new Cli(ExitStatus.DONE, "Page: " + page + "\n", warning),
            replay(only, "--view", page.toString()));
        assertTrue(Files.readString(page).contains("data-warning=\"This recording was cut off before the first turn: "
            + "there is only the header."));
    }

    @Test
    void aRangeOfTurns() {
        Cli cli = replay(whole, "--from", "4", "--to", "5");
        assertEquals(4, cli.out().lines().filter(line -> line.matches(" +\\d+ +[01] .*yes.*")).count(), cli.out());
        Cli beyond = replay(whole, "--from", "900");
        assertEquals(ExitStatus.UNUSABLE, beyond.status());
        assertEquals("", beyond.out());
        assertTrue(beyond.err().contains("found no turn 900, expected 1 to " + duel.result().turns()));
    }

    @Test
    void oneTurnInFull() {
        Cli cli = replay(whole, "--turn", "2");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().startsWith("turn 2\n\nplayer 0, pilot-0, "), cli.out());
        assertTrue(cli.out().contains("  command  x 10500  y 3500  thrust 120\n  message  t2\n"), cli.out());
        assertTrue(cli.out().contains("heading\u00b0 "), cli.out());
        assertEquals(ExitStatus.UNUSABLE, replay(whole, "--turn", "900").status());
        assertTrue(replay(whole, "--turn", "900", "--impacts").err().contains("found no turn 900, expected 1 to "));
    }

    @Test
    void theMapHasZonesAndALetterPerBody() {
        String map = replay(whole, "--map").out();
        assertTrue(map.startsWith("+---") && map.contains("(0)") && map.contains("a pilot-0    B pilot-1"), map);
        assertEquals(2, replay(whole, "--map", "--impacts").status());
    }

    @Test
    void impactsAreCounted() {
        Cli list = replay(whole, "--impacts");
        String text = new String(duel.bytes(), StandardCharsets.UTF_8);
        int impacts = text.split("\"impulse\":", -1).length - 1;
        assertEquals(impacts, list.out().lines().filter(line -> line.matches(" *\\d+  0\\.\\d{6} .*")).count());
        assertTrue(impacts > 0, "the seed was chosen so that there are impacts");
        assertTrue(list.out().endsWith(TextFormat.count(impacts, "impact") + "\n"), list.out());
        assertTrue(replay(whole, "--quiet").out().endsWith(TextFormat.count(impacts, "impact") + " in all\n"));
    }

    @Test
    void aWholeReplayVerifies() {
        Cli cli = replay(whole, "--verify");
        assertEquals(new Cli(ExitStatus.DONE, "verified: states of " + duel.result().turns() + " of "
            + duel.result().turns() + " turns and the result\n", ""), cli);
        assertEquals(new Cli(ExitStatus.DONE, "", ""), replay(whole, "--verify", "--quiet"));
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void oneChangedDigitIsFoundInItsTurn() throws IOException {
        String[] lines = new String(duel.bytes(), StandardCharsets.UTF_8).split("\n");
        for (String field : new String[] {"\"vx\":", "\"impulse\":", "\"hash\":\"", "\"commands\":[[{\"x\":"}) {
            int[] turns = IntStream.range(1, lines.length - 1).filter(turn -> lines[turn].contains(field)).toArray();
            assertTrue(turns.length > 0, field);
            for (int k = 0; k < turns.length; k += TestSize.of(5, 1)) {
                int turn = turns[k];
                int at = lines[turn].indexOf(field);
                int digit = at + field.length();
                digit += lines[turn].charAt(digit) == '-' ? 1 : 0;
                char other = lines[turn].charAt(digit) == '7' ? '8' : '7';
                String[] edited = lines.clone();
                edited[turn] = lines[turn].substring(0, digit) + other + lines[turn].substring(digit + 1);
                Path file = Files.writeString(folder.resolve("edited.jsonl"), String.join("\n", edited) + "\n");
                Cli cli = replay(file, "--verify");
                assertEquals(ExitStatus.FAILED, cli.status(), cli.err() + field + turn);
                assertTrue(cli.out().startsWith("differs: turn " + turn + ", "), cli.out() + field);
            }
        }
    }

    @Test
    @Tag("slow")
    void aFileCutAnywhereIsReadUpToTheCut() throws IOException {
        assertReadUpToTheCut(1009);
    }

    @Test
    @Tag("campaign")
    void aFileCutAtManyPlacesIsReadUpToTheCut() throws IOException {
        assertReadUpToTheCut(101);
    }

    private void assertReadUpToTheCut(int step) throws IOException {
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
    void optionsOfVerificationNeedIt() {
        for (String[] wrong : new String[][] {{"--partial"}, {"--signed-by", "x.pub"}}) {
            assertEquals(ExitStatus.UNUSABLE, replay(whole, wrong).status());
        }
    }

    @Test
    void whatVerificationProvesIsSaidInItsHelp() {
        String help = Cli.run("replay", "--help").out();
        assertTrue(help.contains("Who gave the commands it does"), help);
        assertTrue(help.contains("only as good as the\nsignature"), help);
    }

    @Test
    void futureAnglesAndFormats() throws IOException {
        String text = new String(duel.bytes(), StandardCharsets.UTF_8);
        Path file = Files.writeString(folder.resolve("future.jsonl"), text.replace("\"correctly-rounded\"",
            "\"abacus\""));
        assertEquals(new Cli(ExitStatus.UNUSABLE, "", "steward: " + file + ":1: angles: found \"abacus\", expected "
            + "\"correctly-rounded\"\n"), replay(file, "--verify"));
        Files.writeString(file, text.replace("\"format\":3", "\"format\":4"));
        assertEquals(new Cli(ExitStatus.UNUSABLE, "", "steward: " + file + ":1: format: found 4, expected 3: "
            + "a newer version of Steward wrote this replay\n"), replay(file, "--verify"));
    }

    @Test
    void aLostLineEndLosesNothing() throws IOException {
        byte[] bytes = duel.bytes();
        Path file = Files.write(folder.resolve("end.jsonl"), Arrays.copyOf(bytes, bytes.length - 1));
        assertEquals(replay(whole, "--verify"), replay(file, "--verify"));
    }

    @Test
    void damageBeforeTheEndIsLocated() throws IOException {
        String text = new String(duel.bytes(), StandardCharsets.UTF_8);
        Path file = Files.writeString(folder.resolve("damaged.jsonl"),
            text.replaceFirst("\\{\"type\":\"turn\",\"turn\":3", "{\"type\":turn,\"turn\":3"));
        Cli cli = replay(file, "--verify");
        assertEquals(ExitStatus.UNUSABLE, cli.status());
        assertTrue(cli.err().startsWith("steward: " + file + ":4:"), cli.err());
    }
}

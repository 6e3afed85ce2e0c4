package steward.lab.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.shared.ExitStatus;
import steward.lab.trial.Rung;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code steward stability}: the table, its files, and the golden hash under other JVM flags. */
@Execution(ExecutionMode.CONCURRENT)
class StabilityCommandTest {

    /** The number of the signal that {@code Process.destroy} sends; Ctrl-C is 2. */
    private static final int TERMINATED = 15;

    @TempDir
    private Path folder;

    private static Cli stability(String... more) {
        return Cli.run(List.of("stability", "--quick"), more);
    }

    @Test
    void theTableSaysWhatWasDemandedAndSeen() {
        Cli cli = stability("--case", "mirror images", "--case", "bullet").done();
        assertTrue(cli.out().startsWith("bullet\n  demanded "), cli.out());
        for (Rung rung : Rung.all()) {
            assertEquals(2, cli.out().lines().filter(line -> line.startsWith("  " + rung.name() + " ")).count());
        }
        assertTrue(cli.out().lines().allMatch(line -> line.length() <= 100), cli.out());
        assertTrue(cli.out().contains(" demands are met, 0 are not\n"), cli.out());
        assertEquals("", cli.err());
    }

    /** A crowd is played for the given number of impacts. */
    @Test
    void rungsAndTheImpactsOfCrowdsCanBeChosen() {
        Cli cli = stability("--case", "crowd of 100, 10%", "--rung", "double", "--rung", "exact", "--impacts", "3000");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        List<String> rows = cli.out().lines().filter(line -> line.contains(" holds ")).toList();
        assertEquals(2, rows.size(), cli.out());
        for (String row : rows) {
            assertTrue(row.matches("  (double|exact) +holds +3\\d{3} impacts in \\d turns: 0 overlaps, .*"), row);
        }
    }

    /** An interrupted run prints the figures so far of an unfinished row; a busy machine needs time to have some. */
    @Test
    @Tag("process")
    @Tag("campaign")
    void theUnfinishedRowIsTold() throws IOException, InterruptedException {
        String expected = "steward: interrupted; the rows so far are above; unfinished: crowd of 100, 10%, "
            + "double, [.0-9]+%: [1-9]\\d* impacts in \\d+ turns: 0 overlaps, (?s:.*)";
        String said = "";
        for (int seconds = 1; seconds < 100 && !said.matches(expected); seconds *= 4) {
            said = interruptedAfter(seconds);
        }
        assertTrue(said.matches(expected), said);
    }

    private String interruptedAfter(int seconds) throws IOException, InterruptedException {
        Path errors = folder.resolve("errors");
        Process run = child(List.of("-XX:TieredStopAtLevel=1"), "stability", "--case", "crowd of 100, 10%",
            "--rung", "double", "--impacts", "1000000000000").redirectError(errors.toFile())
            .redirectOutput(folder.resolve("table").toFile()).start();
        try {
            run.waitFor(seconds, TimeUnit.SECONDS);
        } finally {
            run.destroy();
            run.waitFor();
        }
        return Files.readString(errors);
    }

    @Test
    void aTerminalSeesHowFarItIs() {
        Cli cli = Cli.run(true, "stability", "--quick", "--case", "mirror images");
        assertTrue(cli.err().contains("1 of " + Rung.all().size() + ": mirror images, "), cli.err());
    }

    private static Cli golden;

    /** Result of the golden hash on a terminal, computed once: it takes seconds. */
    private static Cli golden() {
        if (golden == null) {
            golden = Cli.run(true, "stability", "--quick", "--golden");
        }
        return golden;
    }

    /** A table of a second is not announced. */
    @Test
    @Tag("slow")
    void aLongRunSaysBeforehandHowLongItTakes() {
        assertFalse(Cli.run(true, "stability", "--quick", "--case", "mirror images").err().contains("This takes"));
        Cli golden = golden();
        assertTrue(golden.err().startsWith("This takes about "), golden.err());
        assertTrue(golden.err().contains("golden"), golden.err());
    }

    @Test
    void theFilesHoldTheTable() throws IOException {
        Path out = folder.resolve("results");
        assertEquals(ExitStatus.DONE, stability("--case", "mirror images", "--out", out.toString()).status());
        List<String> csv = Files.readAllLines(out.resolve("stability.csv"));
        assertEquals("case,rung,verdict,seconds,seen,demand,length,date,version,machine", csv.get(0));
        assertTrue(csv.get(1).contains(",small,\"20") && csv.get(1).contains("JDK "), csv.get(1));
        assertEquals(1 + Rung.all().size(), csv.size());
        JsonNode json = JsonMapper.shared().readTree(Files.readString(out.resolve("stability.json")));
        assertEquals("small", json.get("size").asString());
        assertEquals(Rung.all().size(), json.get("rows").size());
        assertEquals("holds", json.get("rows").get(0).get("verdict").asString());
        stability("--case", "mirror images", "--out", out.toString()).assertRefused("exists already, and is kept");
        assertEquals(ExitStatus.DONE,
            stability("--case", "mirror images", "--out", out.toString(), "--overwrite").status());
    }

    /** An interrupted run leaves the rows that were measured, in files that are whole; the last one has no end. */
    @Test
    @Tag("process")
    void whatWasMeasuredIsKept() throws IOException, InterruptedException {
        Path out = folder.resolve("results");
        Path errors = folder.resolve("errors");
        Process run = child(List.of(), "stability", "--quick", "--case", "bullet", "--case",
            "crowd of 100, 10%", "--impacts", "1000000000000", "--out", out.toString())
            .redirectError(errors.toFile()).redirectOutput(folder.resolve("table").toFile()).start();
        try {
            Path csv = out.resolve("stability.csv");
            Path json = out.resolve("stability.json");
            for (int k = 0; k < 600 && (!Files.exists(json) || !Files.exists(csv)
                || Files.readAllLines(csv).size() < 4); k++) {
                Thread.sleep(50);
            }
        } finally {
            run.destroy();
            assertEquals(128 + TERMINATED, run.waitFor());
        }
        int lines = Files.readAllLines(out.resolve("stability.csv")).size();
        assertTrue(lines >= 4, "lines " + lines);
        JsonNode rows = JsonMapper.shared().readTree(Files.readString(out.resolve("stability.json"))).get("rows");
        assertTrue(rows.size() >= lines - 2 && rows.size() < 2 * Rung.all().size(),
            rows.size() + " rows, " + lines + " lines");
        String said = Files.readString(errors);
        assertTrue(said.contains("interrupted; the rows so far are in " + out), said);
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void aTableIsTheSameWithoutFusedMultiplyAdd() throws IOException, InterruptedException {
        String[] call = {"stability", "--quick", "--case", "mirror images", "--case", "bullet"};
        assertSame(Cli.run(call), List.of("-XX:-UseFMA", "-XX:TieredStopAtLevel=1"), call);
    }

    @ParameterizedTest
    @ValueSource(strings = {"-XX:-UseFMA", "-Xint"})
    @Tag("process")
    @Tag("campaign")
    void theGoldenHashIsTheSame(String flag) throws IOException, InterruptedException {
        assertSame(golden(), List.of("-XX:+IgnoreUnrecognizedVMOptions", flag), "stability", "--quick", "--golden");
    }

    private static void assertSame(Cli here, List<String> flags, String... call)
            throws IOException, InterruptedException {
        assertEquals(ExitStatus.DONE, here.status(), here.err());
        assertFalse(here.out().isBlank());
        Process other = child(flags, call).start();
        String out = new String(other.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, other.waitFor());
        assertEquals(here.out(), out);
    }

    private static ProcessBuilder child(List<String> flags, String... arguments) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(flags);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Main.class.getName()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }
}

package steward.hostile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.process.JavaProcess;

/**
 * The short forms of what the Gradle tasks {@code hostile}, {@code killed} and {@code soak} do at length, each in a JVM
 * of its own with its own folder for temporary files, so that all that is left can be counted.
 */
@Tag("process")
@Tag("slow")
@Timeout(600)
class HostileTest {

    private static final Path PAGE = Path.of("docs/tables/attacks.md");

    @TempDir
    private Path temporary;

    private void run(TestReporter report, Class<?> program, String... more) throws IOException, InterruptedException {
        assumeTrue(ProgramFinder.find("sh") != null && ProgramFinder.find("setsid") != null
            && Files.isDirectory(Path.of("/proc/self")), "skipped: there is no sh, setsid or /proc");
        List<String> words = JavaProcess.words(List.of("-Xmx48m", "-Djava.io.tmpdir=" + temporary), program,
            List.of(more));
        Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        report.publishEntry(said);
    }

    @Test
    void hostileBotsAtSomeLevel(TestReporter report) throws Exception {
        run(report, HostileSuite.class, "--short");
    }

    @Test
    @Tag("campaign")
    void hostileBotsAtEveryLevel(TestReporter report) throws Exception {
        run(report, HostileSuite.class, "--often");
    }

    @Test
    @Tag("campaign")
    void attacksOnFilesPagesAndLeagues(TestReporter report) throws Exception {
        run(report, HostileSuite.class, "--only", "guards");
    }

    /** Once at every level by every signal from the start on, and once while it plays. */
    @Test
    @Tag("campaign")
    void aSeriesThatIsKilledAtAnyMomentLeavesNothing(TestReporter report) throws Exception {
        run(report, KilledSeries.class, "--times", "6");
    }

    @Test
    @Tag("campaign")
    void hundredsOfMatchesInOneJvmLeaveNothing(TestReporter report) throws Exception {
        run(report, Soak.class, "--matches", "300");
    }

    @Test
    void botsWithThreadsAnswerTheSameHeldOrNot(TestReporter report) throws Exception {
        run(report, HeldLanguages.class, "--turns", "10", "--languages", "java,python3");
    }

    @Test
    @Tag("campaign")
    void botsWithThreadsInEveryLanguageAnswerTheSameHeldOrNot(TestReporter report) throws Exception {
        run(report, HeldLanguages.class, "--turns", "20");
        run(report, HeldLanguages.class, "--turns", "20", "--level", "strict");
    }

    /** The page says just what the suite holds: the same rows, in the same order. */
    @Test
    void thePageHasARowForEachAttack() throws IOException {
        Map<String, String> rows = new LinkedHashMap<>();
        for (String line : Files.readAllLines(PAGE)) {
            String[] cells = line.split("\\|");
            if (cells.length == 5 && cells[2].strip().matches("held|escapes|succeeds")) {
                rows.put(cells[1].strip(), cells[2].strip() + " " + cells[3].strip() + " " + cells[4].strip());
            }
        }
        Map<String, String> expected = Attacks.ALL.stream().collect(Collectors.toMap(Attack::what,
            attack -> attack.off().word() + " held held", (one, other) -> one, LinkedHashMap::new));
        assertEquals(List.copyOf(expected.keySet()), List.copyOf(rows.keySet()));
        assertEquals(expected, rows);
        assertTrue(Attacks.ALL.size() == expected.size(), "two attacks have the same name");
    }
}

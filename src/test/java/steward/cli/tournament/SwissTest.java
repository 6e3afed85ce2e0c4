package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.shared.ExitStatus;

/**
 * Swiss rounds of four programs, interrupted and with programs that change: two games of each pair that meets. It takes
 * long because the interrupted tournament is a program of its own, which is killed.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class SwissTest {

    @TempDir
    private Path folder;

    private ProgramFolder programs;

    @BeforeEach
    void programs() throws IOException {
        programs = new ProgramFolder(folder, 2);
        for (String name : List.of("a", "b", "c", "d")) {
            programs.add(name, "9000", "");
        }
    }

    private static String[] options(int rounds) {
        return new String[] {"--games", "2", "--sandbox", "off", "--rounds", Integer.toString(rounds)};
    }

    private Cli call(int rounds) {
        return programs.call(options(rounds));
    }

    private Path rounds() {
        return folder.resolve("out/rounds.json");
    }

    /** Number of stored games that count. */
    private int stored() {
        return Cli.league(folder, "games", "TMP/out/league", "--limit", "1000", "--json").done().json().get("list")
            .size();
    }

    /** Everybody in the table has so many games. */
    private void assertGames(Cli call, int games) {
        assertEquals(ExitStatus.DONE, call.status(), call.err());
        TreeMap<String, String> found = new TreeMap<>();
        call.out().lines().filter(line -> line.matches(" +\\d+ [a-d] .*")).map(line -> line.strip().split(" +"))
            .forEach(row -> found.put(row[1], row[3]));
        String each = Integer.toString(games);
        assertEquals(new TreeMap<>(Map.of("a", each, "b", each, "c", each, "d", each)), found, call.out());
    }

    /**
     * The program b waits in its first game of the second round, which has been written by then; there the tournament
     * is killed. The next call plays this round, as it was decided on, and the third.
     */
    @Test
    void aRoundThatWasKilledGoesOnAsDecided() throws IOException, InterruptedException {
        Path waits = folder.resolve("waits");
        Path go = folder.resolve("go");
        programs.add("b", "9000", "if [ ! -e '" + go + "' ] && grep -q '}, *{\\|},{' '" + rounds()
            + "' 2>/dev/null; then\ntouch '" + waits + "'; while [ ! -e '" + go + "' ]; do sleep 0.1; done; fi\n");
        Process killed = new ProcessBuilder(JavaProcess.words(List.of(), Main.class, programs.words(options(3))))
            .redirectErrorStream(true).redirectOutput(folder.resolve("killed.txt").toFile()).start();
        try {
            while (!Files.exists(waits)) {
                assertTrue(killed.isAlive(), () -> read(folder.resolve("killed.txt")));
                TimeUnit.MILLISECONDS.sleep(20);
            }
        } finally {
            killed.destroyForcibly().waitFor();
        }
        String decided = read(rounds());
        int before = stored();
        assertTrue(before >= 4 && before < 8, before + " games are stored: the first round, and not all of the second");
        Files.createFile(go);
        Cli again = call(3);
        assertGames(again, 6);
        assertEquals(12, stored());
        String second = decided.substring(decided.indexOf("\"rounds\""), decided.lastIndexOf(']'));
        assertTrue(read(rounds()).contains(second), () -> decided + " is no beginning of " + read(rounds()));
        assertGames(call(3), 6);
        assertEquals(12, stored());
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException problem) {
            return problem.toString();
        }
    }

    /** A new version begins anew: in the table all have two rounds, of the versions that are there. */
    @Test
    void aResubmissionBetweenRoundsBeginsAnewAndSaysSo() throws IOException {
        assertGames(call(1), 2);
        programs.add("b", "9001", "");
        Cli second = call(2);
        assertTrue(second.err().contains("steward: the programs are not those of the 1 round so far: the rounds begin "
            + "anew; "), second.err());
        assertGames(second, 4);
        assertEquals(List.of(), second.err().lines().filter(line -> second.err().lines().filter(line::equals).count()
            > 1).toList(), "lines that come again with each round");
        assertEquals(List.of("6 games in this run"), second.out().lines().filter(line -> line.contains(" in this run"))
            .map(line -> line.replaceFirst(",.*", "")).toList());
        assertTrue(second.out().contains("  failed  Buchholz\n"), second.out());
        assertTrue(read(folder.resolve("out/index.html")).contains("<th class=\"num wide\">Buchholz<th class=why>"));
    }

    /** Without the file the rounds that were played are decided on again as they were, from the stored games. */
    @Test
    @Tag("campaign")
    void aFileThatIsCutIsNamedAndItsRoundsAreFoundAgain() throws IOException {
        assertGames(call(2), 4);
        String whole = read(rounds());
        int stored = stored();
        Files.writeString(rounds(), whole.substring(0, whole.length() / 2));
        Cli refused = call(2);
        assertEquals(ExitStatus.UNUSABLE, refused.status(), refused.err());
        assertTrue(refused.err().contains(rounds() + ":1:") && refused.err().endsWith(
            "; without the file the rounds begin anew\n"), refused.err());
        Files.delete(rounds());
        assertGames(call(2), 4);
        assertEquals(whole, read(rounds()));
        assertEquals(stored, stored());
    }
}

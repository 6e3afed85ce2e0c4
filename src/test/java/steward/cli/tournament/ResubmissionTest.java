package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.files.Folders;
import tools.jackson.databind.JsonNode;

/**
 * A tournament is called again and again: what was handed in last plays, everybody has as many games as the others, and
 * all pages say what the database says. It takes long because the bots of every game are processes.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class ResubmissionTest {

    private static final Pattern ROW = Pattern.compile("<td class=name><a href=\"bots/([^\"]+)\\.html\">.*?</tr>");
    private static final Pattern NUMBER = Pattern.compile("<td class=(?:num|\"num wide\")>([^<]*)");

    @TempDir
    private Path folder;

    private ProgramFolder programs;

    @BeforeEach
    void scene() throws IOException {
        programs = new ProgramFolder(folder, 2);
    }

    private Cli call() {
        return programs.call("--games", "2", "--sandbox", "off").done();
    }

    /** Calls again, and compares all pages with the database. */
    private void played(int games, String... names) throws IOException {
        Cli cli = call();
        assertTrue(cli.out().contains("\n" + games + " game") || cli.out().startsWith(games + " game"), cli.out());
        Map<String, List<String>> rows = rows();
        assertEquals(List.of(names), List.copyOf(rows.keySet()));
        rows.forEach((name, row) -> assertEquals(Integer.toString(2 * (names.length - 1)), row.get(1), name + row));
        compareWithDatabase(rows);
    }

    /** By program: points, games, won, drawn, lost, failed. */
    private Map<String, List<String>> rows() throws IOException {
        Map<String, List<String>> rows = new TreeMap<>();
        Matcher row = ROW.matcher(Files.readString(folder.resolve("out/index.html")));
        while (row.find()) {
            List<String> numbers = new ArrayList<>();
            Matcher number = NUMBER.matcher(row.group());
            while (number.find()) {
                numbers.add(number.group(1));
            }
            rows.put(row.group(1), numbers);
        }
        return rows;
    }

    private void compareWithDatabase(Map<String, List<String>> rows) throws IOException {
        Map<String, int[]> sums = new TreeMap<>();
        rows.keySet().forEach(name -> sums.put(name, new int[5]));
        JsonNode games = Cli.league(folder, "games", "TMP/out/league", "--limit", "10000", "--json").done().json();
        Map<String, String> present = new TreeMap<>();           // the last version of each, by the command of games
        for (JsonNode game : games.get("list")) {
            for (JsonNode seat : game.get("seats")) {
                present.putIfAbsent(seat.get("bot").stringValue().replaceFirst("#.*", ""),
                    seat.get("bot").stringValue());
            }
        }
        int counted = 0;
        for (JsonNode game : games.get("list")) {
            List<JsonNode> seats = new ArrayList<>();
            game.get("seats").forEach(seats::add);
            if (!game.get("counts").booleanValue() || !seats.stream().allMatch(seat -> present.containsValue(
                    seat.get("bot").stringValue()) && sums.containsKey(name(seat)))) {
                continue;
            }
            counted++;
            for (JsonNode seat : seats) {
                int[] sum = sums.get(name(seat));
                int other = seats.get(seats.get(0) == seat ? 1 : 0).get("rank").intValue();
                sum[0]++;
                sum[2 + Integer.signum(seat.get("rank").intValue() - other)]++;
                sum[4] += seat.get("fault").isNull() ? 0 : 1;
            }
        }
        String csv = Files.readString(folder.resolve("out/table.csv"));
        for (Map.Entry<String, int[]> each : sums.entrySet()) {
            int[] sum = each.getValue();
            List<String> expected = List.of(Scores.points(sum[1] + sum[2] / 2.0), "" + sum[0], "" + sum[1],
                "" + sum[2], "" + sum[3], "" + sum[4]);
            assertEquals(expected, rows.get(each.getKey()), each.getKey());
            assertTrue(csv.contains("," + each.getKey() + "," + String.join(",", expected) + ","), csv);
            String page = Files.readString(folder.resolve("out/bots/" + each.getKey() + ".html"));
            assertTrue(page.contains("<p>" + sum[0] + " games</p>"), each.getKey());
            assertEquals(sum[0], page.split("<tr><td class=name>", -1).length - 1, each.getKey());
            assertEquals(sum[4], page.split("<div class=bad>failed in turn ", -1).length - 1, each.getKey());
            assertEquals(sum[3], page.split(" data-game=", -1).length - 1, "replays of what it lost");
        }
        String league = Files.readString(folder.resolve("out/league.html"));
        assertTrue(league.contains("\"games\":" + counted + ","), "the page of the league has " + counted + " games");
    }

    private static String name(JsonNode seat) {
        return seat.get("bot").stringValue().replaceFirst("#.*", "");
    }

    @Test
    void threeResubmissionsPlayAgainstAll() throws IOException {
        programs.add("a", "1", "");
        programs.add("b", "9000", "");
        programs.add("c", "9000", "echo private >&2; exit 3\n");
        played(6, "a", "b", "c");
        programs.add("a", "2", "");
        played(4, "a", "b", "c");
        programs.add("a", "3", "");
        played(4, "a", "b", "c");
        String other = Files.readString(folder.resolve("out/bots/a.html")) + Files.readString(folder.resolve(
            "out/index.html"));
        assertFalse(other.contains("private"), "what c wrote to stderr is on no other page");
        assertTrue(Files.readString(folder.resolve("out/bots/c.html")).contains("private"));
        assertTrue(call().out().startsWith("0 games in this run"));
    }

    @Test
    @Tag("campaign")
    void newOnesAreAddedThoseThatAreGoneLeaveAndABackupReturns() throws IOException {
        programs.add("a", "1", "");
        programs.add("b", "9000", "");
        programs.add("c+", "4000", "");
        played(6, "a", "b", "c");
        programs.add("c-", "4001", "");            // the second of one name: it is c-2, also when the first is gone
        played(6, "a", "b", "c", "c-2");
        delete("c+");
        played(0, "a", "b", "c-2");
        programs.add("a", "5", "");
        played(4, "a", "b", "c-2");
        programs.add("a", "1", "");                // put back: its games with b count again, those with c-2, too
        Cli cli = call();
        assertTrue(cli.out().startsWith("0 games"), cli.out());
        assertEquals(List.of("a", "b", "c-2"), List.copyOf(rows().keySet()));
        programs.add("d", "5000", "");
        delete("b");
        assertTrue(call().out().startsWith("4 games"));
        assertEquals(List.of("a", "c-2", "d"), List.copyOf(rows().keySet()));
        assertFalse(Files.exists(folder.resolve("out/bots/b.html")));
    }

    private void delete(String name) throws IOException {
        Folders.delete(folder.resolve("in").resolve(name));
    }

    @Test
    void whatChangesDuringTheGamesWaitsForTheNextCall() throws IOException {
        String change = "echo '#' >>'" + folder.resolve("in/b/main.sh") + "'; mkdir -p '" + folder.resolve("in/d")
            + "'; echo 'sh x' >'" + folder.resolve("in/d/run") + "'; rm -rf '" + folder.resolve("in/e") + "'\n";
        programs.add("a", "1", change);
        programs.add("b", "9000", "");
        programs.add("e", "9001", "");
        Cli cli = call();
        for (String line : List.of("b has changed", "d has come", "e has gone")) {
            assertTrue(cli.err().contains("steward: " + line
                + " since the programs were copied; the next call sees it"), cli.err());
        }
    }

    /** Two people hand in the same: both play, against each other too. */
    @Test
    void equalProgramsAreTwo() throws IOException {
        programs.add("a", "1", "");
        programs.add("b", "1", "");
        played(2, "a", "b");
    }

    /** A command of 1,203 characters is refused before it is written, and stops nobody. */
    @Test
    void aCommandThatIsTooLongIsAWordOnItsPage() throws IOException {
        programs.add("a", "1", "");
        programs.add("b", "9000", "");
        programs.add("long", "5", "");
        Files.writeString(folder.resolve("in/long/run"), "sh main.sh " + "x".repeat(1200));
        Cli cli = call();
        assertTrue(cli.err().contains("long: cannot run: run: found a command that is "), cli.err());
        assertTrue(Files.readString(folder.resolve("out/bots/long.html")).contains("expected at most 980"));
        assertTrue(call().out().startsWith("0 games"));
    }
}

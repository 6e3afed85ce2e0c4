package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.league.LeagueFolder;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import tools.jackson.databind.JsonNode;

/** Lists of seeds from their choice to a verdict, in every command that takes one. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class ChosenSeedsTest {

    @TempDir
    private Path folder;
    private String scene;
    private String list;
    private String near;
    private String far;
    private String other;

    /** One drives to the first checkpoint, the others away from it: whoever sits where, the first wins. */
    @BeforeEach
    void bots() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        ShellBots.shortDuel(folder);
        ShellBots.drawn(folder.resolve("short.json"));
        scene = folder.resolve("short.json").toString();
        list = folder.resolve("seeds.txt").toString();
        ShellBots shell = new ShellBots(folder);
        near = shell.driver("near", ShellBots.CHECKPOINT);
        far = shell.driver("far", ShellBots.NOWHERE);
        other = shell.driver("other", "5001 99000");
    }

    private void choose() {
        Cli.run("seeds", "--scene", scene, "--bot", near, "--bot", far, "--count", "3", "--from", "20", "--seed", "40",
            "--out", list).done();
    }

    @Test
    void seedsAreChosenAndATestOfTheirChoosersIsRefused() throws IOException {
        choose();
        List<String> lines = Files.readAllLines(folder.resolve("seeds.txt"));
        assertEquals(List.of("40  # near ahead by 1", "41  # near ahead by 1", "42  # near ahead by 1"),
            lines.stream().filter(line -> !line.startsWith("#")).toList());
        assertEquals(2, lines.stream().filter(line -> line.matches("# chosen by [0-9a-f]{32} (near|far)")).count());
        Cli refused = Cli.run("sprt", "--scene", scene, "--bot", other, "--bot", far, "--seed-file", list);
        assertEquals(ExitStatus.UNUSABLE, refused.status());
        assertTrue(refused.err().contains("seeds that were chosen by games of far, expected others"), refused.err());
        Cli anyway = Cli.run("sprt", "--scene", scene, "--bot", near, "--bot", far, "--seed-file", list, "--anyway",
            "--json").done();
        assertEquals("far", anyway.json().get("choosers").get(1).stringValue());
        assertEquals(3, anyway.json().get("seeds").intValue());
        assertTrue(anyway.err().contains("all 3 seeds of the list have been played"), anyway.err());
        Cli text = Cli.run("match", "--scene", scene, "--bot", near, "--bot", far, "--seed-file", list, "--anyway")
            .done();
        assertTrue(text.out().contains("3 listed seeds") && text.out().contains("Flagged: the seeds were chosen by "
            + "games of near and far"), text.out());
        assertEquals(ExitStatus.UNUSABLE, Cli.run("match", "--scene", scene, "--bot", near, "--bot", far,
            "--seed-file", list).status());
    }

    @Test
    void aListedTestOfOthersPlaysTheListAndAMatchToo() throws IOException {
        Files.writeString(folder.resolve("seeds.txt"), "7 # a\n3\n");
        JsonNode match = Cli.run("match", "--scene", scene, "--bot", near, "--bot", other, "--seed-file", list,
            "--swap", "--json").json();
        List<String> seeds = new ArrayList<>();
        match.get("list").forEach(game -> seeds.add(game.get("seed").stringValue()));
        assertEquals(List.of("7", "7", "3", "3"), seeds);
        assertEquals(0, match.get("choosers").size());
        Cli test = Cli.run("sprt", "--scene", scene, "--bot", near, "--bot", other, "--seed-file", list).done();
        assertTrue(test.out().contains("2 seeds, 4 games"), test.out());
        assertTrue(test.err().contains("all 2 seeds of the list have been played"), test.err());
    }

    @Test
    void everyPairOfALeaguePlaysTheListAndThenItEnds() throws IOException {
        Files.writeString(folder.resolve("seeds.txt"), "7 # a\n3\n");
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--seed-file", list).done();
        for (String bot : new String[] {near, far, other}) {
            Cli.run("league", "add", league, bot).done();
        }
        Cli run = Cli.run("league", "run", league).done();
        assertTrue(run.out().contains("12 games in this run"), run.out());
        assertTrue(run.out().contains("The bots have played all seeds of seeds.txt."), run.out());
        JsonNode games = Cli.run("league", "games", league, "--json").json();
        assertEquals(12, games.get("games").intValue());
        assertTrue(Cli.run("league", "run", league).done().out().contains("0 games in this run"));
    }

    /** One game of the first seed is there, with and without a failure, and all of the second. */
    @Test
    void aLeagueAdoptsGamesOnItsSeedsThatWereStoredBefore() throws IOException {
        Files.writeString(folder.resolve("seeds.txt"), "7 # a\n3\n");
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--seed-file", list).done();
        String broken = new ShellBots(folder).witness("broken", ShellBots.NOWHERE, 2, folder.resolve("seen.txt"));
        String worse = new ShellBots(folder).witness("worse", "5001 99000", 2, folder.resolve("seen.txt"));
        for (String[] pair : new String[][] {{near, far}, {near, broken}, {broken, worse}}) {
            Cli.run("match", "--scene", scene, "--bot", pair[0], "--bot", pair[1], "--games", "1", "--seed", "7",
                "--into", league).done();
            Cli.run("match", "--scene", scene, "--bot", pair[0], "--bot", pair[1], "--games", "1", "--swap", "--seed",
                "3", "--into", league).done();
        }
        for (String bot : new String[] {near, far, broken, worse}) {
            Cli.run("league", "add", league, bot).done();
        }
        Cli run = Cli.run("league", "run", league).done();
        JsonNode games = Cli.run("league", "games", league, "--json").json();
        assertEquals(6 * 2 * 2, games.get("games").intValue(), run.out() + run.err());
        try (GameStore store = GameStore.read(LeagueFolder.open(Path.of(league)))) {
            new GameQueries(store, 1, store.lastSeason().orElseThrow()).games(game -> assertTrue(game.decision() >= 0,
                "game " + game.id()));
        }
        assertTrue(run.out().contains("The bots have played all seeds of seeds.txt."), run.out() + run.err());
        assertTrue(Cli.run("league", "run", league).done().out().contains("0 games in this run"));
    }

    @Test
    void aLeagueOfAChooserIsRefusedAndFlagged() {
        choose();
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--seed-file", list).done();
        Cli.run("league", "add", league, near).done();
        Cli.run("league", "add", league, other).done();
        Cli refused = Cli.run("league", "run", league);
        assertEquals(ExitStatus.UNUSABLE, refused.status());
        assertTrue(refused.err().contains("seeds that were chosen by games of near"), refused.err());
        assertTrue(Cli.run("league", "run", league, "--anyway").done().out().contains("Flagged: the seeds"));
        assertTrue(Cli.run("league", "table", league).done().out().contains("Flagged: the seeds"));
        assertEquals("near", Cli.run("league", "table", league, "--json").json().get("choosers").get(0).stringValue());
    }

    /** Two seeds are the budget. The games on the three chosen ones are there, and come first only if they may. */
    @Test
    void storedGamesOnSeedsThatTheBotsChoseDoNotCount() {
        choose();
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene).done();
        Cli.run("league", "add", league, near).done();
        Cli.run("league", "add", league, far).done();
        Cli.run("sprt", "--scene", scene, "--bot", near, "--bot", far, "--seed-file", list, "--anyway", "--into",
            league).done();
        String[] test = {"sprt", "--scene", scene, "--bot", near, "--bot", far, "--into", league, "--games", "4",
            "--json"};
        String[] ofLeague = {"league", "sprt", league, "near", "far", "--games", "4", "--json"};
        for (String[] call : List.of(test, ofLeague)) {
            Cli refused = Cli.run(call).done();
            assertTrue(refused.err().contains("stored games on 3 seeds do not count: games of near and far chose them; "
                + "--anyway counts them"), refused.err());
            assertEquals(0, refused.json().get("choosers").size());
        }
        assertEquals(3 * 2 + 2 * 2, Cli.run("league", "games", league, "--json").json().get("games").intValue());
        for (String[] call : List.of(test, ofLeague)) {
            List<String> words = new ArrayList<>(List.of(call));
            words.add("--anyway");
            Cli flagged = Cli.run(words.toArray(String[]::new)).done();
            assertEquals(2, flagged.json().get("choosers").size(), flagged.err());
            assertFalse(flagged.err().contains("do not count"), flagged.err());
        }
        assertTrue(Cli.run("league", "table", league).done().out().contains("Flagged: the seeds"),
            "by the test's list");
    }

    private void handIn(String name, String place) throws IOException {
        Path own = Files.createDirectories(folder.resolve("in").resolve(name));
        Files.copy(folder.resolve("pod.sh"), own.resolve("pod.sh"));
        Files.writeString(own.resolve("run"), "sh pod.sh " + place + " 0\n");
    }

    /** A call that is refused leaves nothing behind; a list that was taken anyway is refused in the next call, too. */
    @Test
    void aTournamentOfAChooserIsRefusedInEveryCall() throws IOException {
        choose();
        handIn("mine", ShellBots.CHECKPOINT);
        handIn("other", "5001 99000");
        Path out = folder.resolve("out");
        List<String> call = List.of("tournament", folder.resolve("in").toString(), "--scene", scene, "--protocol",
            "json", "--games", "2", "--page", out.toString());
        String[] listed = Stream.concat(call.stream(), Stream.of("--seed-file", list)).toArray(String[]::new);
        String[] anyway = Stream.concat(Stream.of(listed), Stream.of("--anyway")).toArray(String[]::new);
        String[] again = call.toArray(String[]::new);
        Cli refused = Cli.run(listed);
        assertEquals(ExitStatus.UNUSABLE, refused.status(), refused.err());
        assertTrue(refused.err().contains("seeds that were chosen by games of mine"), refused.err());
        assertFalse(Files.exists(out.resolve("league/seeds.txt")));
        assertFalse(Cli.run(again).done().out().contains("Flagged"), "numbers in a row");
        assertTrue(Cli.run(anyway).done().out().contains("Flagged"));
        assertEquals(ExitStatus.UNUSABLE, Cli.run(again).status());
    }

    @Test
    void theSearchAndTheTestOfATuningPlayHalvesOfTheList() throws IOException {
        Files.writeString(folder.resolve("seeds.txt"), "1\n2\n3\n4\n");
        Cli tuned = Cli.run("tune", "--scene", scene, "--bot", near.replace("10500 3500", "{x:8000..12000} 3500"),
            "--against", other, "--seeds", "2", "--games", "32", "--seed-file", list, "--test-games", "20").done();
        assertTrue(tuned.out().contains("Start:") && (tuned.out().contains("2 seeds, 4 games")
            || tuned.out().contains("The result is the start.") || tuned.out().contains("seed")), tuned.out());
    }
}

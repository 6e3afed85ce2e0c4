package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.league.LeagueFolder;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import tools.jackson.databind.JsonNode;

/** Lists of seeds in leagues and tournaments; in tests and matches they are in golden files. */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
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
        assertEquals(ExitStatus.UNUSABLE, refused.status());
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

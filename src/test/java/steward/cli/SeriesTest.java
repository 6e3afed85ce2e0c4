package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

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
import steward.match.MatchResult;
import steward.match.Protocol;
import tools.jackson.databind.JsonNode;

/** {@code steward match --games}. */
@Tag("process")
@Timeout(60)
class SeriesTest {

    @TempDir
    private Path folder;
    private ShellBots bots;

    @BeforeEach
    void shell() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        bots = new ShellBots(folder);
    }

    private Cli series(String second, String... more) {
        return Cli.run(Stream.concat(Stream.of("match", "--scene", "duel", "--no-deadline", "--seed", "5", "--bot",
            bots.driver("near", ShellBots.CHECKPOINT), "--bot", second), Stream.of(more)).toArray(String[]::new));
    }

    @Test
    void resultsDoNotDependOnTheNumberOfThreads() {
        String far = bots.driver("far", ShellBots.NOWHERE);
        String one = series(far, "--games", "4", "--swap", "--json").out();
        assertEquals(one, series(far, "--games", "4", "--swap", "--json", "--threads", "3").out());
    }

    @Test
    void sidesAreSwappedAndPointsGoToTheBot() {
        JsonNode json = series(bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--swap", "--json").json();
        assertEquals(4, json.get("games").intValue());
        JsonNode near = json.get("bots").get(0);
        assertEquals("near", near.get("name").stringValue());
        assertEquals(4, near.get("wins").intValue());
        assertEquals(1, near.get("points").doubleValue());
        assertEquals(4, json.get("bots").get(1).get("losses").intValue());
        String[] seeds = {"5", "5", "6", "6"};
        for (int k = 0; k < seeds.length; k++) {
            JsonNode game = json.get("list").get(k);
            assertEquals(k + 1, game.get("game").intValue());
            assertEquals(seeds[k], game.get("seed").stringValue());
            assertEquals(k % 2, game.get("order").get(0).intValue());
            assertEquals(k % 2, game.get("ranks").get(0).intValue());
        }
    }

    @Test
    void faultsEndNoSeriesAndEqualBotsDraw() {
        Cli cli = series("bad=sh -c 'exit 1'", "--games", "2");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().contains("game 2 (seed 6): bad failed: exited with status 1"), cli.out());
        assertEquals(ExitStatus.FAILED, series("bad=sh -c 'exit 1'", "--games", "1", "--strict").status());
        Cli draws = Cli.run("match", "--scene", "duel", "--bot", "false", "--bot", "false", "--games", "3", "--json");
        JsonNode first = draws.json().get("bots").get(0);
        assertEquals(3, first.get("draws").intValue());
        assertEquals(3, first.get("faults").intValue());
        assertEquals(0.5, first.get("points").doubleValue());
    }

    @Test
    void everyGameHasItsReplay() throws IOException {
        Path replays = folder.resolve("replays");
        Cli cli = series("bad=sh -c 'exit 1'", "--games", "2", "--swap", "--threads", "2", "--out", replays.toString());
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        try (Stream<Path> files = Files.list(replays)) {
            assertEquals(List.of("game-0001.jsonl", "game-0002.jsonl", "game-0003.jsonl", "game-0004.jsonl"),
                files.map(file -> file.getFileName().toString()).sorted().toList());
        }
        assertTrue(Cli.run("replay", replays + "/game-0002.jsonl", "--quiet").out().startsWith(
            "duel (pod-race), seed 5, no deadlines\nplayer 0  bad  "));
        assertTrue(Cli.run("replay", replays + "/game-0003.jsonl", "--verify").out().startsWith("verified: "));
    }

    @Test
    void aGameWithoutAResultEndsNoOther() throws IOException {
        Path replays = Files.createDirectories(folder.resolve("replays"));
        Files.createDirectory(replays.resolve("game-0001.jsonl"));
        Cli cli = series("bad=sh -c 'exit 1'", "--games", "2", "--out", replays.toString(), "--overwrite");
        assertEquals(ExitStatus.FAILED, cli.status());
        assertTrue(cli.err().contains("game 1 could not be brought to a result: "), cli.err());
        assertTrue(Files.size(replays.resolve("game-0002.jsonl")) > 0);
    }

    @Test
    void onATerminalThereIsProgressOnTheErrorStream() {
        Cli cli = Cli.run(true, "match", "--scene", "duel", "--bot", "false", "--bot", "false", "--games", "2");
        assertTrue(cli.err().contains("games 100%"), cli.err());
        assertTrue(cli.out().startsWith("2 games of duel, seeds "), cli.out());
    }

    /** Points 1, 1/2, 0 of three bots: the middle one has one other below and one above. */
    @Test
    void pointsAreTheShareOfTheOthersBelow() {
        assertEquals(0.5, tally(List.of(0, 1, 2), 1).points());
        assertEquals(0.75, tally(List.of(0, 0, 2), 0).points());
        assertEquals(1, tally(List.of(0, 0, 2), 1).draws());
        assertEquals(1, tally(List.of(0, 1, 1), 0).wins());
        assertEquals(0, tally(List.of(0, 1, 2), 2).points());
    }

    private static Tally tally(List<Integer> ranks, int bot) {
        List<MatchResult.PlayerResult> players = ranks.stream()
            .map(rank -> new MatchResult.PlayerResult("p", rank, 0, null, null, 1, 0, 0, 0, 0)).toList();
        List<Contest.Entrant> entrants = ranks.stream()
            .map(rank -> new Contest.Entrant("p", "p", Protocol.JSON, List.of())).toList();
        Series series = new Series(new Contest(null, entrants, null, 1), 0, 1, false, null);
        return Tally.of(series, List.of(new Series.Played(1, 0, 0, new MatchResult(1, "over", players), null)), bot);
    }

    /**
     * 8 points of 10 with z = 1.959964: centre (0.8 + z^2 / 20) / (1 + z^2 / 10) = 0.992073 / 1.384146 = 0.716740, half
     * width z / 1.384146 * sqrt(0.016 + z^2 / 400) = 1.416010 * 0.160011 = 0.226578.
     */
    @Test
    void theIntervalIsWilsons() {
        Tally tally = new Tally(10, 8, 0, 2, 0, 0.8);
        assertEquals(0.490162, tally.low(), 1e-6);
        assertEquals(0.943318, tally.high(), 1e-6);
        assertEquals(1, new Tally(10, 10, 0, 0, 0, 1).high(), 1e-12);
    }
}

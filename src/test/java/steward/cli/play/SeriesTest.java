package steward.cli.play;

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
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
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
        String three = series(far, "--games", "4", "--swap", "--json", "--threads", "3").out();
        assertEquals(withoutTimes(one), withoutTimes(three));
    }

    /** They are the last field, since they are measured. */
    private static String withoutTimes(String json) {
        assertTrue(json.contains(",\"times\":[{\"answers\":"), json);
        return json.substring(0, json.indexOf(",\"times\":"));
    }

    @Test
    void sidesAreSwappedAndPointsGoToTheBot() {
        JsonNode json = series(bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--swap", "--json").json();
        assertEquals(4, json.get("games").intValue());
        JsonNode near = json.get("bots").get(0);
        assertEquals("near", near.get("name").stringValue());
        assertEquals(2, near.get("wins").intValue(), "equal games of other seeds count once");
        assertEquals(1, near.get("points").doubleValue());
        assertEquals(2, json.get("bots").get(1).get("losses").intValue());
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
    void faultsEndNoSeriesAndTwoThatFailTogetherAreNoDraw() {
        Cli cli = series("bad=sh -c 'exit 1'", "--games", "2");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().contains("bad failed in 2 games, first in game 1 (seed 5) in turn 1: exited with "
            + "status 1 before answering\n"), cli.out());
        assertEquals(ExitStatus.FAILED, series("bad=sh -c 'exit 1'", "--games", "1", "--strict").status());
        Cli draws = Cli.run("match", "--scene", "duel", "--bot", "false", "--bot", "false", "--games", "3", "--json");
        JsonNode first = draws.json().get("bots").get(0);
        assertEquals(0, first.get("draws").intValue());
        assertEquals(3, first.get("allFailed").intValue());
        assertEquals(3, first.get("faults").intValue());
        assertTrue(first.get("points").isNull(), first::toString);
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
        assertTrue(cli.out().lines().findFirst().orElse("").contains("2 games of duel"), cli.out());
    }
}

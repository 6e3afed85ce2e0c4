package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import tools.jackson.databind.JsonNode;

/** Bots that fail are named by tests, in leagues and by replays as after a match. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class FailuresToldTest {

    @TempDir
    private Path folder;
    private String scene;
    private String bad;
    private String good;

    @BeforeEach
    void bots() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        ShellBots.shortDuel(folder);
        scene = folder.resolve("short.json").toString();
        bad = "bad=sh " + Files.writeString(folder.resolve("bad.sh"), "echo SyntaxError: a dog >&2; exit 1\n");
        good = new ShellBots(folder).driver("good", ShellBots.CHECKPOINT);
    }

    /** Five seeds of two games are ten games in a row. */
    @Test
    void aTestEndsWhenABotFailedInTenGamesInARow() {
        Cli cli = Cli.run("sprt", "--scene", scene, "--bot", bad, "--bot", good, "--seed", "1", "--elo0", "-1",
            "--json");
        JsonNode failure = cli.json().get("failures").get(0);
        assertEquals(1, cli.status(), cli.err());
        assertEquals(10, failure.get("games").intValue(), cli.out());
        assertEquals("exited with status 1 before answering", failure.get("fault").stringValue());
        assertEquals("SyntaxError: a dog", failure.get("stderr").get(0).stringValue());
        assertEquals(0, failure.get("hints").size(), "nothing explains it better than its stderr");
        assertTrue(cli.err().contains("bad failed in 10 games in a row"), cli.err());
    }

    @Test
    void aTestOfBotsThatAlwaysFailTogetherEndsAlsoIfItIsToKeepGoing() {
        Cli cli = Cli.run("sprt", "--scene", scene, "--bot", bad, "--bot", bad.replace("bad=sh ", "worse=sh -e "),
            "--seed", "1", "--keep-going");
        assertEquals(1, cli.status(), cli.err());
        assertTrue(cli.err().contains("20 seeds in a row tell nothing"), cli.err());
    }

    /** Three bots are three pairs of two games. */
    @Test
    void aTableSaysThatARoundIsNotComplete() {
        Path league = folder.resolve("league");
        Cli.run("league", "init", league.toString(), "--scene", scene).done();
        for (String other : new String[] {"good=sh ", "other=sh -e ", "third=sh -f "}) {
            Cli.run("league", "add", league.toString(), good.replaceFirst("^good=sh ", other)).done();
        }
        Cli.run("league", "run", league.toString(), "--games", "2").done();
        String said = Cli.run("league", "table", league.toString()).done().out();
        assertTrue(said.contains("Round 1 is not complete: 1 of 3 pairs have met in it."), said);
        Cli.run("league", "run", league.toString(), "--games", "6").done();
        said = Cli.run("league", "table", league.toString()).done().out();
        assertTrue(!said.contains("not complete"), said);
    }

    @Test
    void aReplaySaysOfAFailureWhatTheMatchSaid() {
        String replay = folder.resolve("match.jsonl").toString();
        String match = Cli.run("match", "--scene", scene, "--bot", bad, "--bot", good, "--seed", "1", "--out", replay)
            .out();
        String told = match.substring(match.indexOf("bad failed"), match.indexOf("\nReplay"));
        String shown = Cli.run("replay", replay, "--quiet").out();
        assertTrue(shown.contains(told), shown + "\nexpected: " + told);
    }

    /** Three bots, so three pairs of two games: those of the pair that fails at once are rated by nothing. */
    @Test
    void gamesInWhichAllFailAreCountedApart() {
        Path league = folder.resolve("league");
        Cli.run("league", "init", league.toString(), "--scene", scene).done();
        for (String bot : new String[] {bad, bad.replace("bad=sh ", "worse=sh -e "), good}) {
            Cli.run("league", "add", league.toString(), bot).done();
        }
        Cli.run("league", "run", league.toString(), "--games", "6", "--pause-after", "0").done();
        JsonNode table = Cli.run("league", "table", league.toString(), "--json").json();
        assertEquals(4, table.get("games").intValue(), table.toString());
        table.get("bots").forEach(bot -> assertEquals(bot.get("name").stringValue().equals("good") ? 0 : 2,
            bot.get("allFailed").intValue(), bot.toString()));
        JsonNode part = Cli.run("league", "table", league.toString(), "--last", "6", "--json").json();
        assertEquals(table.get("bots"), part.get("bots"), "a part that is the whole");
        JsonNode games = Cli.run("league", "games", league.toString(), "--failed", "--json").json();
        assertEquals(6, games.get("games").intValue());
        assertTrue(games.toString().contains("SyntaxError: a dog"), games.toString());
    }
}

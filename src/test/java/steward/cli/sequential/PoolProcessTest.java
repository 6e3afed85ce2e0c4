package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import tools.jackson.databind.JsonNode;

/** {@code steward sprt --pool}: a test against opponents of a league, of a folder and by name. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class PoolProcessTest {

    @TempDir
    private Path folder;
    private ShellBots shell;
    private String near;
    private String far;

    /** One drives to the first checkpoint and beats whoever does not. */
    @BeforeEach
    void bots() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        ShellBots.shortDuel(folder);
        ShellBots.drawn(folder.resolve("short.json"));
        shell = new ShellBots(folder);
        near = shell.driver("near", ShellBots.CHECKPOINT);
        far = shell.driver("far", "5100 99000");
    }

    private Cli test(String... more) {
        List<String> words = new ArrayList<>(List.of("sprt", "--scene", folder.resolve("short.json").toString(),
            "--bot", near, "--bot", far, "--seed", "5"));
        Stream.of(more).forEach(words::add);
        return Cli.run(words.toArray(String[]::new));
    }

    /** The new bot wins every game, the base wins half of its points at most. */
    @Test
    void theBetterOneIsFoundAgainstALeagueAndGamesAreStored() {
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", folder.resolve("short.json").toString()).done();
        for (String bot : List.of(near, shell.driver("one", ShellBots.NOWHERE), shell.driver("two", "5001 99000"))) {
            Cli.run("league", "add", league, bot).done();
        }
        JsonNode first = test("--pool", league, "--into", league, "--points1", "0.2", "--json").done().json();
        assertEquals("H1", first.get("state").stringValue());
        assertEquals(2, first.get("pool").size(), "the new bot is no opponent of its own");
        assertEquals(1, first.get("new").doubleValue());
        int games = Cli.run("league", "games", league, "--json").json().get("games").intValue();
        assertTrue(games >= 4 * first.get("seeds").intValue(), "stored: " + games);
        JsonNode again = test("--pool", "one,two", "--into", league, "--points1", "0.2", "--json").done().json();
        assertEquals(first.get("seeds"), again.get("seeds"));
        assertEquals(games, Cli.run("league", "games", league, "--json").json().get("games").intValue(),
            "all games were there");
        String text = test("--pool", league, "--points1", "0.2").done().out();
        assertTrue(text.contains("H1 is accepted: near is better against this pool"), text);
        assertTrue(text.contains("near - far against 2 opponents: expected points a game 0 (H0) or +0.2 (H1)"), text);
    }

    @Test
    void anOpponentThatFailsTenTimesInARowEndsIt() throws IOException {
        Path pool = Files.createDirectories(folder.resolve("pool/broken")).getParent();
        Files.writeString(pool.resolve("broken/run"), "sh -c 'exit 1'\n");
        Cli ended = test("--pool", pool.toString(), "--points1", "0.2", "--points0", "-0.9");
        assertEquals(ExitStatus.FAILED, ended.status(), ended.out());
        assertTrue(ended.err().contains("the test ends: broken failed in 10 games in a row"), ended.err());
    }
}

package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import tools.jackson.databind.JsonNode;

/** A bot whose file was missing for a while: it fails, is paused, and its failed games are played again. */
@Tag("process")
@Tag("slow")
class ForgiveTest {

    @TempDir
    private Path folder;

    private String done(String... words) {
        return Cli.league(folder, words).done().out();
    }

    private void play() {
        Cli.league(folder, "run", "TMP/a", "--games", "8", "--pause-after", "4", "--quiet").done();
    }

    private JsonNode bot(String name) {
        return Cli.league(folder, "table", "TMP/a", "--json").json().get("bots").valueStream()
            .filter(bot -> bot.get("name").stringValue().equals(name)).findFirst().orElseThrow();
    }

    private String games(String... more) {
        return done(Stream.concat(Stream.of("games", "TMP/a"), Stream.of(more)).toArray(String[]::new));
    }

    @Test
    void failuresOfAMissingFileAreForgivenAgainAndAgain() throws IOException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        ShellBots.shortDuel(folder);
        Path there = folder.resolve("weights");
        Path script = Files.writeString(folder.resolve("bot.sh"), "[ -e '" + there + "' ] || exit 3\n"
            + "while read -r x y nextX nextY rest && read -r other; do echo \"$nextX $nextY 100\"; done\n");
        done("init", "TMP/a", "--scene", "TMP/short.json", "--seed", "5");
        Path settings = folder.resolve("a/league.json");
        Files.writeString(settings, Files.readString(settings).replace("\"lag\": 64", "\"lag\": 1"));
        done("add", "TMP/a", "mine=codingame:sh '" + script + "'");
        done("add", "TMP/a", "one=builtin:racer");
        done("add", "TMP/a", "two=builtin:regular");
        play();

        assertTrue(bot("mine").get("paused").booleanValue());
        assertFalse(bot("one").get("paused").booleanValue());
        assertTrue(done("table", "TMP/a").contains(" mine (paused) "));
        assertTrue(done("list", "TMP/a").contains(", paused\n"));
        assertTrue(done("list", "TMP/a", "--json").contains("\"paused\":true"));
        int failed = bot("mine").get("faults").intValue();
        assertTrue(failed >= 4, () -> failed + " failures");

        Files.createFile(there);
        String again = failed + " games of mine are played again by the next run\n";
        assertEquals(again, done("forgive", "TMP/a", "mine", "--games", "1..8", "--replay"));
        done("resume", "TMP/a", "mine");
        assertFalse(bot("mine").get("paused").booleanValue(), "it is resumed");
        play();
        assertEquals(0, bot("mine").get("faults").intValue());
        assertEquals(failed, bot("mine").get("games").intValue());
        assertTrue(games("--forgiven").endsWith(failed + " games\n"), games("--forgiven"));
        assertTrue(games("--forgiven").contains(", does not count: forgiven, played again: games 1 to 8 of mine"));
        assertTrue(done("table", "TMP/a").lines().findFirst().orElseThrow().endsWith(", " + failed
            + " more forgiven"), done("table", "TMP/a"));
        String whole = games();
        play();
        assertEquals(whole, games(), "they are played again once");

        assertEquals(failed + " games of mine count again\n", done("forgive", "TMP/a", "mine", "--games", "1..8",
            "--back"));
        assertEquals(failed, bot("mine").get("faults").intValue());
        assertEquals(again, done("forgive", "TMP/a", "mine", "--games", "1..8", "--replay"));
        play();
        assertEquals(0, bot("mine").get("faults").intValue());
        assertEquals(failed, bot("mine").get("games").intValue());
        assertTrue(games("--forgiven").endsWith(2 * failed + " games\n"), games("--forgiven"));
        assertEquals("Every row can be used: " + (8 + 2 * failed) + " games\n", done("verify", "TMP/a"));

        done("export", "TMP/a", "--out", "TMP/games.jsonl");
        done("init", "TMP/b", "--scene", "TMP/short.json");
        assertEquals(8 + 2 * failed + " games stored\n", done("import", "TMP/b", "TMP/games.jsonl"));
        assertEquals(List.of(done("table", "TMP/a").lines().findFirst()),
            List.of(done("table", "TMP/b").lines().findFirst()));
    }
}

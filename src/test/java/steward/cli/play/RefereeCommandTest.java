package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code steward referee} as arena tools call it, where golden files do not reach. */
class RefereeCommandTest {

    @TempDir
    private Path folder;
    private TextShellBots bots;

    @BeforeEach
    void makeBots() {
        bots = new TextShellBots(folder);
    }

    private static Cli referee(String one, String two, String... more) {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Cli cli = Cli.run(List.of("referee", "-p1", one, "-p2", two, "-scene", "duel",
            "--no-deadline"), more);
        assertTrue(cli.err().lines().allMatch(line -> line.matches(
            "steward: warning: -p[12] has failed in turn \\d+: .*|  .*")), cli.err());
        return new Cli(cli.status(), cli.out(), "");
    }

    /** The tool takes a match without scores for a draw. */
    @Test
    @Tag("process")
    void aMatchWithoutAResultHasNegativeScores() {
        assumeTrue(Files.exists(Path.of("/dev/full")), "there is no /dev/full");
        Cli cli = Cli.run("referee", "-p1", bots.idler(0), "-p2", bots.idler(0), "-scene", "duel", "--no-deadline",
            "-r", "/dev/full");
        assertEquals(1, cli.status());
        assertEquals("-1\n-1\n", cli.out());
        assertTrue(cli.err().contains("could not be brought to a result: "), cli.err());
    }

    @Test
    @Tag("process")
    void aDrawnSeedIsToldAfterTheScores() {
        String[] lines = referee(bots.idler(1), bots.idler(2)).out().split("\n");
        assertEquals(3, lines.length);
        assertTrue(lines[2].matches("seed=\\d+"), lines[2]);
    }

    @Test
    @Tag("process")
    void theFilesAgreeWithTheScores() throws IOException {
        Path log = Files.createFile(folder.resolve("log.json"));
        Path replay = folder.resolve("match.jsonl");
        Cli cli = referee(bots.driver(), bots.idler(0), "-seed", "5", "-l", log.toString(), "-r", replay.toString(),
            "-p2name", "Mr. Y", "-league", "3", "-s");

        assertEquals("1\n0\nreplay: " + replay + "\npage: " + folder.resolve("match.html") + "\n", cli.out());
        JsonNode json = JsonMapper.shared().readTree(Files.readString(log));
        assertEquals("{\"0\":1,\"1\":0}", json.get("scores").toString());
        assertEquals("[\"seed=5\"]", json.get("uinput").toString());
        assertEquals("Mr. Y", json.get("agents").get(1).get("name").asString());
        int turns = JsonMapper.shared().readTree(json.get("metadata").asString()).get("turns").intValue();
        assertEquals(turns + 1, json.get("outputs").get("1").size());
        assertTrue(json.get("errors").get("0").get(1).asString().startsWith("[PDATA] turns = 1\n"));
        assertEquals("verified: states of " + turns + " of " + turns + " turns and the result\n",
            Cli.run("replay", replay.toString(), "--verify").out());
        assertTrue(Files.readString(folder.resolve("match.html")).startsWith("<!DOCTYPE html>"));
    }

    @Test
    @Tag("process")
    void withoutAReplayOfItsOwnThePageHasATemporaryOne() throws IOException {
        String[] lines = referee(bots.idler(1), bots.idler(1), "-seed", "5", "-s").out().split("\n");
        assertEquals(4, lines.length);
        assertTrue(lines[2].startsWith("replay: ") && lines[3].startsWith("page: "));
        assertTrue(Files.deleteIfExists(Path.of(lines[2].substring(8))));
        assertTrue(Files.deleteIfExists(Path.of(lines[3].substring(6))));
    }

    /** As a process of its own, which a tool has started: nothing but the answer, on one stream. */
    @Test
    @Tag("process")
    void printsTheScoresAndNothingElse() throws IOException, InterruptedException {
        Process process = new ProcessBuilder(JavaProcess.words(Main.class, "referee", "-scene", "duel",
            "--no-deadline", "-p1", bots.driver(), "-p2", bots.idler(2), "-d", "seed=4", "--sandbox", "off")).start();
        assertEquals("1\n-1\n", new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), err);
        assertTrue(err.startsWith("steward: warning: -p2 has failed in turn 2: line 1 of 1: ")
            && err.lines().skip(1).allMatch(line -> line.startsWith("  ")), err);
    }
}

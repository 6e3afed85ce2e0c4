package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code steward play} as rating tools call it, where golden files do not reach. */
class PlayCommandTest {

    @TempDir
    private Path folder;
    private TextShellBots bots;

    @BeforeEach
    void makeBots() {
        bots = new TextShellBots(folder);
    }

    private static JsonNode play(String one, String two, String... more) {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Cli cli = Cli.run(List.of("play", "--json-league", one, two, "--scene", "duel",
            "--no-deadline"), more);
        assertTrue(cli.err().lines().allMatch(line -> line.matches("steward: warning: .* has failed in .*|  .*")),
            cli.err());
        assertEquals(0, cli.status());
        return cli.json();
    }

    @Test
    @Tag("process")
    void aSeedIsDrawn() {
        assertTrue(play(bots.idler(1), "true").get("test_data").get("seed").isIntegralNumber());
    }

    /** Without setsid the program is started by Java itself, which makes an exception of what is the bot's failure. */
    @Test
    @Tag("process")
    void aBotThatTheSystemRefusesHasFailedWithSetsidAndWithout() throws IOException, InterruptedException {
        Path broken = Files.writeString(folder.resolve("broken"), "#!" + folder + "/no/interpreter\n");
        assumeTrue(broken.toFile().setExecutable(true) && Files.isExecutable(Path.of("/bin/sh")));
        Path programs = Files.createDirectory(folder.resolve("programs"));
        assumeTrue(Files.copy(Path.of("/bin/sh"), programs.resolve("sh")).toFile().setExecutable(true));
        assertTheOtherWins(play(broken.toString(), bots.idler(0), "--seed", "1"));
        String said = ProcessTest.shell("PATH='" + programs + "' " + ProcessTest.steward("play", "--json-league",
            "--scene", "duel", "--seed", "1", broken.toString(), bots.idler(0)));
        assertTrue(said.endsWith("\nstatus 0\n"), said);
        String line = said.lines().filter(each -> each.startsWith("{")).findFirst().orElse(said);
        assertTheOtherWins(JsonMapper.shared().readTree(line));     // beside it may stand that there is no sandbox
    }

    private static void assertTheOtherWins(JsonNode json) {
        assertEquals("[1,0]", json.get("errors").toString());
        String fault = json.get("faults").get(0).asString();
        assertTrue(fault.startsWith("exited with status 127 before answering (127: a command was not found)"), fault);
    }
}

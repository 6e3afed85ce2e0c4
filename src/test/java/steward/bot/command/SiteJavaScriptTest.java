package steward.bot.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;

class SiteJavaScriptTest {

    /** As the site's starter of the pod race begins. */
    private static final String BOT = """
        parseInt(readline());
        const checkpoints = [];
        for (let left = parseInt(readline()); left > 0; left--) checkpoints.push(readline().split(' '));
        printErr('ready');
        while (true) {
          const pods = [0, 1, 2, 3].map(() => readline().split(' '));
          for (const pod of pods.slice(0, 2)) print(`${checkpoints[pod[5]].join(' ')} 100`);
        }
        """;

    @TempDir
    private Path folder;

    @Test
    void onlyNodeWithAFileIsChanged() {
        for (List<String> words : List.of(List.of("node"), List.of("node", "--use-strict", "bot.js"),
                List.of("python3", "bot.py"), List.of("./node-bot", "x"))) {
            assertEquals(words, SiteJavaScript.words(words));
        }
        List<String> words = SiteJavaScript.words(List.of("/usr/bin/node", "bot.js", "7"));
        assertEquals(List.of("/usr/bin/node", "-e"), words.subList(0, 2));
        assertEquals(List.of("bot.js", "7"), words.subList(3, 5));
    }

    @Test
    @Tag("process")
    void linesAreReadAndPrintedAndItsEndIsTheEndOfTheProgram() throws IOException, InterruptedException {
        assumeTrue(ProgramFinder.find("node") != null, "there is no node");
        Path bot = Files.writeString(folder.resolve("bot.js"),
            "print(require.main === module, process.argv[2], readline(), readline()); while (true) print(readline());");
        for (String file : List.of(bot.toString(), "bot.js", "./bot.js")) {
            Process node = new ProcessBuilder(SiteJavaScript.words(List.of("node", file, "7")))
                .directory(folder.toFile()).start();
            node.getOutputStream().write("one\r\ntwo\nthree\n".getBytes(StandardCharsets.UTF_8));
            node.getOutputStream().close();
            assertEquals("true 7 one two\nthree\n",
                new String(node.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
            assertEquals(0, node.waitFor());
        }
    }

    @Test
    @Tag("process")
    @Tag("slow")
    void aBotOfTheSitePlaysUnchanged() throws IOException {
        assumeTrue(ProgramFinder.find("node") != null, "there is no node");
        Path bot = Files.writeString(folder.resolve("bot.js"), BOT);
        Cli cli = Cli.run("match", "--bot", "codingame:node " + bot, "--bot", "builtin:racer", "--seed", "1",
            "--time-factor", "100", "--strict", "--quiet").done();
        assertTrue(cli.out().contains("laps") || cli.out().contains("turns"), cli.out());
    }
}

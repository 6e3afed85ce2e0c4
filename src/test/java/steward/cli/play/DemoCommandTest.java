package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.BuiltinBots;
import steward.cli.Cli;

/** {@code steward demo}. */
@Tag("process")
class DemoCommandTest {

    @TempDir
    private Path folder;

    @Test
    void itIsPlayedVerifiedAndDrawn() {
        assumeTrue(BuiltinBots.installed().names().containsAll(List.of("racer", "veteran")),
            "the bundled bots are not on the class path");
        Path file = folder.resolve("a folder/demo.jsonl");
        Cli cli = Cli.run("demo", "--out", file.toString()).done();
        assertTrue(cli.out().startsWith("steward match --scene mad-pod-racing --bot builtin:veteran "), cli.out());
        assertTrue(cli.out().contains("    --time-factor 10 --out '" + file + "' --overwrite\n"), cli.out());
        assertTrue(cli.out().contains(" turns played again, every one the same to the last bit\n"), cli.out());
        List<String> map = cli.out().lines().dropWhile(line -> !line.startsWith("+-")).toList();
        assertTrue(map.size() <= 29, cli.out());
        assertTrue(map.stream().allMatch(line -> line.length() <= 100), cli.out());
        assertTrue(map.stream().anyMatch(line -> line.contains("(0)")), cli.out());
        assertTrue(map.get(map.size() - 1).startsWith("a b veteran    C D racer"), cli.out());
    }

    @Test
    void asJsonItIsTheMatch() {
        assumeTrue(BuiltinBots.installed().names().containsAll(List.of("racer", "veteran")),
            "the bundled bots are not on the class path");
        Cli cli = Cli.run("demo", "--json", "--out", folder.resolve("demo.jsonl").toString()).done();
        assertEquals("veteran", cli.json().get("players").get(0).get("name").stringValue());
        assertEquals(1, cli.out().lines().count(), cli.out());
    }

    /** More than two bots come with the program, so the help says which two race. */
    @Test
    void theHelpNamesTheBotsThatRace() {
        String help = Cli.run("demo", "--help").out().replaceAll("\\s+", " ");
        assertTrue(help.contains("Plays two of the bots that come with the program, veteran and racer, "), help);
    }

    @Test
    void onlyInTheProjectItWritesUnderBuild() {
        assertEquals("build/demo.jsonl", DemoCommand.usualFile(Path.of("")));
        Path elsewhere = Path.of(DemoCommand.usualFile(folder));
        assertTrue(elsewhere.isAbsolute() && !elsewhere.startsWith(folder), elsewhere.toString());
        assertTrue(elsewhere.getParent().toFile().delete(), "the folder is new and empty");
    }
}

package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Colour;
import tools.jackson.databind.JsonNode;

/** Report and files of a series. */
@Tag("process")
@Timeout(120)
class SeriesReportTest {

    /** Fails in turn 3, saying so, if its pod is the first. */
    private static final String SOMETIMES = "sh -c 'n=0; read -r s; "
        + "case $s in *player\\\":0*) last=3;; *) last=99;; esac; while read -r l; do "
        + "n=$((n + 1)); [ $n = $last ] && { echo \"no idea\" >&2; exit 4; }; "
        + "echo \"{\\\"pods\\\":[{\\\"x\\\":10500,\\\"y\\\":3500,\\\"thrust\\\":100}]}\"; done'";

    @TempDir
    private Path folder;
    private ShellBots bots;

    @BeforeEach
    void shell() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        bots = new ShellBots(folder);
    }

    private Cli series(String first, String second, String... more) {
        return Cli.run(Stream.concat(Stream.of("match", "--scene", "duel", "--no-deadline", "--seed", "5", "--bot",
            first, "--bot", second), Stream.of(more)).toArray(String[]::new));
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void timesScoresAndFaultsAreTold() {
        Path replays = folder.resolve("replays");
        String out = series("me=" + SOMETIMES, bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--swap", "--out",
            replays.toString()).out();
        assertTrue(out.matches("""
            (?s)4 games of duel, seeds 5 to 6, each with every order of sides; .*
            bot    wins   draws  losses  faults  points   95% interval    mean score
            me        1       0       1       2   0\\.500   0\\.000 to 1\\.000  .*
            far       1       0       1       0   0\\.500   .*
            bot answers   mean ms    p99 ms  worst ms  first ms   worst in
            me +\\d+ +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+   game \\d, turn \\d+
            far .*
            me failed in 2 games, first in game 1 \\(seed 5\\) in turn 3: exited with status 4 before answering
              its stderr says: no idea
              replay: .*game-0001\\.jsonl
              also in game 3, turn 3

            Replays: .*game-0001\\.jsonl to .*game-0004\\.jsonl
            """), out);
    }

    @Test
    void jsonHasThemToo() {
        JsonNode json = series("me=" + SOMETIMES, bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--swap",
            "--json").json();
        assertFalse(json.get("interrupted").booleanValue());
        assertTrue(json.get("stopped").isNull());
        assertEquals(4, json.get("planned").intValue());
        assertEquals(4, json.get("results").intValue());
        assertEquals("{\"bot\":0,\"games\":2,\"game\":1,\"seed\":\"5\",\"fault\":\"exited with status 4 before "
            + "answering\",\"turn\":3,\"error\":\"no idea\",\"stderr\":[\"no idea\"],\"hints\":[],\"time\":null,"
            + "\"replay\":null}",
            json.get("failures").get(0).toString());
        assertEquals("[3,null]", json.get("list").get(0).get("faultTurns").toString());
        assertEquals("[null,null]", json.get("list").get(1).get("faultTurns").toString());
        assertEquals(2, json.get("list").get(1).get("scores").size());
        assertTrue(json.get("bots").get(1).get("meanScore").isNumber());
        JsonNode me = json.get("times").get(0);
        // Two games end in turn 3: one answer and the failure each without the first; two others last 51 turns.
        assertEquals(2 * 2 + 2 * 50, me.get("answers").intValue());
        assertTrue(me.get("mean").doubleValue() <= me.get("worst").doubleValue());
        assertTrue(me.get("p99").doubleValue() <= me.get("worst").doubleValue());
        assertTrue(me.get("worstGame").intValue() >= 1 && me.get("worstTurn").intValue() >= 2);
        assertTrue(me.get("worstFirst").doubleValue() >= me.get("meanFirst").doubleValue());
    }

    @Test
    void quietIsOneLineWithTheFaults() {
        assertEquals("4 games of duel: me 0.500, far 0.500; me failed in 2\n", series("me=" + SOMETIMES,
            bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--swap", "--quiet").out());
        assertEquals("2 games of duel: near 1.000, far 0.000\n", series(bots.driver("near", ShellBots.CHECKPOINT),
            bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--quiet").out());
    }

    @Test
    void gamesInWhichBothFailTogetherAreTold() {
        String out = series("false", "false", "--games", "2").out();
        assertTrue(out.contains("Both bots failed in the same turn in 2 games (game 1; game 2): they count in no "
            + "points.\n"), out);
        assertEquals(1, out.split(" failed in 2 games, first in game 1 ", -1).length - 1, "said once: " + out);
    }

    /** Where there is no terminal, no test of this class sees a colour. */
    @Test
    void aTerminalSeesFaultsInColour() {
        Colour colour = Colour.of(true);
        String out = Cli.run(true, "match", "--scene", "duel", "--bot", "me=false", "--bot", "b=false", "--games",
            "2").out();
        assertTrue(out.startsWith(colour.strong("2 games of duel") + ", seeds "), out);
        assertTrue(out.contains(colour.bad("       2") + colour.strong("       -")), out);
        assertTrue(out.contains("\nme and b " + colour.bad("failed") + " in 2 games, first in game 1 "), out);
        assertTrue(out.contains("\n" + colour.warning("Both bots failed") + " in the same turn"), out);
    }

    @Test
    void aTerminalSeesThePlayInColour() {
        String out = Cli.run(true, "match", "--scene", "duel", "--bot", "me=false", "--bot", "b=false").out();
        assertTrue(out.contains("turn   1  " + Colour.of(true).bad("me is out: exited with status 1 before answering")),
            out);
    }

    @Test
    void theProgressSaysHowItStands() {
        Cli cli = Cli.run(true, "match", "--scene", "duel", "--bot", "me=true", "--bot", "false", "--games", "2");
        assertTrue(cli.err().contains("me -"), cli.err());
    }

    @ParameterizedTest
    @CsvSource({"all, 0001 0002 0003 0004", "lost, 0001 0003", "failed, 0001 0003"})
    void onlyWhatIsAskedForIsKept(String which, String kept) throws IOException {
        Path replays = folder.resolve("replays");
        Cli cli = series("me=" + SOMETIMES, bots.driver("far", ShellBots.NOWHERE), "--games", "2", "--swap", "--out",
            replays.toString(), "--keep", which, "--json");
        assertEquals(Stream.of(kept.split(" ")).map(number -> "game-" + number + ".jsonl").toList(), names(replays));
        JsonNode list = cli.json().get("list");
        for (int k = 0; k < 4; k++) {
            Path file = replays.resolve("game-000" + (k + 1) + ".jsonl");
            assertEquals(Files.exists(file) ? file.toString() : null, list.get(k).get("replay").stringValue(null));
        }
    }

    @Test
    void whereNothingIsKeptNothingIsWritten() {
        Path replays = folder.resolve("replays");
        assertEquals(ExitStatus.DONE, series("false", "false", "--games", "2", "--out", replays.toString(), "--keep",
            "none").status());
        assertFalse(Files.exists(replays));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--games 2 --keep all | --keep: expected --out with it",
        "--games 2 --keep some --out x | --keep: found 'some', expected all, lost, failed or none",
        "--keep all --out x | --keep is for many games, expected --games or --swap with it",
        "--games 2 --threads many | --threads: found 'many', expected 1 to 256, or auto",
        "--games 2 --threads 0 | --threads: found '0', expected 1 to 256, or auto",
        "--threads auto | --threads is for many games, expected --games or --swap with it"})
    void wrongOptionsAreRefused(String options, String problem) {
        Cli cli = series("false", "false", options.split(" "));
        assertEquals(ExitStatus.UNUSABLE, cli.status());
        assertTrue(cli.err().startsWith("steward: " + problem + "\n"), cli.err());
    }

    @Test
    void moreThreadsThanProcessorsAreAWarning() {
        int processors = Runtime.getRuntime().availableProcessors();
        assumeTrue(processors < 256, "so many threads are not to be had");
        Cli many = series("false", "false", "--games", "1", "--threads", Integer.toString(processors + 1), "--json");
        assertTrue(many.err().startsWith("steward: warning: --threads " + (processors + 1) + " are more games at a "
            + "time than the " + processors), many.err());
        assertEquals(1, many.json().get("games").intValue());
        assertEquals("", series("false", "false", "--games", "1", "--threads", "auto").err());
    }

    /** A full disk, to which a link leads; what was there before the series stays. */
    @Test
    void aFullDiskEndsTheSeries() throws IOException {
        assumeTrue(Files.isWritable(Path.of("/dev/full")), "there is no /dev/full");
        Path replays = Files.createDirectory(folder.resolve("replays"));
        Path full = Files.createSymbolicLink(replays.resolve("game-0002.jsonl"), Path.of("/dev/full"));
        Cli cli = series(bots.driver("near", ShellBots.CHECKPOINT), bots.driver("far", ShellBots.NOWHERE), "--games",
            "3", "--out", replays.toString(), "--overwrite", "--json");
        Files.delete(full);
        assertEquals(ExitStatus.FAILED, cli.status());
        assertEquals("steward: game 2 could not be brought to a result: " + full + ": cannot be written: No space left "
            + "on device\n"
            + "steward: the series ends after 2 of 3 games, because a replay could not be written; make room, or call "
            + "with --keep none\n", cli.err());
        assertEquals(List.of("game-0001.jsonl"), names(replays));
        assertEquals(2, cli.json().get("games").intValue());
        assertEquals(1, cli.json().get("results").intValue());
        assertTrue(cli.json().get("stopped").stringValue().startsWith(full + ": cannot be written: "));
    }
}

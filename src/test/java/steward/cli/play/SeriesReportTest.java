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
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Colour;

/** Report and files of a series where golden files do not reach: terminals, processors, full disks. */
@Tag("process")
@Timeout(120)
class SeriesReportTest extends ShellBotsCase {

    private Cli series(String first, String second, String... more) {
        return Cli.run(List.of("match", "--scene", "duel", "--no-deadline", "--seed", "5", "--bot",
            first, "--bot", second), more);
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
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
        assertTrue(cli.err().contains("me -") && cli.err().contains("games 100%"), cli.err());
    }

    @Test
    void whereNothingIsKeptNothingIsWritten() {
        Path replays = folder.resolve("replays");
        assertEquals(ExitStatus.DONE, series("false", "false", "--games", "2", "--out", replays.toString(), "--keep",
            "none").status());
        assertFalse(Files.exists(replays));
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

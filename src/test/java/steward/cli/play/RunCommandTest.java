package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;

/** {@code steward run}: a scene without players, its replay, its tables. */
class RunCommandTest {

    @TempDir
    private Path temp;

    @Test
    void aRunIsRecordedVerifiedAndTabled() throws IOException {
        Path replay = temp.resolve("c.jsonl");
        Path tables = temp.resolve("tables");
        Cli run = Cli.run("run", "cradle", "--seed", "7", "--out", replay.toString(), "--csv", tables.toString());
        assertEquals(ExitStatus.DONE, run.status(), run.err());
        assertTrue(run.out().startsWith("cradle, seed 7, event/double: 40 turns, at most 40 turns are played\n"),
            run.out());
        List<String> turns = Files.readAllLines(tables.resolve("turns.csv"));
        assertEquals("turn,energy,momentumX,momentumY,impacts", turns.get(0));
        assertEquals("0,800.0,40.0,0.0,0", turns.get(1));
        assertTrue(turns.get(41).startsWith("40,800.0,"), turns.get(41));
        assertEquals(1 + 41 * 6, Files.readAllLines(tables.resolve("states.csv")).size());
        long impacts = turns.stream().skip(1).mapToLong(row -> Long.parseLong(row.replaceFirst(".*,", ""))).sum();
        assertEquals(1 + impacts, Files.readAllLines(tables.resolve("impacts.csv")).size());
        assertEquals(ExitStatus.DONE, Cli.run("replay", replay.toString(), "--verify").status());
    }

    @Test
    void fewerTurnsStandInTheScene() {
        Path replay = temp.resolve("g.jsonl");
        Cli run = Cli.run("run", "gas", "--turns", "2", "--accuracy", "step/4", "--out", replay.toString());
        assertTrue(run.out().contains("step/4: 2 turns, at most 2 turns are played"),
            run.out());
        assertEquals(ExitStatus.DONE, Cli.run("replay", replay.toString(), "--verify").status());
    }

    /** 4,500 bodies: every third state is kept, and the last. */
    @Test
    @Tag("slow")
    void aReplayOfManyBodiesIsSparse() throws IOException {
        Path scene = temp.resolve("many.json");
        Files.writeString(scene, """
            { "name": "many", "game": "bodies", "players": 0,
              "field": { "width": 3000, "height": 3000, "walls": "box" },
              "bodies": { "fill": { "shape": "lattice", "count": 4500, "radius": 10, "speed": 20 } },
              "play": { "maximumTurns": 5 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
            """);
        Path replay = temp.resolve("m.jsonl");
        assertEquals(ExitStatus.DONE, Cli.run("run", scene.toString(), "--out", replay.toString()).status());
        List<String> kept = Files.readAllLines(replay).stream().filter(line -> line.startsWith("{\"type\":\"turn\""))
            .map(line -> line.contains("\"state\"") ? "state" : line.contains("\"hash\"") ? "hash" : "").toList();
        assertEquals(List.of("hash", "hash", "state", "hash", "state"), kept);
        assertEquals(ExitStatus.DONE, Cli.run("replay", replay.toString(), "--verify").status());
        Files.writeString(replay, Files.readString(replay).replaceFirst("\"hash\":\"(.)", "\"hash\":\"x"));
        assertEquals(ExitStatus.FAILED, Cli.run("replay", replay.toString(), "--verify").status());
    }

    @Test
    void whatIsNotARunIsRefused() {
        Cli players = Cli.run("run", "duel");
        assertEquals(ExitStatus.UNUSABLE, players.status());
        assertEquals("steward: found a scene for 2 players, expected one for 0: 'steward match' plays it between "
            + "bots\n", players.err());
        assertEquals(ExitStatus.UNUSABLE, Cli.run("run", "gas", "--turns", "0").status());
    }
}

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
        assertEquals("turn,energy,momentumX,momentumY,impacts,potential,limitTime", turns.get(0));
        assertEquals("0,800.0,40.0,0.0,0,0.0,", turns.get(1));
        assertTrue(turns.get(41).startsWith("40,800.0,"), turns.get(41));
        assertEquals(1 + 41 * 6, Files.readAllLines(tables.resolve("states.csv")).size());
        long impacts = turns.stream().skip(1).mapToLong(row -> Long.parseLong(row.split(",")[4])).sum();
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

    /** A disc of infinite mass presses another against the right side of the box, and leaves it in turn 19 itself. */
    @Test
    void turnsAtTheBoundAndBodiesThatLeaveAreNamed() throws IOException {
        Path scene = temp.resolve("piston.json");
        Files.writeString(scene, """
            { "name": "piston", "game": "bodies", "players": 0,
              "field": { "width": 1000, "height": 1000, "walls": "box" },
              "impacts": { "maximumImpactsPerTurn": 100 },
              "bodies": { "listed": [ { "x": 500, "y": 500, "radius": 20 },
                { "x": 100, "y": 500, "vx": 50, "radius": 30, "mass": "infinite" } ] },
              "play": { "maximumTurns": 20 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
            """);
        Path tables = temp.resolve("piston");
        Cli run = Cli.run("run", scene.toString(), "--csv", tables.toString());
        assertEquals(ExitStatus.DONE, run.status(), run.err());
        assertTrue(run.out().contains("4 of 20 turns reached the bound on impacts, the first of them turn 17: "),
            run.out());
        assertTrue(run.err().contains("piston.json:5:5: found a body of infinite mass that leaves the field in turn 19 "
            + "of 20, expected one that stays in it: no wall holds it"), run.err());
        List<String> turns = Files.readAllLines(tables.resolve("turns.csv"));
        assertTrue(turns.get(2).endsWith(",0.0,"), turns.get(2));
        assertTrue(Double.parseDouble(turns.get(20).replaceFirst(".*,", "")) < 1, turns.get(20));
        Cli json = Cli.run("run", scene.toString(), "--json");
        assertTrue(json.out().contains("\"limitTime\":null") && json.out().contains("\"limitTime\":0."), json.out());
    }

    /** In free flight the sum of (v + a/2)^2 / 2 and minus a times the way is that of the start, 1/2 for a = 2. */
    @Test
    void energyAndPotentialAddUpInFreeFlight() throws IOException {
        Path scene = temp.resolve("fall.json");
        Files.writeString(scene, """
            { "name": "fall", "game": "bodies", "players": 0, "field": { "width": 1000, "height": 1000 },
              "bodies": { "listed": [ { "x": 500, "y": 100, "radius": 20 } ] },
              "play": { "maximumTurns": 10, "gravity": { "x": 0, "y": 2 } },
              "accuracy": { "advance": "event", "arithmetic": "double" } }
            """);
        Path tables = temp.resolve("fall");
        Cli run = Cli.run("run", scene.toString(), "--csv", tables.toString());
        assertTrue(run.out().contains("potential"), run.out());
        for (String row : Files.readAllLines(tables.resolve("turns.csv")).subList(1, 12)) {
            String[] cells = row.split(",");
            assertEquals(0.5, Double.parseDouble(cells[1]) + Double.parseDouble(cells[5]), 1e-12, row);
        }
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

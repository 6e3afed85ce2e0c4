package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.Main;
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
        assertEquals("turn,energy [m u^2/turn^2],momentumX [m u/turn],momentumY [m u/turn],impacts", turns.get(0)
            .substring(0, turns.get(0).indexOf(",potential")));
        assertTrue(turns.get(1).startsWith("0,800.0,40.0,0.0,0,0.0,,0.0,0.0,"), turns.get(1));
        assertTrue(turns.get(41).startsWith("40,800.0,"), turns.get(41));
        assertEquals(1 + 41 * 6, Files.readAllLines(tables.resolve("states.csv")).size());
        long impacts = turns.stream().skip(1).mapToLong(row -> Long.parseLong(row.split(",")[4])).sum();
        assertEquals(1 + impacts, Files.readAllLines(tables.resolve("impacts.csv")).size());
        assertEquals(ExitStatus.DONE, Cli.run("replay", replay.toString(), "--verify").status());
    }

    /** A run that is ended before its time: whole turns in each file, and in all tables as many. */
    @Test
    @Tag("process")
    void anInterruptedRunLeavesWholeTurns() throws IOException, InterruptedException {
        Path replay = temp.resolve("g.jsonl");
        Path tables = temp.resolve("tables");
        Path errors = temp.resolve("errors");
        Process run = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
            System.getProperty("java.class.path"), Main.class.getName(), "run", "gas", "--turns", "1000000", "--seed",
            "7", "--out", replay.toString(), "--csv", tables.toString()).redirectError(errors.toFile())
            .redirectOutput(temp.resolve("out").toFile()).start();
        try {
            for (int k = 0; k < 1200 && !(Files.exists(replay) && Files.size(replay) > 1 << 20); k++) {
                Thread.sleep(50);
            }
        } finally {
            run.destroy();
            run.waitFor();
        }
        assertEquals("steward: interrupted; the turns so far are in " + replay + " and " + tables + "\n",
            Files.readString(errors));
        List<String> turns = Files.readAllLines(tables.resolve("turns.csv"));
        int last = turns.size() - 2;
        assertTrue(last > 2, "turns " + last);
        List<String> states = Files.readAllLines(tables.resolve("states.csv"));
        long bodies = states.stream().filter(row -> row.startsWith("0,")).count();
        assertEquals(1 + (last + 1) * bodies, states.size());
        assertEquals(bodies, states.stream().filter(row -> row.startsWith(last + ",")).count());
        assertEquals(1 + turns.stream().skip(1).mapToLong(row -> Long.parseLong(row.split(",")[4])).sum(),
            Files.readAllLines(tables.resolve("impacts.csv")).size());
        for (String name : List.of("turns.csv", "states.csv", "impacts.csv")) {
            assertTrue(Files.readString(tables.resolve(name)).endsWith("\n"), name);
        }
        Cli verified = Cli.run("replay", replay.toString(), "--verify");
        assertTrue(verified.out().startsWith("verified up to the cut"), verified.out() + verified.err());
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
        Cli run = Cli.run("run", scene.toString(), "--csv", tables.toString()).done();
        assertTrue(run.out().contains("4 of 20 turns reached the bound on impacts, the first of them turn 17: "),
            run.out());
        assertTrue(run.err().contains("piston.json:5:5: found a body of infinite mass that leaves the field in turn 19 "
            + "of 20, expected one that stays in it: no wall holds it"), run.err());
        List<String> turns = Files.readAllLines(tables.resolve("turns.csv"));
        assertTrue(turns.get(2).contains(",0.0,,0.0,0.0,"), turns.get(2));
        assertTrue(Double.parseDouble(turns.get(20).split(",")[6]) < 1, turns.get(20));
        Cli json = Cli.run("run", scene.toString(), "--json");
        assertTrue(json.out().contains("\"limitTime\":null") && json.out().contains("\"limitTime\":0."), json.out());
    }

    /**
     * A light disc between a wall and a heavy one, e = 0.9: their impacts collapse, and what is left rests. The table
     * tells how much that was.
     */
    @Test
    void energyLostToRestIsTold() throws IOException {
        Path scene = temp.resolve("squeeze.json");
        Files.writeString(scene, """
            { "name": "squeeze", "game": "bodies", "players": 0, "field": { "width": 1000, "height": 1000,
                "walls": [ { "type": "half-plane", "x": 0, "y": 0, "insideX": 1, "insideY": 0 } ] },
              "bodies": { "listed": [ { "x": 10, "y": 500, "radius": 10, "restitution": 0.9 },
                { "x": 60, "y": 500, "vx": -50, "radius": 10, "mass": 3000, "restitution": 0.9 } ] },
              "play": { "maximumTurns": 20 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
            """);
        Path tables = temp.resolve("squeeze");
        Cli run = Cli.run("run", scene.toString(), "--csv", tables.toString());
        assertTrue(run.out().contains("Rest took the energy "), run.out());
        double sum = 0;
        double before = 0;
        for (String row : Files.readAllLines(tables.resolve("turns.csv")).subList(1, 22)) {
            String[] cells = row.split(",", -1);
            double rest = Double.parseDouble(cells[7]);
            assertTrue(rest >= 0 && rest <= 1e-6 * before, row);
            sum += rest;
            assertEquals(sum, Double.parseDouble(cells[8]), row);
            before = Double.parseDouble(cells[1]);
        }
        assertTrue(sum > 0);
        assertTrue(Cli.run("run", scene.toString(), "--json").out().contains("\"restSum\":"));
    }

    /** Whether and when a fill of infinite mass leaves is said when the scene is opened, for any seed. */
    @Test
    void fillsOfInfiniteMassThatLeaveAreNamed() throws IOException {
        Path scene = temp.resolve("unstoppable.json");
        for (String[] each : new String[][] {{"50", "leave the field by turn 41 of 60"},
            {"[1, 50]", "may leave the field within 60 turns"}, {"0.1", ""}}) {
            Files.writeString(scene, """
                { "name": "unstoppable", "game": "bodies", "players": 0,
                  "field": { "width": 1000, "height": 1000, "walls": "box" },
                  "bodies": { "fill": { "count": 2, "radius": 10, "mass": "infinite", "speed": SPEED,
                    "in": { "x": 500, "y": 500, "radius": 100 } } },
                  "play": { "maximumTurns": 60 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
                """.replace("SPEED", each[0]));
            Cli run = Cli.run("run", scene.toString());
            assertEquals(each[1].isEmpty() ? "" : "unstoppable.json:3:23: found bodies of infinite mass that "
                + each[1] + ", expected ones that stay in it: no wall holds them",
                run.err().replaceFirst("^.*(?=unstoppable.json)", "").strip(), run.err());
        }
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

    /**
     * Two discs in free flight, in rational numbers: after n turns v = v0 + n a, y = y0 + n v0 + a n (n + 1) / 2. The
     * sum of m (v + a/2)^2 / 2 and of -m a (y - y0) is the same after every turn.
     */
    @Test
    void energyOfFreeFlightIsThatOfRationalNumbers() throws IOException {
        Path scene = temp.resolve("flight.json");
        Files.writeString(scene, """
            { "name": "flight", "game": "bodies", "players": 0, "field": { "width": 1000, "height": 1000 },
              "bodies": { "listed": [ { "x": 100, "y": 100.1, "vy": -3.3, "radius": 20, "mass": 3 },
                { "x": 500, "y": 700.7, "vy": 1.9, "radius": 20, "mass": 0.7 } ] },
              "play": { "maximumTurns": 30, "gravity": { "x": 0, "y": 0.7 } },
              "accuracy": { "advance": "event", "arithmetic": "double" } }
            """);
        Path tables = temp.resolve("flight");
        assertEquals(ExitStatus.DONE, Cli.run("run", scene.toString(), "--csv", tables.toString()).status());
        BigDecimal half = new BigDecimal("0.5");
        BigDecimal a = new BigDecimal("0.7");
        BigDecimal start = null;
        for (int n = 0; n <= 30; n++) {
            BigDecimal energy = BigDecimal.ZERO;
            BigDecimal potential = BigDecimal.ZERO;
            for (String[] disc : new String[][] {{"3", "-3.3"}, {"0.7", "1.9"}}) {
                BigDecimal mass = new BigDecimal(disc[0]);
                BigDecimal turns = new BigDecimal(n);
                BigDecimal v = new BigDecimal(disc[1]).add(turns.multiply(a));
                BigDecimal end = v.add(a.multiply(half));
                BigDecimal way = turns.multiply(new BigDecimal(disc[1]))
                    .add(a.multiply(half).multiply(turns).multiply(turns.add(BigDecimal.ONE)));
                energy = energy.add(mass.multiply(end).multiply(end).multiply(half));
                potential = potential.subtract(mass.multiply(a).multiply(way));
            }
            start = start == null ? energy : start;
            assertEquals(0, start.compareTo(energy.add(potential)), "turn " + n);
            String[] cells = Files.readAllLines(tables.resolve("turns.csv")).get(n + 1).split(",", -1);
            assertEquals(energy.doubleValue(), Double.parseDouble(cells[1]), 1e-13 * energy.doubleValue());
            assertEquals(potential.doubleValue(), Double.parseDouble(cells[5]), 1e-11);
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
}

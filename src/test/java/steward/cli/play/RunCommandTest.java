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
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.shared.ExitStatus;

/** {@code steward run}: a scene without players, its replay, its tables. */
class RunCommandTest {

    @TempDir
    private Path temp;

    /** A run that is ended before its time: whole turns in each file, and in all tables as many. */
    @Test
    @Tag("process")
    void anInterruptedRunLeavesWholeTurns() throws IOException, InterruptedException {
        Path replay = temp.resolve("g.jsonl");
        Path tables = temp.resolve("tables");
        Path errors = temp.resolve("errors");
        Process run = new ProcessBuilder(JavaProcess.words(Main.class, "run", "gas", "--turns", "1000000", "--seed",
            "7", "--out", replay.toString(), "--csv", tables.toString())).redirectError(errors.toFile())
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

    /** A disc on the floor is at rest from the first turn on. Discs without loss are not counted. */
    @Test
    void aTerminalIsToldHowManyRest() throws IOException {
        for (double restitution : new double[] {0.5, 1}) {
            Path scene = temp.resolve(restitution + ".json");
            Files.writeString(scene, """
                { "name": "floor", "game": "bodies", "players": 0, "field": { "width": 1000, "height": 1000,
                    "walls": "box" },
                  "bodies": { "listed": [ { "x": 100, "y": 980, "radius": 20, "restitution": %s } ] },
                  "play": { "maximumTurns": 3, "gravity": { "x": 0, "y": 0.7 } },
                  "accuracy": { "advance": "event", "arithmetic": "double" } }
                """.formatted(restitution));
            Cli run = Cli.run(true, "run", scene.toString()).done();
            assertEquals(restitution < 1, run.err().contains("1 of 1 at rest"), run.err());
            assertTrue(run.err().contains("3/3"), run.err());
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

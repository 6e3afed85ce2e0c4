package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.Cli;

/** Tables of {@code steward run}: what follows from them. The recorded outputs have every column. */
class RunTablesTest {

    @TempDir
    private Path temp;

    private Path run(String scene) throws IOException {
        Path file = temp.resolve("s.json");
        Files.writeString(file, scene);
        Path tables = temp.resolve("tables");
        Cli.run("run", file.toString(), "--seed", "5", "--csv", tables.toString()).done();
        return tables;
    }

    private static String scene(String play) {
        return """
            { "name": "box", "game": "bodies", "players": 0,
              "field": { "x": -100, "y": 50, "width": 800, "height": 400,
                "walls": { "type": "box", "restitution": 0.9 }, "bumpers": [ { "x": 300, "y": 250, "radius": 40 } ] },
              "bodies": { "listed": [ { "x": -50, "y": 100, "vx": 50, "vy": 20, "radius": 15, "mass": 3 } ],
                "fill": [ { "count": 20, "radius": 10, "speed": 90, "mass": 2, "restitution": 0.8 },
                  { "count": 20, "radius": [5, 10], "speed": 90, "drag": 0.01 } ] },
              "play": { "maximumTurns": 12 PLAY }, "accuracy": { "advance": "event", "arithmetic": "double" } }
            """.replace("PLAY", play);
    }

    /**
     * D. Henderson, "A simple equation of state for hard discs", 1975: Z = (1 + f^2 / 8) / (1 - f)^2 with the covered
     * share f, true to 0.1% here. Centres have 1780 x 1780 u, and press on walls of 1800 u. In 150 turns the mean of
     * the virial is off by 0.3%, that of what the walls took by 5%.
     */
    @Test
    @Tag("slow")
    void aGasHasThePressureOfItsEquationOfState() throws IOException {
        Path tables = temp.resolve("gas");
        assertEquals(0, Cli.run("run", "gas", "--seed", "4", "--turns", "200", "--csv", tables.toString()).status());
        List<String> turns = Files.readAllLines(tables.resolve("turns.csv"));
        double area = 1780.0 * 1780;
        double covered = 1000 * Math.PI * 100 / area;
        double expected = cell(turns, 51, "temperature") * 1000 / area * (1 + covered * covered / 8)
            / ((1 - covered) * (1 - covered)) * 1780 / 1800;
        assertEquals(expected, mean(turns, "pressureVirial"), 0.01 * expected);
        assertEquals(expected, mean(turns, "pressureWalls"), 0.12 * expected);
    }

    private static double cell(List<String> rows, int turn, String column) {
        int place = List.of(rows.get(0).replaceAll(" \\[[^]]*]", "").split(",")).indexOf(column);
        return Double.parseDouble(rows.get(1 + turn).split(",", -1)[place]);
    }

    private static double mean(List<String> rows, String column) {
        return IntStream.rangeClosed(51, 200).mapToDouble(turn -> cell(rows, turn, column)).average().orElseThrow();
    }

    /** Twelve turns, and a scene that begins with the table of the first seven: the last five are the same bits. */
    @ParameterizedTest
    @ValueSource(strings = {"", ", \"gravity\": { \"x\": 0, \"y\": 2 }",
        ", \"zones\": [ { \"x\": 600, \"y\": 400, \"radius\": 60, \"label\": \"p\", \"removes\": true } ]"})
    void aTableOfStatesGoesOnWithTheSameBits(String play) throws IOException {
        List<String> all = Files.readAllLines(run(scene(play)).resolve("states.csv"));
        Path tables = temp.resolve("seven");
        assertEquals(0, Cli.run("run", temp.resolve("s.json").toString(), "--seed", "5", "--turns", "7", "--csv",
            tables.toString()).status());
        String next = scene(play).replaceFirst("(?s)\"listed\".*?\\] \\},", "\"csv\": \"states.csv\" },")
            .replace("\"maximumTurns\": 12", "\"maximumTurns\": 5");
        Files.writeString(tables.resolve("next.json"), next);
        Cli run = Cli.run("run", tables.resolve("next.json").toString(), "--csv", temp.resolve("five").toString());
        assertEquals(0, run.status(), run.err());
        List<String> after = Files.readAllLines(temp.resolve("five").resolve("states.csv"));
        List<String> last = all.stream().filter(row -> row.startsWith("12,")).map(RunTablesTest::withoutId).toList();
        assertEquals(last, after.stream().filter(row -> row.startsWith("5,")).map(RunTablesTest::withoutId).toList());
        assertTrue(last.size() > 20 && last.size() < 41 == play.contains("zones"), last.size() + " are left");
    }

    private static String withoutId(String row) {
        return row.split(",", 3)[2];
    }
}

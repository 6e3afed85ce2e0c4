package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;

/**
 * Tables of {@code steward run}: every column follows from the others. Products and sums of the doubles in them are
 * exact here, roots and quotients have 60 digits; what is compared may be off by some roundings of its terms.
 */
@Execution(ExecutionMode.CONCURRENT)
class RunTablesTest {

    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal PI = new BigDecimal("3.1415926535897932384626433832795028841971693993751");
    /** Rounding of a term, with room for the sums of a hundred. */
    private static final double TERMS = 1e-13;

    @TempDir
    private Path temp;

    /** A row by its columns, units left out; an empty cell is absent. */
    private record Row(Map<String, BigDecimal> cells) {

        BigDecimal of(String column) {
            return cells.get(column);
        }

        BigDecimal of(String body, String part) {
            return cells.get(part.startsWith("v") ? part.substring(0, 1) + body + part.substring(1) : body + part);
        }

        int number(String column) {
            return cells.get(column).intValueExact();
        }
    }

    private static List<Row> read(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        String[] names = lines.get(0).replaceAll(" \\[[^]]*]", "").split(",");
        List<Row> rows = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",", -1);
            assertEquals(names.length, cells.length, line);
            Map<String, BigDecimal> row = new HashMap<>();
            for (int k = 0; k < cells.length; k++) {
                if (!cells[k].isEmpty() && !cells[k].equals("infinite")) {
                    row.put(names[k], new BigDecimal(Double.parseDouble(cells[k])));
                }
            }
            rows.add(new Row(row));
        }
        return rows;
    }

    private static BigDecimal square(BigDecimal value) {
        return value.multiply(value);
    }

    private static BigDecimal number(double value) {
        return new BigDecimal(value);
    }

    private static void assertNear(BigDecimal expected, BigDecimal found, BigDecimal size, String what) {
        BigDecimal off = expected.subtract(found).abs();
        assertTrue(off.compareTo(size.abs().multiply(number(TERMS))) <= 0, what + ": expected " + expected.doubleValue()
            + ", found " + found.doubleValue());
    }

    private Path run(String scene) throws IOException {
        Path file = temp.resolve("s.json");
        Files.writeString(file, scene);
        Path tables = temp.resolve("tables");
        Cli run = Cli.run("run", file.toString(), "--seed", "5", "--csv", tables.toString());
        assertEquals(ExitStatus.DONE, run.status(), run.err());
        return tables;
    }

    private static String scene(String play, String arithmetic) {
        return """
            { "name": "box", "game": "bodies", "players": 0,
              "field": { "x": -100, "y": 50, "width": 800, "height": 400,
                "walls": { "type": "box", "restitution": 0.9 }, "bumpers": [ { "x": 300, "y": 250, "radius": 40 } ] },
              "bodies": { "listed": [ { "x": -50, "y": 100, "vx": 50, "vy": 20, "radius": 15, "mass": 3 } ],
                "fill": [ { "count": 20, "radius": 10, "speed": 90, "mass": 2, "restitution": 0.8 },
                  { "count": 20, "radius": [5, 10], "speed": 90, "drag": 0.01 } ] },
              "play": { "maximumTurns": 12 PLAY }, "accuracy": { "advance": "event", "arithmetic": "RUNG" } }
            """.replace("PLAY", play).replace("RUNG", arithmetic);
    }

    @ParameterizedTest
    @ValueSource(strings = {"double", "exact"})
    void everyColumnFollowsFromTheOthers(String arithmetic) throws IOException {
        Path tables = run(scene("", arithmetic));
        check(tables, number(0), number(0));
        followPaths(read(tables.resolve("states.csv")), read(tables.resolve("impacts.csv")));
    }

    @Test
    void alsoUnderForces() throws IOException {
        check(run(scene(", \"force\": { \"x\": 1, \"y\": 0 }, \"gravity\": { \"x\": 0, \"y\": 2 }", "double")),
            number(1), number(2));
    }

    /** @param force to the right @param gravity downwards */
    private void check(Path tables, BigDecimal force, BigDecimal gravity) throws IOException {
        List<Row> states = read(tables.resolve("states.csv"));
        List<Row> impacts = read(tables.resolve("impacts.csv"));
        List<Row> turns = read(tables.resolve("turns.csv"));
        assertEquals(13, turns.size());
        assertEquals(13 * 41, states.size());
        assertTrue(impacts.size() > 100, impacts.size() + " impacts");
        BigDecimal restSum = number(0);
        for (Row turn : turns) {
            int number = turn.number("turn");
            List<Row> now = states.stream().filter(row -> row.number("turn") == number).toList();
            List<Row> hits = impacts.stream().filter(row -> row.number("turn") == number).toList();
            assertEquals(hits.size(), turn.number("impacts"));
            checkSums(turn, now, states, force, gravity);
            checkPressure(turn, hits, states, force.signum() == 0);
            restSum = restSum.add(turn.of("rest"));
            assertNear(restSum, turn.of("restSum"), restSum, "restSum");
        }
        impacts.forEach(row -> checkImpact(row, states));
    }

    private static void checkSums(Row turn, List<Row> now, List<Row> states, BigDecimal force, BigDecimal gravity) {
        Map<String, BigDecimal> sums = new LinkedHashMap<>();
        Map<String, BigDecimal> sizes = new HashMap<>();
        for (Row body : now) {
            Row start = states.get(body.number("id"));
            BigDecimal mass = body.of("mass");
            BigDecimal ax = force.divide(mass, DIGITS);
            BigDecimal half = new BigDecimal("0.5");
            BigDecimal[] v = {body.of("vx").add(ax.multiply(half)), body.of("vy").add(gravity.multiply(half))};
            BigDecimal fall = ax.multiply(body.of("x").subtract(start.of("x")))
                .add(gravity.multiply(body.of("y").subtract(start.of("y"))));
            Map.of("energy", mass.multiply(square(v[0]).add(square(v[1]))).multiply(half),
                "potential", mass.multiply(fall).negate(),
                "momentumX", mass.multiply(body.of("vx")), "momentumY", mass.multiply(body.of("vy")),
                "angularMomentum", mass.multiply(body.of("x").multiply(body.of("vy"))
                    .subtract(body.of("y").multiply(body.of("vx"))))).forEach((name, term) -> {
                        sums.merge(name, term, BigDecimal::add);
                        sizes.merge(name, term.abs().add(number(1)), BigDecimal::add);
                    });
        }
        sums.forEach((name, sum) -> assertNear(sum, turn.of(name), sizes.get(name), name));
        assertNear(turn.of("energy"), turn.of("temperature").multiply(number(now.size())), turn.of("energy"), "temp");
    }

    private static void checkPressure(Row turn, List<Row> hits, List<Row> states, boolean isFree) {
        if (turn.number("turn") == 0) {
            assertTrue(turn.of("pressureWalls") == null && turn.of("pressureVirial") == null);
            return;
        }
        BigDecimal push = number(0);
        BigDecimal virial = turn.of("energy");
        for (Row hit : hits) {
            boolean isHeld = hit.of("b") == null || hit.number("b") == 41;
            BigDecimal lever = isHeld ? states.get(hit.number("a")).of("radius")
                : square(hit.of("b", "x").subtract(hit.of("a", "x"))).add(square(hit.of("b", "y")
                .subtract(hit.of("a", "y")))).sqrt(DIGITS);
            push = push.add(isHeld ? hit.of("impulse") : number(0));
            virial = virial.add(hit.of("impulse").multiply(lever).multiply(new BigDecimal("0.5")));
        }
        BigDecimal length = number(2400).add(PI.multiply(number(80)));
        BigDecimal area = number(320_000).subtract(PI.multiply(number(1600)));
        assertNear(push, turn.of("pressureWalls").multiply(length), push, "pressureWalls");
        if (isFree) {
            assertNear(virial, turn.of("pressureVirial").multiply(area), virial, "pressureVirial");
        } else {
            assertEquals(null, turn.of("pressureVirial"));
        }
    }

    private static void checkImpact(Row hit, List<Row> states) {
        assertTrue(hit.of("b") == null != (hit.of("wall") == null));
        BigDecimal nx = hit.of("normalX");
        BigDecimal ny = hit.of("normalY");
        BigDecimal dx = hit.of("b", "x").subtract(hit.of("a", "x"));
        BigDecimal dy = hit.of("b", "y").subtract(hit.of("a", "y"));
        BigDecimal one = number(1);
        assertNear(one, square(nx).add(square(ny)), one, "normal");
        assertNear(dx.multiply(ny), dy.multiply(nx), number(1000), "normal along the centres");
        assertTrue(dx.multiply(nx).add(dy.multiply(ny)).signum() > 0, "normal from a to b");
        BigDecimal energy = number(0);
        BigDecimal size = number(0);
        for (String body : List.of("a", "b")) {
            BigDecimal mass = hit.of(body) == null || hit.number(body) == 41 ? null
                : states.get(hit.number(body)).of("mass");
            BigDecimal sign = number(body.equals("a") ? -1 : 1);
            for (String axis : List.of("x", "y")) {
                BigDecimal before = hit.of(body, "v" + axis + "Before");
                BigDecimal after = hit.of(body, "v" + axis + "After");
                if (mass == null) {
                    assertEquals(before, after);
                    continue;
                }
                BigDecimal given = hit.of("impulse").multiply(axis.equals("x") ? nx : ny).multiply(sign);
                BigDecimal speeds = before.abs().add(after.abs()).add(one).multiply(mass);
                assertNear(given, mass.multiply(after.subtract(before)), speeds, "impulse of " + body + axis);
                energy = energy.add(mass.multiply(square(after).subtract(square(before))).divide(number(2)));
                size = size.add(square(speeds));
            }
        }
        assertNear(energy, hit.of("energy"), size, "energy");
    }

    /** Straight flights from one row to the next: time, places and velocities of impacts; at the end of turns, drag. */
    private static void followPaths(List<Row> states, List<Row> impacts) {
        BigDecimal far = number(1000);
        for (int id = 0; id < 41; id++) {
            int disc = id;
            for (int turn = 1; turn <= 12; turn++) {
                int now = turn;
                Row from = states.get(41 * (turn - 1) + id);
                BigDecimal[] at = {from.of("x"), from.of("y"), from.of("vx"), from.of("vy"), number(0)};
                for (Row hit : impacts.stream().filter(row -> row.number("turn") == now && (row.number("a") == disc
                    || row.of("b") != null && row.number("b") == disc)).toList()) {
                    String body = hit.number("a") == id ? "a" : "b";
                    BigDecimal time = hit.of("time");
                    assertTrue(time.compareTo(at[4]) >= 0 && time.compareTo(number(1)) <= 0);
                    for (int axis = 0; axis < 2; axis++) {
                        String name = axis == 0 ? "x" : "y";
                        assertNear(at[axis].add(at[2 + axis].multiply(time.subtract(at[4]))), hit.of(body, name), far,
                            "place");
                        assertEquals(at[2 + axis], hit.of(body, "v" + name + "Before"));
                        at[axis] = hit.of(body, name);
                        at[2 + axis] = hit.of(body, "v" + name + "After");
                    }
                    at[4] = time;
                }
                Row to = states.get(41 * turn + id);
                BigDecimal kept = number(1).subtract(to.of("drag"));
                for (int axis = 0; axis < 2; axis++) {
                    String name = axis == 0 ? "x" : "y";
                    assertNear(at[axis].add(at[2 + axis].multiply(number(1).subtract(at[4]))), to.of(name), far, "end");
                    assertNear(at[2 + axis].multiply(kept), to.of("v" + name), far, "drag");
                }
                for (String same : List.of("radius", "mass", "restitution", "drag")) {
                    assertEquals(from.of(same), to.of(same));
                }
            }
        }
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
        List<Row> turns = read(tables.resolve("turns.csv")).subList(51, 201);
        double area = 1780.0 * 1780;
        double covered = 1000 * Math.PI * 100 / area;
        double expected = turns.get(0).of("temperature").doubleValue() * 1000 / area * (1 + covered * covered / 8)
            / ((1 - covered) * (1 - covered)) * 1780 / 1800;
        assertEquals(expected, mean(turns, "pressureVirial"), 0.01 * expected);
        assertEquals(expected, mean(turns, "pressureWalls"), 0.12 * expected);
    }

    private static double mean(List<Row> rows, String column) {
        return rows.stream().mapToDouble(row -> row.of(column).doubleValue()).average().orElseThrow();
    }

    /** Twelve turns, and a scene that begins with the table of the first seven: the last five are the same bits. */
    @ParameterizedTest
    @ValueSource(strings = {"", ", \"gravity\": { \"x\": 0, \"y\": 2 }",
        ", \"zones\": [ { \"x\": 600, \"y\": 400, \"radius\": 60, \"label\": \"p\", \"removes\": true } ]"})
    void aTableOfStatesGoesOnWithTheSameBits(String play) throws IOException {
        List<String> all = Files.readAllLines(run(scene(play, "double")).resolve("states.csv"));
        Path tables = temp.resolve("seven");
        assertEquals(0, Cli.run("run", temp.resolve("s.json").toString(), "--seed", "5", "--turns", "7", "--csv",
            tables.toString()).status());
        String next = scene(play, "double").replaceFirst("(?s)\"listed\".*?\\] \\},", "\"csv\": \"states.csv\" },")
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

package steward.lab.tradeoff;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.WorkTimer;
import steward.lab.tradeoff.report.TradeoffPage;
import steward.lab.tradeoff.report.TradeoffReport;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.event.EventAdvance;
import steward.physics.event.Scenes;
import steward.physics.event.StepAdvance;
import steward.scene.Accuracy;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The trade-off: what is measured of a scene, the Pareto front, and the files. */
class TradeoffTest {

    private static final TradeoffEffort TINY = new TradeoffEffort(1, new TimingEffort(1, 3, 0, 0, 0));
    private static final PhysicsParts PLAIN = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE);

    @TempDir
    private Path folder;

    /** A small fast body that one step carries past a big one; every other state, with a gap that nothing meets in. */
    private static TradeoffScene tunnel() {
        SplitMix64 random = new SplitMix64(3);
        AtomicInteger count = new AtomicInteger();
        return new TradeoffScene("tunnel", "a bullet and a target", "tunnel", PLAIN, null, () -> {
            double y = count.getAndIncrement() % 2 == 0 ? 5 * random.nextDouble() : 200;
            return Scenes.bodies(new double[][] {{0, y, 1000, 0, 1, 1},
                {100 + 50 * random.nextDouble(), 0, 0, 0, 5, 20}});
        }, 10, 2, 3, 64);
    }

    /** In this JVM. */
    private static TradeoffMeasurement measurement() {
        return new TradeoffMeasurement(tunnel(), TINY, new Timing<>(TINY.timing(), job -> {
            assertEquals("tunnel", job.scene());
            return new WorkTimer(job.open(PLAIN));
        }));
    }

    private static List<TradeoffRow> rows() {
        return measurement().run(() -> { });
    }

    private static TradeoffRow row(List<TradeoffRow> rows, String rung) {
        return rows.stream().filter(row -> row.rung().equals(rung)).findFirst().orElseThrow();
    }

    @Test
    void everyRungIsHeldAgainstTheTruthOfTheSameStates() {
        List<TradeoffRow> rows = rows();
        assertEquals(Accuracy.ladder().stream().filter(rung -> rung.steps() <= 64).map(Accuracy::text).toList(),
            rows.stream().map(TradeoffRow::rung).toList());
        for (TradeoffRow row : rows) {
            assertEquals(10, row.states());
            assertEquals(5, row.impacts(), "every other state");
            assertTrue(row.median() <= row.most99() && row.most99() <= row.worst(), row.toString());
            assertEquals(0, row.compared(), "nothing is rounded");
        }
        TradeoffRow step = row(rows, "step/1");
        assertEquals(5, step.missed(), "all are tunnelled through");
        assertTrue(step.worst() > 100, step.toString());
        assertTrue(Double.isNaN(step.cost().nanosPerImpact()), "it has computed none");
        for (String rung : List.of("event/double", "event/exact")) {
            TradeoffRow event = row(rows, rung);
            assertEquals(0, event.missed() + event.invented());
            assertTrue(event.worst() < 1e-10, event.toString());
            assertTrue(event.energyError() < 1e-14, event.toString());
        }
    }

    /** The ratio is that of the two columns, so that what is printed agrees with itself. */
    @Test
    void costsAreOfTheTurnsAndComparedWithTheDefault() {
        List<TradeoffRow> rows = rows();
        double usual = row(rows, TradeoffRow.DEFAULT_RUNG).cost().nanosPerTurn();
        for (TradeoffRow row : rows) {
            assertEquals(3, row.rounds());
            assertEquals(1, row.jvms());
            assertEquals(row.cost().nanosPerTurn() / usual, row.costRatio());
            assertTrue(row.ratioLow() <= row.costRatio() && row.costRatio() <= row.ratioHigh(), row.toString());
            assertTrue(row.cost().low() <= row.cost().nanosPerTurn() && row.cost().nanosPerTurn() <= row.cost().high(),
                row.toString());
            assertTrue(row.cost().nanosPerTurn() > 0 && row.costRatio() > 0, row.toString());
            assertTrue(row.cost().bytesPerTurn() >= 0 || Double.isNaN(row.cost().bytesPerTurn()), row.toString());
        }
        assertEquals(1, row(rows(), TradeoffRow.DEFAULT_RUNG).costRatio());
    }

    @Test
    void progressComesToItsEnd() {
        TradeoffMeasurement measurement = measurement();
        AtomicInteger steps = new AtomicInteger();
        measurement.run(steps::incrementAndGet);
        assertEquals(measurement.steps(), steps.get());
    }

    /** One step a turn flies through the other body in the first turn: 990 u off. Exact times stay together. */
    @Test
    void aFreeRunEndsWhereABodyIsOff() {
        Bodies start = Scenes.bodies(new double[][] {{0, 0, 200, 0}, {100, 0, 0, 0}});
        List<Advance> rungs = List.of(new StepAdvance(PLAIN, 1), new EventAdvance(PLAIN));
        assertArrayEquals(new int[] {1, 8}, TradeoffFreeRun.turns(start, PLAIN, rungs, 7));
        start.setVelocity(0, 30, 0);                // contact in the third turn
        assertArrayEquals(new int[] {3, 8}, TradeoffFreeRun.turns(start, PLAIN, rungs, 7));
    }

    /** B is dearer than A and no better, D is beaten by C; equal points stand together, NaN nowhere. */
    @Test
    void theFrontHasAllPointsThatAreNotBeaten() {
        double nan = Double.NaN;
        assertArrayEquals(new boolean[] {true, false, true, false}, TradeoffMeasurement.front(
            new double[] {1, 2, 3, 4}, new double[] {5, 5, 1, 2}));
        assertArrayEquals(new boolean[] {true, true, false}, TradeoffMeasurement.front(
            new double[] {1, 1, 1}, new double[] {0, 0, 1e-9}));
        assertArrayEquals(new boolean[] {false, true},
            TradeoffMeasurement.front(new double[] {nan, 9}, new double[] {0, 9}));
        assertEquals(0, TradeoffMeasurement.front(new double[0], new double[0]).length);
    }

    private static TradeoffRow made(String scene, String rung, double nanos, double error, boolean front) {
        return new TradeoffRow(scene, rung, 100, 50, 3, 21,
            new TradeoffRow.Cost(nanos, nanos - 1, nanos + 2, Double.NaN, 0), nanos / 80,
            (nanos - 1) / 80, (nanos + 1) / 80, 0, error, error,
            rung.equals("event/exact") ? 0 : 2, 1, 1e-16, 9, 8, 3, 400, front);
    }

    private List<TradeoffRow> ladder(String scene) {
        List<TradeoffRow> rows = new ArrayList<>();
        rows.add(made(scene, "step/1", 40, 200, true));
        rows.add(made(scene, "step/2", 90, 90, false));
        rows.add(made(scene, "event/official", 70, 1e-5, true));
        rows.add(made(scene, "event/double", 80, 2e-6, true));
        rows.add(made(scene, "event/compensated", 100, 1e-5, false));
        rows.add(made(scene, "event/exact", 120, 0, true));
        return rows;
    }

    @Test
    void theFilesGrowSceneByScene() throws IOException {
        try (TradeoffReport files = new TradeoffReport(folder, "a machine", "2030-01-02")) {
            assertTrue(Files.readString(folder.resolve("tradeoff.csv")).startsWith("scene,rung,states,impacts,"));
            files.add(ladder("a \"quoted\" scene"));
            List<String> csv = Files.readAllLines(folder.resolve("tradeoff.csv"));
            assertEquals(7, csv.size());
            assertTrue(
                csv.get(1).startsWith("\"a \"\"quoted\"\" scene\",\"step/1\",100,50,3,21,40.0,39.0,42.0,,0.0,0.5,"),
                csv.get(1));
            JsonNode json = JsonMapper.shared().readTree(Files.readString(folder.resolve("tradeoff.json")));
            assertEquals("a machine", json.get("machine").asString());
            assertEquals(6, json.get("rows").size());
            assertTrue(json.get("rows").get(0).get("nanosPerImpact").isNull());
            assertTrue(json.get("rows").get(0).get("onFront").asBoolean());
            assertFalse(Files.exists(folder.resolve("tradeoff.png")), "only in the end");
        }
    }

    @Test
    @Tag("slow")
    void theLastFilesShowThePlot() throws IOException {
        List<TradeoffRow> rows = new ArrayList<>(ladder("official-race"));
        rows.addAll(ladder("grazing"));
        try (TradeoffReport files = new TradeoffReport(folder, "a machine", "2030-01-02")) {
            files.add(rows);
            files.finish();
        }
        BufferedImage picture = ImageIO.read(folder.resolve("tradeoff.png").toFile());
        BufferedImage all = ImageIO.read(folder.resolve("tradeoff-scenes.png").toFile());
        assertEquals(1000, picture.getWidth(), "a column that a phone shows as it is");
        assertEquals(1000, all.getWidth());
        assertTrue(all.getHeight() > picture.getHeight() + 700, "a panel more");
        String page = TradeoffPage.text(new TradeoffResult("a machine", "2030-01-02", rows));
        assertTrue(page.contains("on 2030-01-02: a machine."), page);
        assertTrue(page.contains(" srcset=\"tradeoff-scenes-dark.png\"><img alt=\"Error against cost, a panel a scene"
            + "\" src=\"tradeoff-scenes.png\"></picture>\n"), page);
        assertTrue(page.contains("On a race turn it costs 0.86 - 0.89 times as much as `double`. 3 of 400 pod-turns"),
            page);
        assertTrue(page.contains("`step/1`. On a race turn it costs 0.49 - 0.51 times as much as `double`"), page);
        assertTrue(page.contains("than any rung with exact times: `step/1` on official-race, "
            + "`step/1` on grazing."), page);
        assertFalse(page.contains("The default"), "in a race it missed or invented 3 of 50 impacts");
        assertTrue(page.contains("\n4. ") && !page.contains("\n5. "), page);
        assertEquals(12, page.lines()
            .filter(line -> line.startsWith("| step/") || line.startsWith("| event/")).count());
    }

    /** A name that is longer than a line is shown whole, in several. */
    @Test
    @Tag("slow")
    void aLongTitleIsNotCutOff() throws IOException {
        int[] heights = new int[2];
        for (int k = 0; k < 2; k++) {
            Path own = Files.createDirectory(folder.resolve("own" + k));
            try (TradeoffReport files = new TradeoffReport(own, "a machine", "2030-01-02")) {
                files.add(ladder(k == 0 ? "mine" : "two hundred discs in a bowl with two walls, " + "x".repeat(120)));
                files.finish();
            }
            heights[k] = ImageIO.read(own.resolve("tradeoff.png").toFile()).getHeight();
        }
        assertTrue(heights[1] > heights[0], heights[1] + " against " + heights[0]);
    }

    /** Files of made rows in the folder that is named, as another process would write them. */
    public static void main(String[] arguments) throws IOException {
        try (TradeoffReport files = new TradeoffReport(Path.of(arguments[0]), "a machine", "2030-01-02")) {
            files.add(new TradeoffTest().ladder("gas"));
            System.out.println(files.finish());
        }
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void aDisplayThatIsNotThereIsNoHindrance() throws IOException, InterruptedException {
        ProcessBuilder other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), TradeoffTest.class.getName(),
            folder.toString());
        other.environment().put("DISPLAY", ":99");
        Process process = other.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        assertEquals("null", said.strip());
        assertTrue(Files.size(folder.resolve("tradeoff.png")) > 0);
    }

    @Test
    void aRunOfOneSceneSaysWhatItCan() {
        String page = TradeoffPage.text(new TradeoffResult("a machine", "2030-01-02", ladder("my scene")));
        assertTrue(page.contains("### my scene"), page);
        assertTrue(page.contains("| none | | | | | `steward tradeoff --quick --scene my-scene.json` |"), page);
        assertFalse(page.contains("The default"), page);
        assertNull(new TradeoffResult("", "", List.of()).row("a", "b"));
    }
}

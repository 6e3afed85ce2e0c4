package steward.lab.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.shared.Games;
import steward.lab.tradeoff.TradeoffScene;
import steward.lab.tradeoff.report.TradeoffReport;
import steward.physics.Bodies;
import steward.scene.Accuracy;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code steward tradeoff}: the table, its files, and what is refused. */
@Execution(ExecutionMode.CONCURRENT)
class TradeoffCommandTest {

    /** The number of the signal that {@code Process.destroy} sends; Ctrl-C is 2. */
    private static final int TERMINATED = 15;

    @TempDir
    private Path folder;

    private static Cli tradeoff(boolean terminal, String... more) {
        List<String> words = new ArrayList<>(List.of("tradeoff", "--quick"));
        words.addAll(List.of(more));
        return Cli.run(terminal, words.toArray(new String[0]));
    }

    @Test
    @Tag("campaign")
    @Tag("process")
    void theTableAndTheFilesHoldEveryRung() throws IOException {
        Path out = folder.resolve("results");
        Cli cli = tradeoff(true, "--scene", "duel", "--out", out.toString()).done();
        assertTrue(cli.out().startsWith("duel: "), cli.out());
        for (Accuracy rung : Accuracy.ladder()) {
            assertEquals(1, cli.out().lines().filter(line -> line.startsWith("  " + rung + " ")).count(), cli.out());
        }
        assertTrue(cli.out().lines().allMatch(line -> line.length() <= 120), cli.out());
        assertTrue(cli.out().endsWith("--quick: few states, and one JVM a rung. These figures may not be quoted.\n"),
            cli.out());
        assertTrue(cli.err().contains("1 of 1: duel"), "progress: " + cli.err());
        for (String name : TradeoffReport.ALL) {
            assertTrue(Files.size(out.resolve(name)) > 0, name);
        }
        assertEquals(1 + Accuracy.ladder().size(), Files.readAllLines(out.resolve("tradeoff.csv")).size());
        tradeoff(false, "--scene", "duel", "--out", out.toString()).assertRefused("exists already, and is kept");
    }

    /** An interrupted run leaves the scenes that were measured, in files that are whole. */
    @Test
    @Tag("process")
    @Tag("campaign")
    @Timeout(600)
    void whatWasMeasuredIsKept() throws IOException, InterruptedException {
        Path out = folder.resolve("results");
        Path errors = folder.resolve("errors");
        Process run = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
            System.getProperty("java.class.path"), Main.class.getName(), "tradeoff", "--quick", "--scene", "grazing",
            "--scene", "gas", "--out", out.toString()).redirectError(errors.toFile())
            .redirectOutput(folder.resolve("table").toFile()).start();
        try {
            Path json = out.resolve("tradeoff.json");
            Path csv = out.resolve("tradeoff.csv");
            while (run.isAlive() && (!Files.exists(json) || !Files.readString(json).contains("grazing")
                || Files.readAllLines(csv).size() <= Accuracy.ladder().size())) {
                Thread.sleep(50);
            }
        } finally {
            run.destroy();
            assertEquals(128 + TERMINATED, run.waitFor());
        }
        assertEquals(1 + Accuracy.ladder().size(), Files.readAllLines(out.resolve("tradeoff.csv")).size());
        JsonNode rows = JsonMapper.shared().readTree(Files.readString(out.resolve("tradeoff.json"))).get("rows");
        assertEquals("grazing", rows.get(0).get("scene").asString());
        String said = Files.readString(errors);
        assertTrue(said.contains("interrupted; the scenes so far are in " + out), said);
        assertFalse(Files.exists(out.resolve("tradeoff.png")), "only in the end");
    }

    /** In a brawl the pods meet more often than in a race; both are of the official scene. */
    @Test
    void aBrawlIsACrowd() {
        double[] spread = new double[2];
        for (int k = 0; k < 2; k++) {
            TradeoffScene scene = TradeoffScenes.of(List.of("official-race", "brawl"), Games::open).get(k);
            assertEquals(List.of("official-race", "brawl").get(k), scene.name());
            for (int n = 0; n < 400; n++) {
                Bodies bodies = scene.source().get();
                spread[k] += Math.abs(bodies.x[0] - bodies.x[3]) + Math.abs(bodies.y[0] - bodies.y[3]);
            }
        }
        assertTrue(spread[1] < spread[0] / 2, spread[1] + " against " + spread[0]);
    }

    /** States of the shipped bodies are from all of a game, without an overlap, and within their walls. */
    @Test
    void statesOfBodiesBeginApart() {
        for (TradeoffScene scene : TradeoffScenes.of(List.of("dense-box", "gas", "bullets", "bowl", "avalanche"),
            Games::open)) {
            Bodies bodies = scene.source().get();
            bodies = scene.source().get();
            for (int i = 0; i < bodies.size(); i++) {
                double x = bodies.x[i];
                double y = bodies.y[i];
                double radius = bodies.radius[i];
                assertTrue(scene.parts().walls().stream().allMatch(wall -> wall.gap(x, y, radius) > -1e-9),
                    scene.name());
                for (int j = 0; j < i; j++) {
                    double touch = radius + bodies.radius[j];
                    assertTrue(Math.hypot(x - bodies.x[j], y - bodies.y[j]) > touch * (1 - 1e-9), scene.name());
                }
            }
        }
    }
}

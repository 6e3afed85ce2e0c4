package steward.lab.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToIntFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.Streams;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.calibration.Calibration;
import steward.lab.calibration.SeededPlay;
import steward.lab.timing.RungJob;
import steward.lab.timing.Stretch;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.WorkTimer;
import steward.scene.Accuracy;
import steward.scene.AccuracyFigures;
import steward.scene.SceneFiles;
import steward.scene.SceneKey;

/** {@code steward tradeoff --calibrate SCENE}, and scenes that state the error they tolerate. */
@Timeout(600)
@Execution(ExecutionMode.CONCURRENT)
class CalibrateTest {

    /** Times the rungs in this JVM, and as briefly as can be. */
    static final Timing<RungJob> HERE = new Timing<>(new TimingEffort(1, 1, 0, 0, 0),
        job -> new WorkTimer(TimingMain.open(job)));

    /** A rung costs the more the farther up it stands, from step/1 on. */
    private static final Timing<RungJob> MADE_TIMES = madeTimes(rung -> 30 + 30 * Accuracy.ladder().indexOf(rung));
    /** Exact times cost less than any steps. */
    private static final Timing<RungJob> CHEAP_EVENTS = madeTimes(rung ->
        rung.steps() == 0 ? 30 * (1 + rung.arithmetic().ordinal()) : 3000);

    private static Timing<RungJob> madeTimes(ToIntFunction<Accuracy> nanos) {
        return new Timing<>(new TimingEffort(1, 1, 0, 0, 0),
            job -> least -> new Stretch(nanos.applyAsInt(job.rung()), 0));
    }

    @TempDir
    private Path folder;

    /** The duel over two laps, which has no stored calibration. */
    private Path scene(String demand) throws IOException {
        return Files.writeString(folder.resolve("mine.json"), SceneFiles.load("duel").text()
            .replace("\"laps\": 1", "\"laps\": 2").replaceFirst("\"accuracy\": \\{[^}]*}", "\"accuracy\": " + demand));
    }

    @Test
    void whoWantsToPlayASceneThatIsNotCalibratedIsToldHow() throws IOException {
        Path scene = scene("{ \"maxPositionError\": 0.01, \"share\": 0.99 }");
        Cli uncalibrated = Cli.run("explain", scene.toString());
        assertEquals(ExitStatus.UNUSABLE, uncalibrated.status());
        assertTrue(uncalibrated.err().endsWith("steward tradeoff --calibrate " + scene + "\n"), uncalibrated.err());
    }

    /** Timed in JVMs, one for each rung. */
    @Test
    @Tag("process")
    @Tag("campaign")
    void aSceneThatStatesAnErrorIsCalibratedAndPlayed() throws IOException {
        Path scene = scene("{ \"maxPositionError\": 0.01, \"share\": 0.99 }");
        Cli calibrated = Cli.run("tradeoff", "--calibrate", scene.toString(), "--states", "1000");
        Path figures = folder.resolve("mine.accuracy.json");
        assertEquals(ExitStatus.DONE, calibrated.status(), calibrated.err());
        assertTrue(calibrated.out().contains("\nwritten to " + figures + "\n"), calibrated.out());
        assertTrue(calibrated.out().lines().allMatch(line -> line.length() <= 100 || line.startsWith("written to ")),
            calibrated.out());
        assertFalse(Files.exists(folder.resolve("mine.accuracy.json.part")));
        assertPlayedAsCalibrated(scene, figures);
    }

    @Test
    @Tag("process")
    void aSceneThatStatesAnErrorIsPlayedAsCalibrated() throws Exception {
        Path scene = scene("{ \"maxPositionError\": 0.01, \"share\": 0.99 }");
        Path figures = folder.resolve("mine.accuracy.json");
        calibrate(scene, figures, CHEAP_EVENTS);
        assertPlayedAsCalibrated(scene, figures);
    }

    private static void calibrate(Path scene, Path figures, Timing<RungJob> timing) throws Exception {
        CalibrationRun.of(new Streams(new ByteArrayOutputStream(), new ByteArrayOutputStream(), false, false),
            Games.open(scene.toString(), Calibration.PLAYED_ON), figures, 1000, timing).run();
    }

    private void assertPlayedAsCalibrated(Path scene, Path figures) throws IOException {
        String explained = Cli.run("explain", scene.toString()).out().replaceAll("\\s+", " ");
        assertTrue(explained.matches(".*Accuracy: event/[a-z]+, the cheapest that is off by at most 0.01 u in 99% "
            + "of states: by .*"), explained);
        assertTrue(explained.contains("shown by 1000 (" + figures + "), at "), explained);

        ShellBots bots = new ShellBots(folder);
        Path replay = folder.resolve("x.jsonl");
        Cli.run("match", "--scene", scene.toString(), "--no-deadline", "--quiet",
            "--out", replay.toString(),
            "--bot", bots.driver("a", ShellBots.NOWHERE), "--bot", bots.driver("b", ShellBots.NOWHERE)).done();
        Files.delete(figures);
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            Cli.run("replay", replay.toString(), "--verify").out());
    }

    /** Where a step costs less than exact times. */
    @Test
    @Tag("slow")
    void aRougherDemandHasACheaperRung() throws Exception {
        Path scene = scene("{ \"maxPositionError\": 400, \"share\": 0.99 }");
        calibrate(scene, folder.resolve("mine.accuracy.json"), MADE_TIMES);
        String explained = Cli.run("explain", scene.toString()).out();
        assertTrue(explained.contains("\nAccuracy: step/1, the cheapest"), explained);
        assertTrue(explained.contains("\n  accuracy: advance step, steps 1, arithmetic double\n"), explained);
    }

    @Test
    void figuresThatExistAreKept() throws IOException {
        Path scene = scene("{ \"maxPositionError\": 400, \"share\": 0.99 }");
        Path figures = Files.writeString(folder.resolve("mine.accuracy.json"), "old");
        refused("exists already, and is kept", "tradeoff --calibrate " + scene);
        assertEquals("old", Files.readString(figures));
    }

    @Test
    @Tag("campaign")
    void figuresAreReplacedOnDemand() throws IOException {
        Path scene = scene("{ \"maxPositionError\": 400, \"share\": 0.99 }");
        Path figures = Files.writeString(folder.resolve("mine.accuracy.json"), "old");
        Cli.run("--cli", "tradeoff --calibrate " + scene + " --states 10 --overwrite").done();
        assertEquals(10, AccuracyFigures.read(Files.readString(figures), "new").states());
    }

    private static void refused(String message, String call) {
        Cli.run("--cli", call).assertRefused(message);
    }

    @Test
    @Tag("slow")
    void anInterruptedRunKeepsWhatWasMeasured() throws Exception {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Path file = folder.resolve("d.accuracy.json");
        CalibrationRun calibrating = CalibrationRun.of(new Streams(new ByteArrayOutputStream(), err, false, false),
            Games.open("duel"), file, 1200, HERE);
        calibrating.interrupted();
        assertEquals("steward: interrupted before anything was measured\n", err.toString(StandardCharsets.UTF_8));
        assertFalse(Files.exists(file));
        err.reset();
        calibrating.run();
        calibrating.interrupted();
        assertEquals("steward: interrupted; the figures of 1200 states are in " + file + "\n",
            err.toString(StandardCharsets.UTF_8));
        assertEquals(1200, AccuracyFigures.read(Files.readString(file), "d").states());
    }

    private static SeededPlay race(GameSetup setup, long seed) {
        return new SeededPlay(setup, setup.pilot(Pilot.Aim.WIN), seed);
    }

    /** Figures of fewer states do not replace older figures of more states. */
    @Test
    @Tag("slow")
    void anInterruptedRunLeavesOlderFiguresWhereTheyAre() throws Exception {
        Path file = Files.writeString(folder.resolve("d.accuracy.json"), "older");
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        GameSetup duel = Games.open("duel");
        Calibration calibration = new Calibration(duel, seed -> race(duel, seed), 1000);
        calibration.time(HERE, () -> { });
        calibration.run(1, () -> { });
        new CalibrationRun(new Streams(new ByteArrayOutputStream(), err, false, false), Games.open("duel"), file,
            calibration, HERE).interrupted();
        assertEquals("older", Files.readString(file));
        assertEquals("steward: interrupted; the figures of 1000 states are in " + file + ".part, the older ones still "
            + "in " + file + "\n", err.toString(StandardCharsets.UTF_8));
        assertEquals(1000, AccuracyFigures.read(Files.readString(Path.of(file + ".part")), "d").states());
    }

    /** The shipped scenes that have figures: those of games between players. */
    static List<String> calibrated() {
        return SceneFiles.shipped().stream().filter(name -> Games.open(name).scene().players() > 0).toList();
    }

    /**
     * The shipped figures are those of the present physics and scenes. If they are not:
     * {@code steward tradeoff --calibrate config/scenes/NAME.json --overwrite}.
     */
    @ParameterizedTest
    @MethodSource("calibrated")
    void theFiguresOfAShippedSceneHold(String name) throws Exception {
        GameSetup setup = Games.open(name, Calibration.PLAYED_ON);
        AccuracyFigures figures = shipped(name);
        assertEquals(Calibration.STATES, figures.states());
        assertEquals(SceneKey.of(setup.scene()), figures.key());
        AccuracyFigures holding = figures.holding(AccuracyFigures.mayRest(setup.scene().law(), setup.scene().json()));
        assertEquals(figures.rungs(), holding.rungs());
    }

    /** The first states of a scene with bodies that meet, and of one without, played and measured again. */
    @ParameterizedTest
    @Tag("slow")
    @ValueSource(strings = {"duel", "search-race"})
    void aSampleOfTheFiguresIsMeasuredAnew(String name) throws Exception {
        assertSampleHolds(name);
    }

    @ParameterizedTest
    @Tag("campaign")
    @MethodSource("calibrated")
    void aSampleOfTheFiguresOfEachSceneIsMeasuredAnew(String name) throws Exception {
        assertSampleHolds(name);
    }

    static List<String> ofBodies() {
        return SceneFiles.shipped().stream().filter(name -> Games.open(name).scene().players() == 0
            && SceneFiles.class.getResource(AccuracyFigures.resource(name)) != null).toList();
    }

    /** Figures beside a shipped scene of bodies: a budget in time and one in errors are met by them. */
    @ParameterizedTest
    @MethodSource("ofBodies")
    void aShippedSceneOfBodiesCanStateABudget(String name) throws Exception {
        AccuracyFigures figures = shipped(name);
        assertEquals(SceneKey.of(Games.open(name, Calibration.PLAYED_ON).scene()), figures.key());
        Path scene = folder.resolve("mine.json");
        Files.writeString(folder.resolve("mine.accuracy.json"),
            Files.readString(Path.of("config/scenes", name + ".accuracy.json")));
        for (String demand : List.of("{ \"maxCost\": \"90000us\" }",
            "{ \"maxPositionError\": 0.01, \"share\": 0.5 }")) {
            Files.writeString(scene, SceneFiles.load(name).text()
                .replaceFirst("\"accuracy\": \\{[^}]*}", "\"accuracy\": " + demand));
            Cli explained = Cli.run("explain", scene.toString()).done();
            assertTrue(explained.out().replaceAll("\\s+", " ").contains(
                "shown by " + figures.states() + " (" + folder.resolve("mine.accuracy.json") + ")"), explained.out());
        }
    }

    private static void assertSampleHolds(String name) throws Exception {
        GameSetup setup = Games.open(name, Calibration.PLAYED_ON);
        AccuracyFigures figures = shipped(name);
        Calibration sample = new Calibration(setup, seed -> race(setup, seed), Calibration.BLOCK);
        sample.time(MADE_TIMES, () -> { });
        sample.run(2, () -> { });
        assertEquals(sample.figures().sample(), figures.sample());
    }

    static AccuracyFigures shipped(String name) throws IOException {
        String source = AccuracyFigures.resource(name);
        return AccuracyFigures.read(
            new String(SceneFiles.class.getResourceAsStream(source).readAllBytes(), StandardCharsets.UTF_8), source);
    }
}

package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.numerics.SplitMix64;
import steward.physics.ImpactLaw;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/** A scene that states what error it can bear, and the figures that say which rung it gets. */
class AccuracyFiguresTest {

    private static final String STEP = """
        { "rung": "step/2", "cost": 0.4, "work": 2, "largestError": "unknown",
          "positionErrors": { "0.5": 0, "0.9": 1, "0.99": 10, "0.999": 50, "0.9999": "unknown" } }""";
    private static final String EVENT = """
        { "rung": "event/double", "cost": 1, "work": 3.5, "largestError": 3e-5,
          "positionErrors": { "0.5": 0, "0.9": 0, "0.99": 1e-9, "0.999": 1e-5, "0.9999": 2e-5 } }""";
    private static final String EXACT = """
        { "rung": "exact", "cost": 1.5, "work": 3.5, "largestError": 4e-12,
          "positionErrors": { "0.5": 0, "0.9": 0, "0.99": 1e-12, "0.999": 2e-12, "0.9999": 2e-12 } }""";
    /** By counted work it would be the cheapest; it costs more than event/double and is worse: it is never taken. */
    private static final String BEATEN = """
        { "rung": "step/4", "cost": 1.4, "work": 1, "largestError": 0.5,
          "positionErrors": { "0.5": 0, "0.9": 0.1, "0.99": 0.2, "0.999": 0.3, "0.9999": 0.4 } }""";
    /** Costs less than event/double by less than measurements differ, and is worse. */
    private static final String HARDLY_CHEAPER = """
        { "rung": "event/official", "cost": 0.97, "work": 3.5, "largestError": 0.5,
          "positionErrors": { "0.5": 0, "0.9": 1e-4, "0.99": 1e-3, "0.999": 0.01, "0.9999": 0.04 } }""";

    @TempDir
    private Path folder;

    private static String text(String accuracy) {
        return """
            { "name": "s", "game": "g", "players": 2, "pods": { "perPlayer": 1, "x": [ 1, 2.50, "a" ] },
              "time": { "firstAnswerMs": 1000, "answerMs": 75 },
              "accuracy": {""" + accuracy + "} }";
    }

    private static String demand(String error, String share) {
        return text("\"maxPositionError\": " + error + ", \"share\": " + share);
    }

    private Path write(String scene) throws IOException {
        return Files.writeString(folder.resolve("s.json"), scene);
    }

    private static String figures(String key, String physics, String... rungs) {
        return "{ \"format\": 2, \"key\": \"" + key + "\", \"physics\": \"" + physics
            + "\", \"sample\": \"0\", \"states\": 100000, \"rungs\": [ " + String.join(", ", rungs) + " ] }";
    }

    /** Each rung as measured by its present law. */
    private static String presentFigures(String key, String... rungs) {
        String of = Arrays.stream(rungs).map(AccuracyFiguresTest::ofPresentLaw).collect(Collectors.joining(", "));
        return "{ \"format\": 2, \"key\": \"" + key + "\", \"sample\": \"0\", \"states\": 100000, \"rungs\": [ "
            + of + " ] }";
    }

    private static String ofPresentLaw(String rung) {
        Matcher name = Pattern.compile("\"rung\": \"([a-z/0-9]+)\"").matcher(rung);
        assertTrue(name.find());
        RungLaw law = RungLaw.of(Accuracy.parse(name.group(1)), ImpactLaw.PHYSICS, false);
        return rung.replace("\"cost\"", "\"physics\": \"" + law.fingerprint() + "\", \"cost\"");
    }

    /** The figures of the scene above. */
    private Path calibrated() throws IOException {
        String key = SceneKey.of(SceneReader.read(text("\"advance\": \"step\", \"steps\": 1"), "s"));
        return Files.writeString(folder.resolve("s.accuracy.json"),
            presentFigures(key, EXACT, BEATEN, HARDLY_CHEAPER, EVENT, STEP));
    }

    private static Scene load(Path file) {
        return SceneReader.read(SceneFiles.load(file.toString()), null);
    }

    private static String refusal(Path file) {
        return assertThrows(SceneException.class, () -> load(file)).getMessage();
    }

    /** Shares between two that are kept are held against the next higher one. */
    @ParameterizedTest
    @CsvSource({"50, 0.999, step/2", "50, 0.9991, event/double", "10, 0.95, step/2", "9.9, 0.95, event/double",
        "1000, 0.9999, event/double", "0.01, 0.999, event/double", "1e-5, 0.999, event/double",
        "0.99e-5, 0.999, event/exact", "2e-12, 0.9999, event/exact", "0.001, 0.1, step/2"})
    void theCheapestRungThatMeetsTheDemandIsTaken(String error, String share, String rung) throws IOException {
        calibrated();
        Scene scene = load(write(demand(error, share)));
        assertEquals(rung, scene.accuracy().text());
    }

    /** Alone it takes the most accurate that costs no more; with an error, the cheapest that meets both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"\"maxCost\": 1.5 | event/exact", "\"maxCost\": 1.49 | event/double",
        "\"maxCost\": 0.5 | step/2", "\"maxCost\": 1.5, \"maxPositionError\": 50, \"share\": 0.999 | step/2",
        "\"maxCost\": 1.2, \"maxPositionError\": 0.01, \"share\": 0.999 | event/double",
        "\"maxCost\": \"3us\" | event/exact", "\"maxCost\": \"2500ns\" | event/double"})
    void aBudgetTakesARung(String accuracy, String rung) throws IOException {
        Path kept = calibrated();
        Files.writeString(kept, Files.readString(kept).replace("\"states\"", "\"unitNanos\": 2000, \"states\""));
        assertEquals(rung, load(write(text(accuracy))).accuracy().text());
    }

    /** The error names the rungs that no other beats. */
    @Test
    void aBudgetThatNoRungMeetsIsRefusedWithTheFront() throws IOException {
        Path kept = calibrated();
        Path file = write(text("\"maxCost\": 0.3"));
        assertEquals(file + ":3:27: accuracy.maxCost: found at most 0.3 turns of event/double, for which no rung meets "
            + "the demand, expected one that some rung meets; in 99% of states (" + kept + ") the best are: step/2 at "
            + "0.400, off by 10 u; event/official at 0.970, off by 0.001 u; event/double at 1.00, off by 1e-9 u; "
            + "event/exact at 1.50, off by 1e-12 u", refusal(file));
        assertTrue(refusal(write(text("\"maxCost\": \"3us\""))).contains("a cost in time and figures in " + kept
            + " that have none, expected those of a calibration: steward tradeoff --calibrate"));
    }

    @Test
    void theSceneAsUsedStatesTheRungAndNeedsNoFigures() throws IOException {
        Path kept = calibrated();
        Scene scene = load(write(demand("0.01", "0.999")));
        assertEquals(new AccuracyChoice(Accuracy.parse("event/double"), false, "the most accurate of those within "
            + "5% of the cheapest that are off by at most 0.01 u in 99.9% of states: by 1e-5 u, shown by 100000 ("
            + kept + "), at 1.00 times the cost of event/double", scene.choice().met()), scene.choice());
        assertEquals("event/double at 1.00, off by 1e-5 u", scene.choice().met().get(1));
        assertTrue(scene.json().endsWith("\"accuracy\":{\"advance\":\"event\",\"arithmetic\":\"double\"}}"),
            scene.json());
        Scene again = SceneReader.read(scene.json(), "header");
        assertEquals(scene, again);
        assertEquals(scene.accuracy(), again.accuracy());
        again.root().block("pods").has("perPlayer");
        again.root().block("pods").has("x");
        again.root().done();
    }

    @Test
    void withoutFiguresTheCommandToRunIsNamed() throws IOException {
        Path file = write(demand("0.01", "0.999"));
        assertEquals(file + ":3:15: accuracy: found a demand without figures, expected those of a calibration: "
            + "steward tradeoff --calibrate " + file, refusal(file));
        assertEquals("a header:3:15: accuracy: found a demand without figures, expected those of a calibration: "
            + "steward tradeoff --calibrate SCENE", assertThrows(SceneException.class,
                () -> SceneReader.read(demand("0.01", "0.999"), "a header")).getMessage());
        assertEquals("step/4", SceneReader.read(SceneFiles.load(file.toString()), Accuracy.step(4)).accuracy().text());
    }

    @Test
    void figuresOfOtherPhysicsAreOutOfDate() throws IOException {
        String key = SceneKey.of(SceneReader.read(text("\"advance\": \"step\", \"steps\": 1"), "s"));
        Path kept = Files.writeString(folder.resolve("s.accuracy.json"), figures(key, "0123456789abcdef", EXACT));
        Path file = write(demand("0.01", "0.999"));
        assertEquals(file + ":3:15: accuracy: found figures in " + kept + " that another version of the physics has "
            + "measured, expected those of a calibration: steward tradeoff --calibrate " + file + " --overwrite",
            refusal(file));
    }

    @Test
    void figuresOfAnotherSceneAreNotTaken() throws IOException {
        Path kept = calibrated();
        Path file = write(demand("0.01", "0.999").replace("2.50", "2.51"));
        assertEquals(file + ":3:15: accuracy: found figures in " + kept + " of a scene that says something else, "
            + "expected those of a calibration: steward tradeoff --calibrate " + file + " --overwrite", refusal(file));
    }

    @Test
    void aDemandThatNoRungMeetsIsToldTheBest() throws IOException {
        Path kept = calibrated();
        Path file = write(demand("1e-15", "0.999"));
        assertEquals(file + ":3:36: accuracy.maxPositionError: found 1e-15, which no rung meets, expected at least "
            + "2e-12, the error of the best one, event/exact, in 99.9% of states, shown by 100000 (" + kept
            + "); the best are: step/2 at 0.400, off by 50 u; event/official at 0.970, off by 0.01 u; event/double at "
            + "1.00, off by 1e-5 u; event/exact at 1.50, off by 2e-12 u", refusal(file));
    }

    /** Figures of before laws had versions are of the first law: event/exact has a second. */
    @Test
    void figuresOfTheFirstLawHoldOnRungsThatStillHaveIt() throws IOException {
        String key = SceneKey.of(SceneReader.read(text("\"advance\": \"step\", \"steps\": 1"), "s"));
        Files.writeString(folder.resolve("s.accuracy.json"), figures(key, "b8309ca632eecf63", EXACT, EVENT, STEP));
        assertEquals("event/double", load(write(demand("0.01", "0.999"))).accuracy().text());
        String refused = refusal(write(demand("1e-11", "0.999")));
        assertTrue(refused.contains(", without those whose law has changed since); the best are: "), refused);
    }

    /** No sample shows that nothing exceeds an error. */
    @Test
    void aDemandBeyondWhatASampleShowsIsRefused() throws IOException {
        calibrated();
        Path file = write(demand("1", "1"));
        assertEquals(file + ":3:48: accuracy.share: found 1, expected at most 0.9999: what no state of a sample "
            + "exceeds, others may", refusal(file));
    }

    @Test
    void aShareThatTooFewStatesShowIsSaidToBeUnknown() throws IOException {
        String key = SceneKey.of(SceneReader.read(text("\"advance\": \"step\", \"steps\": 1"), "s"));
        Path kept = Files.writeString(folder.resolve("s.accuracy.json"), presentFigures(key,
            EVENT.replace("2e-5", "\"unknown\"")));
        Path file = write(demand("1", "0.9995"));
        assertEquals(file + ":3:48: accuracy.share: found 0.9995, expected a smaller one: nothing is known of this "
            + "share from 100000 states (" + kept + ")", refusal(file));
    }

    /** Whatever is demanded, no other rung is both cheaper and more accurate than the one that is taken. */
    @Test
    void noRungIsOfferedThatAnotherBeats() {
        SplitMix64 random = new SplitMix64(19);
        for (int n = 0; n < 2000; n++) {
            List<AccuracyFigures.OfRung> rungs = new ArrayList<>();
            for (Accuracy rung : Accuracy.ladder()) {
                double[] errors = random(random, 5).sorted().toArray();
                rungs.add(new AccuracyFigures.OfRung(rung, "", 0.5 + random.nextDouble(), 1,
                    Arrays.stream(errors).boxed().toList(), errors[4]));
            }
            rungs.sort(Comparator.comparingDouble(AccuracyFigures.OfRung::cost));
            AccuracyDemand demand = new AccuracyDemand(random.nextDouble(), 0.9999 * (1 - random.nextDouble()));
            String seed = "case " + n;
            new AccuracyFigures("s", "", "", 1, Double.NaN, rungs).cheapest(demand).ifPresent(taken -> {
                assertTrue(taken.error(demand.share()) <= demand.maxPositionError(), seed);
                assertTrue(rungs.stream().noneMatch(other -> other.cost() < taken.cost()
                    && other.error(demand.share()) < taken.error(demand.share())), seed);
            });
        }
    }

    private static DoubleStream random(SplitMix64 random, int count) {
        return DoubleStream.generate(random::nextDouble).limit(count);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "\"maxPositionError\": 0.1 | accuracy.share: found nothing, expected a number 0..1",
        "\"share\": 0.9 | accuracy.maxPositionError: found nothing, expected a number of at least 0",
        "\"maxPositionError\": 0, \"share\": 0.9 | accuracy.maxPositionError: found 0, expected a number above 0",
        "\"maxPositionError\": -1, \"share\": 0.9 | accuracy.maxPositionError: found -1, expected a number of at "
            + "least 0",
        "\"maxPositionError\": 1, \"share\": 0 | accuracy.share: found 0, expected a number above 0, up to 1",
        "\"maxPositionError\": 1, \"share\": 1.5 | accuracy.share: found 1.5, expected a number 0..1",
        "\"maxPositionError\": 1, \"share\": \"most\" | accuracy.share: found the text \"most\", "
            + "expected a number 0..1",
        "\"maxCost\": 0 | accuracy.maxCost: found 0, expected a number above 0",
        "\"maxCost\": \"2 h\" | accuracy.maxCost: found \"2 h\", expected a number above 0, or a time such as \"2us\" "
            + "or \"500ns\"",
        "\"maxPositionError\": 1, \"share\": 1, \"advance\": \"event\" | accuracy.advance: found an unknown field, "
            + "expected one of \"maxCost\", \"maxPositionError\", \"share\""})
    void aWrongDemandIsRefused(String accuracy, String message) throws IOException {
        String refusal = refusal(write(text(accuracy)));
        assertTrue(refusal.endsWith(": " + message), refusal);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "\"format\": 2 | \"format\": 3 | format: found 3, expected 2, the one that this version reads",
        "\"format\": 2 | \"format\": 1 | format: found 1, expected 2; figures of an earlier version have no costs: "
            + "steward tradeoff --calibrate SCENE --overwrite makes them anew",
        "\"cost\": 1.5 | \"cots\": 1.5 | cost: found nothing, expected a number of at least 0",
        "\"largestError\": 3e-5 | \"largestError\": -1 | largestError: found -1, expected a number of at least 0",
        "\"0.9999\": 2e-5 | \"0.9999\": 1e-6 | positionErrors.0.9999: found 1e-6, expected a number of at least 1e-5",
        "\"0.9999\": 2e-5 | \"2\": 3e-5 | positionErrors.0.9999: found nothing, expected a number of at least 1e-5",
        "\"event/double\" | \"event/dubble\" | rung: found \"event/dubble\", expected a rung of the ladder",
        "\"states\": 100000 | \"states\": 0 | states: found 0, expected a whole number"})
    void damagedFiguresAreRefusedWithTheirPlace(String right, String wrong, String message) throws IOException {
        Path kept = calibrated();
        String text = Files.readString(kept);
        assertTrue(text.contains(right));
        Files.writeString(kept, text.replace(right, wrong));
        String refusal = refusal(write(demand("1", "0.9")));
        assertTrue(refusal.startsWith(kept + ":") && refusal.contains(message), refusal);
    }

    @Test
    void aFileThatIsCutOffIsSaidToBeNoScene() throws IOException {
        Path kept = calibrated();
        Files.writeString(kept, "{");
        String refusal = refusal(write(demand("1", "0.9")));
        assertTrue(refusal.startsWith(kept + ":1:2: not JSON: "), refusal);
        assertTrue(refusal.endsWith(", expected all of it"), refusal);
    }

    @Test
    void theKeyIsOfWhatMattersAndNotOfHowItIsSpelt() {
        String key = key(text("\"advance\": \"step\", \"steps\": 1"));
        assertEquals(key, key(demand("1", "1").replace("\"s\"", "\"other\"").replace("1000", "9")
            .replace("2.50", "25e-1").replace("\"game\": \"g\", \"players\": 2", "\"players\": 2.0, \"game\": \"g\"")));
        assertFalse(key.equals(key(demand("1", "1").replace("\"perPlayer\": 1", "\"perPlayer\": 3"))));
        assertFalse(key.equals(key(demand("1", "1").replace("\"a\"", "\"b\""))));
        assertFalse(key.equals(key(demand("1", "1").replace("[ 1, 2.50", "[ 2.50, 1"))));
    }

    private static String key(String text) {
        return SceneKey.of(new Block("s", "", JsonTree.read(text, "s", "a scene")));
    }
}

package steward.lab.calibration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.Pilot;
import steward.game.podrace.protocol.PodRaceType;
import steward.lab.oracle.TurnTruth;
import steward.lab.timing.RungJob;
import steward.lab.timing.Stretch;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.lab.trial.Probe;
import steward.physics.Bodies;
import steward.scene.AccuracyFigures;
import steward.scene.AccuracyFigures.OfRung;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** How far off the rungs are in a scene's own states. */
@Execution(ExecutionMode.CONCURRENT)
class CalibrationTest {

    /** Both pods make for the same place, by ways that differ from turn to turn. */
    private static final Pilot CROWD = (game, player, random) ->
        "{\"pods\":[{\"x\":" + random.nextInt(7000, 8000) + ",\"y\":4000,\"thrust\":" + random.nextInt(50, 200) + "}]}";

    private static GameSetup duel() {
        SceneText text = SceneFiles.load("duel");
        return new GameTypes(List.of(new PodRaceType())).open(text.text(), text.source());
    }

    /** Times that say nothing: only the errors are looked at. */
    private static final Timing<RungJob> NO_TIMES = new Timing<>(new TimingEffort(1, 1, 0, 0, 0),
        job -> least -> new Stretch(1, 0));

    private static Calibration calibration(int states) {
        GameSetup setup = duel();
        Calibration calibration = new Calibration(setup, seed -> new SeededPlay(setup, CROWD, seed), states);
        calibration.time(NO_TIMES, () -> { });
        return calibration;
    }

    @Test
    @Tag("slow")
    void theFiguresDoNotDependOnTheThreads() throws InterruptedException {
        List<String> texts = new ArrayList<>();
        for (int threads : new int[] {1, 3}) {
            Calibration calibration = calibration(2100);
            List<Integer> done = Collections.synchronizedList(new ArrayList<>());
            calibration.run(threads, () -> done.add(1));
            assertEquals(3, calibration.blocks());
            assertEquals(3, done.size());
            texts.add(calibration.text(calibration.figures(), "2030-01-02", "a \"machine\""));
        }
        assertEquals(texts.get(0), texts.get(1));
        AccuracyFigures figures = AccuracyFigures.read(texts.get(0), "text");
        assertEquals(2100, figures.states());
        assertEquals(15, figures.rungs().size());
    }

    /** The figures say what flying one state after the other says. */
    @Test
    void theErrorsAreThoseOfTheStates() throws InterruptedException {
        Calibration calibration = calibration(400);
        calibration.run(2, () -> { });
        GameSetup setup = duel();
        SeededPlay play = new SeededPlay(setup, CROWD, 0);
        double[] errors = new double[400];
        int withImpacts = 0;
        for (int k = 0; k < errors.length; k++) {
            Bodies bodies = play.next();
            TurnTruth truth = TurnTruth.of(bodies, setup.plan().physics(null));
            setup.plan().advance(null).turn(bodies, new Probe());
            errors[k] = truth.positionError(bodies);
            withImpacts += truth.impacts() > 0 ? 1 : 0;
        }
        Arrays.sort(errors);
        Calibration.Figures figures = calibration.figures();
        OfRung official = figures.rungs().get(11);
        assertEquals("event/official", official.rung().text());
        // Of 400 states, 176 may exceed the middle and 26 the error of nine in ten (Clopper and Pearson, 99%); for 99%
        // at least 459 states are needed.
        double unknown = Double.POSITIVE_INFINITY;
        assertEquals(List.of(errors[399 - 176], errors[399 - 26], unknown, unknown, unknown), official.errors());
        assertEquals(errors[399], official.largest());
        assertEquals(1, figures.rungs().get(12).cost(), "event/double");
        assertEquals(withImpacts, figures.withImpacts());
        assertTrue(withImpacts > 20, "so few meet: " + withImpacts);
    }

    @Test
    void withoutTimesThereAreNoFigures() throws InterruptedException {
        GameSetup setup = duel();
        Calibration calibration = new Calibration(setup, seed -> new SeededPlay(setup, CROWD, seed), 10);
        calibration.run(1, () -> { });
        assertEquals(0, calibration.figures().states());
        calibration.time(NO_TIMES, () -> { });
        assertEquals(10, calibration.figures().states());
    }

    /** One look for one pair and step; steps that are halved miss less, and exact is the best. */
    @Test
    @Tag("slow")
    void workIsCountedAndGrowsWithTheSteps() throws InterruptedException {
        Calibration calibration = calibration(1000);
        calibration.run(2, () -> { });
        List<OfRung> rungs = calibration.figures().rungs();
        for (int k = 1; k < 11; k++) {
            assertEquals(1 << k, Math.floor(rungs.get(k).work()));
        }
        assertTrue(rungs.get(0).largest() > rungs.get(10).largest());
        double exact = rungs.get(14).largest();
        assertTrue(rungs.stream().allMatch(rung -> rung.largest() >= exact));
        assertTrue(exact < 1e-10, "" + exact);
    }

    @Test
    @Tag("slow")
    void whatIsDoneCanBeTakenAtAnyTime() throws InterruptedException {
        Calibration calibration = calibration(3000);
        assertEquals(0, calibration.figures().states());
        List<Integer> states = new ArrayList<>();
        calibration.run(1, () -> states.add(calibration.figures().states()));
        assertEquals(List.of(1000, 2000, 3000), states);
    }

    @Test
    void aFailureIsNotSwallowed() {
        Calibration calibration = new Calibration(duel(), seed -> {
            throw new IllegalArgumentException("no such play");
        }, 10);
        String message = assertThrows(IllegalArgumentException.class, () -> calibration.run(2, () -> { })).getMessage();
        assertTrue(message.contains("no such play"), message);
    }

    /**
     * Of 1..1000, in order: 1000 states show that one half of all have at most an error that 462 exceed, by the sum of
     * binomial probabilities in whole numbers (99%); they show nothing of 99.9%, for which 4,603 are needed:
     * 0.999^4603 = 0.01.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 538", "0.9, 922", "0.99, 998", "0.999, Infinity"})
    void anErrorAtAShareIsExceededByNoMoreThanTheRest(String share, double error) {
        double[] sorted = new double[1000];
        Arrays.setAll(sorted, k -> k + 1);
        assertEquals(error, Calibration.atShare(sorted, share));
        assertEquals(Double.POSITIVE_INFINITY, Calibration.atShare(new double[] {7}, share));
    }
}

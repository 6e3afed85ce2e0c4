package steward.lab.calibration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.Pilot;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingSamples;
import steward.numerics.Median;
import steward.physics.Bodies;
import steward.scene.Part;
import steward.scene.Scene;
import steward.scene.SceneKey;
import steward.scene.price.MeasuredPrices;
import steward.scene.price.PartPrice;
import steward.scene.price.StoredPartPrices;

/**
 * The time that each part of a scene's engine adds to a turn on this machine. States of seeded play are played with the
 * {@link PartByPartPhysics} of the scene, each step in a JVM of its own, round after round; a price is the median over
 * the rounds of the difference of two steps. The price of the game's parts is the time of the game before and after its
 * bodies fly, measured in games whose bodies do not move; parts that work at the same point of a turn share a price.
 */
public final class PartPrices {

    private static final int STATES = 256;
    private static final long SEED = 1;

    private final PartSlices slices;
    private final List<Bodies> states;

    /** Draws states of seeded play. */
    public PartPrices(Scene scene, GameTypes types) {
        GameSetup setup = types.open(scene);
        SeededPlay play = new SeededPlay(setup, setup.pilot(Pilot.Aim.WIN), SEED);
        states = Stream.generate(play::next).limit(STATES).toList();
        slices = new PartSlices(scene, types, states);
    }

    /** Returns how many jobs {@link #measure} times. */
    public int jobs() {
        return slices.count();
    }

    /**
     * Measures the prices.
     *
     * @param timing times a {@link PartJob} for each slice
     * @param step   called after each step of it
     */
    public MeasuredPrices measure(Timing timing, Runnable step) {
        String scene = slices.setup().scene().json();
        List<byte[]> jobs = IntStream.range(0, slices.count())
            .mapToObj(slice -> new PartJob(scene, slice, states).bytes()).toList();
        return result(timing.run(jobs, step));
    }

    /** Returns the prices of a scene as rows of the stored file. */
    public static List<StoredPartPrices.Row> rows(Scene scene, MeasuredPrices prices, String date, String machine) {
        double turn = prices.turn().nanos();
        return prices.prices().stream().map(price -> new StoredPartPrices.Row(scene.name(), scene.gameId(),
            SceneKey.of(scene), scene.accuracy().text(), price.part(), price.in(), price.nanos() / turn,
            price.error() / turn, date, machine)).toList();
    }

    private MeasuredPrices result(TimingSamples samples) {
        List<PartPrice> prices = new ArrayList<>();
        int whole = slices.ofStep(-1);
        List<PartByPartPhysics.Step> steps = slices.steps();
        for (int k = 0; k < steps.size(); k++) {
            PartByPartPhysics.Step step = steps.get(k);
            int slice = slices.ofStep(k);
            prices.add(difference(samples, step.part(), step.in(), slice, step.in() ? slice - 1 : whole));
            whole = step.in() ? slice : whole;
        }
        for (Part part : slices.setup().plan().parts()) {
            if (part.when() == Part.When.COMMANDS) {
                prices.add(difference(samples, part.name(), part.in(), slices.commands(), slices.outcome()));
            } else if (part.when() == Part.When.OUTCOME) {
                prices.add(difference(samples, part.name(), part.in(), slices.outcome(), slices.motion()));
            }
        }
        int flown = whole;
        return new MeasuredPrices(prices, price("", true, samples.perRepeat(nanos ->
            nanos[flown] - nanos[slices.motion()] + nanos[slices.commands()])), samples.rounds());
    }

    private static PartPrice difference(TimingSamples samples, String part, boolean in, int more, int less) {
        return price(part, in, samples.perRepeat(nanos -> nanos[more] - nanos[less]));
    }

    private static PartPrice price(String part, boolean in, double[] repeats) {
        return new PartPrice(part, in, Median.of(repeats),
            (Arrays.stream(repeats).max().getAsDouble() - Arrays.stream(repeats).min().getAsDouble()) / 2);
    }
}

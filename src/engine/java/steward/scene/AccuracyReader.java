package steward.scene;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import steward.physics.Arithmetic;
import steward.physics.ImpactLaw;
import steward.physics.event.StepAdvance;
import steward.scene.json.Block;
import steward.scene.json.SceneException;

/** Reads the block {@code accuracy} of a scene: a rung of the ladder, or a demand for which a rung is chosen. */
final class AccuracyReader {

    private static final String ERROR = "maxPositionError";
    private static final String SHARE = "share";

    private AccuracyReader() {
    }

    /**
     * @param scene   the whole file
     * @param law     its law of impact
     * @param figures where figures of this scene's accuracy may be
     * @param instead a rung that replaces the one of the file, or {@code null}
     * @throws SceneException if there is no such rung, or none is known to meet the demand
     */
    static AccuracyChoice read(Block scene, ImpactLaw law, Optional<Path> figures, Accuracy instead) {
        Block block = scene.block("accuracy");
        if (block.contains(ERROR) || block.contains(SHARE)) {
            AccuracyDemand demand = new AccuracyDemand(positive(block, ERROR, Double.POSITIVE_INFINITY),
                positive(block, SHARE, 1));
            block.done();
            return instead == null ? AccuracyFigures.choose(demand, scene, law, figures)
                : overridden(instead, demand.text());
        }
        Accuracy rung = rung(block);
        if (instead == null) {
            return AccuracyChoice.stated(rung);
        }
        block.done();
        return overridden(instead, rung.text());
    }

    private static AccuracyChoice overridden(Accuracy instead, String inFile) {
        return new AccuracyChoice(instead, false, "as the call says; the scene's own is " + inFile);
    }

    /** A number above 0, however small: a scene of short lengths may demand less than others can have. */
    private static double positive(Block block, String name, double high) {
        double value = block.number(name, 0, high);
        if (value == 0) {
            throw block.error(name, block.shown(name), "a number above 0" + (high == 1 ? ", up to 1" : ""));
        }
        return value;
    }

    private static Accuracy rung(Block block) {
        Map<String, Accuracy.Way> ways = new LinkedHashMap<>();
        for (Accuracy.Way way : Accuracy.Way.values()) {
            ways.put(way.text(), way);
        }
        Accuracy.Way way = block.choice("advance", ways);
        if (way == Accuracy.Way.EVENT) {
            return Accuracy.event(block.choice("arithmetic", Accuracy.arithmetics()));
        }
        Arithmetic arithmetic = block.choice("arithmetic", Accuracy.arithmetics(), Arithmetic.DOUBLE);
        int steps = block.integer("steps", 1, StepAdvance.MOST_STEPS);
        if (arithmetic != Arithmetic.DOUBLE) {
            throw block.error("arithmetic", block.shown("arithmetic"), Accuracy.ONLY_DOUBLE);
        }
        return Accuracy.step(steps);
    }
}

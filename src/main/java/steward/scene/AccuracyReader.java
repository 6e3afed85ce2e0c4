package steward.scene;

import java.util.LinkedHashMap;
import java.util.Map;
import steward.physics.Arithmetic;
import steward.physics.StepAdvance;

/** Reads the block {@code accuracy} of a scene. */
final class AccuracyReader {

    private AccuracyReader() {
    }

    /** @throws SceneException if there is no such rung */
    static Accuracy read(Block block) {
        Map<String, Accuracy.Way> ways = new LinkedHashMap<>();
        for (Accuracy.Way way : Accuracy.Way.values()) {
            ways.put(way.text(), way);
        }
        Accuracy.Way way = block.choice("advance", ways);
        Arithmetic arithmetic = block.choice("arithmetic", Accuracy.arithmetics());
        if (way == Accuracy.Way.EVENT) {
            return Accuracy.event(arithmetic);
        }
        int steps = block.integer("steps", 1, StepAdvance.MOST_STEPS);
        if (arithmetic != Arithmetic.DOUBLE) {
            throw block.error("arithmetic", block.shown("arithmetic"), Accuracy.ONLY_DOUBLE);
        }
        return Accuracy.step(steps);
    }
}

package steward.scene;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.physics.Arithmetic;
import steward.physics.ImpactLaw;
import steward.physics.event.StepAdvance;
import steward.scene.json.Block;
import steward.scene.json.SceneException;

/** Reader of a scene's block {@code accuracy}: a rung of the ladder, or a demand from which a rung is chosen. */
final class AccuracyReader {

    private static final String ERROR = "maxPositionError";
    private static final String SHARE = "share";
    private static final String COST = "maxCost";
    private static final Pattern TIME = Pattern.compile("([0-9]{1,9}(?:\\.[0-9]{1,9})?)(us|ns)");
    private static final double NANOS_PER_US = 1000;
    /** Of the states, by whose error rungs are compared where only a cost is stated. */
    private static final double USUAL_SHARE = 0.99;

    /**
     * @param scene   the whole file
     * @param figures where figures of this scene's accuracy may be
     * @param instead a rung that replaces the one of the file, or {@code null}
     * @throws SceneException if there is no such rung, or none is known to meet the demand
     */
    static AccuracyChoice read(Block scene, ImpactLaw law, Optional<Path> figures, Accuracy instead) {
        Block block = scene.block("accuracy");
        if (block.contains(ERROR) || block.contains(SHARE) || block.contains(COST)) {
            AccuracyDemand demand = demand(block);
            block.done();
            return instead == null ? RungChooser.choose(demand, scene, law, figures)
                : overridden(instead, demand.text());
        }
        Accuracy rung = rung(block);
        if (instead == null) {
            return AccuracyChoice.stated(rung);
        }
        block.done();
        return overridden(instead, rung.text());
    }

    /** An error with its share, a cost, or both; with a cost alone the share may be left out. */
    private static AccuracyDemand demand(Block block) {
        boolean hasCost = block.has(COST);
        double error = hasCost && !block.contains(ERROR) ? Double.POSITIVE_INFINITY
            : positive(block, ERROR, Double.POSITIVE_INFINITY);
        double share = hasCost && !block.contains(ERROR) && !block.contains(SHARE) ? USUAL_SHARE
            : positive(block, SHARE, 1);
        if (!hasCost) {
            return new AccuracyDemand(error, share);
        }
        if (!block.isText(COST)) {
            return new AccuracyDemand(error, share, positive(block, COST, Double.POSITIVE_INFINITY),
                Double.POSITIVE_INFINITY);
        }
        Matcher time = TIME.matcher(block.text(COST));
        if (!time.matches() || Double.parseDouble(time.group(1)) == 0) {
            throw block.error(COST, block.shown(COST), "a number above 0, or a time such as \"2us\" or \"500ns\"");
        }
        return new AccuracyDemand(error, share, Double.POSITIVE_INFINITY,
            Double.parseDouble(time.group(1)) * (time.group(2).equals("us") ? NANOS_PER_US : 1));
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

package steward.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import steward.physics.Arithmetic;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.ImpactLaw.ScanOrder;
import steward.physics.Motion;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/** Reader of the fields and blocks that scenes of all games share. */
public final class SceneReader {

    private static final int MOST_PLAYERS = 16;
    private static final int LONGEST_NAME = 100;

    /** An hour. */
    private static final int MOST_MS = 3_600_000;

    /** A turn with as many takes seconds; the default bound of a thousand bodies is near it. */
    private static final int MOST_IMPACTS = 1_000_000;

    /** The block of a scene whose referee is a program of its own: it sets limits, and there is no rung. */
    public static final String REFEREE = "referee";
    private static final Time UNSET = new Time(1, 1);

    /** Names the JSON Schema for editors; stands at the top of a file and means nothing here. */
    static final String SCHEMA = "$schema";

    private SceneReader() { }

    /**
     * Leaves the game's blocks unread: their reader calls {@link Block#done()} on the scene's root at the end.
     *
     * @param text   the file
     * @param source names it in errors
     * @throws SceneException if the text is not JSON, or a common field is missing or not as it has to be
     */
    public static Scene read(String text, String source) {
        return read(new SceneText(text, source), null);
    }

    /**
     * Reads a file that may have figures of accuracy beside it. The scene returned states the rung that it is computed
     * on, even if the file states a demand: a replay of it needs no figures.
     *
     * @param instead a rung that replaces the one of the file, or {@code null}
     */
    public static Scene read(SceneText text, Accuracy instead) {
        Block root = CsvLines.takenIn(text, new Block(text.source(), "", JsonTree.read(text.text(), text.source(),
            "a scene")));
        root = text.figures().isEmpty() ? root : RefereeWords.found(root, text.figures().get());
        if (root.contains(SCHEMA)) {
            root.text(SCHEMA);
        }
        String name = root.text("name");
        if (name.isBlank() || name.chars().anyMatch(Character::isISOControl)) {
            throw root.error("name", root.shown("name"), "a name without control characters");
        }
        if (name.length() > LONGEST_NAME) {
            throw root.error("name", "a name of " + name.length() + " characters", "at most " + LONGEST_NAME);
        }
        String game = root.text("game");
        int players = root.integer("players", 0, MOST_PLAYERS);
        if (root.contains(REFEREE)) {
            if (instead != null) {
                throw root.error(REFEREE, "a referee of its own", "a game that Steward computes, whose accuracy "
                    + "can be chosen");
            }
            return new Scene(name, game, players, Optional.empty(), ImpactLaw.PHYSICS, 0, new Motion(List.of()), UNSET,
                AccuracyChoice.stated(Accuracy.event(Arithmetic.DOUBLE)), PhysicsObserver.NONE, root);
        }
        Optional<Field> field = root.optionalBlock("field").map(FieldReader::read);
        ImpactLaw law = root.optionalBlock("impacts").map(SceneReader::law).orElse(ImpactLaw.PHYSICS);
        Optional<Block> motion = root.optionalBlock("motion");
        Time time = players == 0 && !root.contains("time") ? UNSET : time(root.block("time"));
        AccuracyChoice choice = AccuracyReader.read(root, law, text.figures(), instead);
        double drag = motion.map(block -> block.number("drag", 0, 1, 0)).orElse(0.0);
        return new Scene(name, game, players, field, law, drag,
            motion.map(block -> motion(block, drag > 0)).orElse(new Motion(List.of())),
            time, choice, PhysicsObserver.NONE,
            choice.stated() ? root : root.with("accuracy", choice.rung().json()));
    }

    private static Time time(Block time) {
        return new Time(time.integer("firstAnswerMs", 1, MOST_MS), time.integer("answerMs", 1, MOST_MS));
    }

    /** Fields that are absent change nothing; drag comes first, and positions come last unless they are said to. */
    private static Motion motion(Block block, boolean drag) {
        List<Motion.Step> steps = new ArrayList<>();
        if (drag) {
            steps.add(Motion.Step.DRAG);
        }
        Motion.Step velocity = block.choice("velocity", named(Motion.Of.VELOCITY), null);
        if (velocity != null) {
            steps.add(velocity);
        }
        Motion.Step position = block.choice("position", named(Motion.Of.POSITION), null);
        boolean first = block.choice("first", Map.of("velocity", false, "position", true), false);
        if (position != null) {
            steps.add(first ? 0 : steps.size(), position);
        }
        return new Motion(steps);
    }

    private static Map<String, Motion.Step> named(Motion.Of about) {
        Map<String, Motion.Step> named = new TreeMap<>();
        for (Motion.Step step : Motion.Step.values()) {
            if (step.about() == about) {
                named.put(step.text(), step);
            }
        }
        return named;
    }

    /** Fields that are absent are as in {@link ImpactLaw#PHYSICS}. */
    private static ImpactLaw law(Block block) {
        double minimumImpulse = block.number("minimumImpulse", 0, Block.MAXIMUM, 0);
        boolean atWalls = block.flag("minimumImpulseAtWalls", false);
        double deadZone = block.number("deadZone", 0, Block.MAXIMUM, Double.NaN);
        boolean react = block.choice("separatingPairs", Map.of("ignore", false, "react", true), false);
        double batchWindow = block.number("batchWindow", 0, 1, 0);
        ScanOrder order = block.choice("scanOrder",
            Map.of("ascending", ScanOrder.ASCENDING, "descending", ScanOrder.DESCENDING), ScanOrder.ASCENDING);
        double pushOut = block.number("pushOut", 0, Block.MAXIMUM, Double.NaN);
        int maximumImpacts = block.integer("maximumImpactsPerTurn", 1, MOST_IMPACTS, 0);
        double restSpeed = block.number("restSpeed", 0, Block.MAXIMUM, Double.NaN);
        if (minimumImpulse == 0 && !react && (atWalls || !Double.isNaN(deadZone))) {
            throw block.error(atWalls ? "minimumImpulseAtWalls" : "deadZone", "no minimumImpulse to go with it",
                "a minimumImpulse above 0");
        }
        try {
            return new ImpactLaw(Restitution.ELASTIC, minimumImpulse, atWalls, deadZone, react, batchWindow, order,
                pushOut, maximumImpacts, restSpeed);
        } catch (IllegalArgumentException refusal) {
            throw block.error(refusal);
        }
    }
}

package steward.game.fantasticbits;

import java.util.List;
import java.util.Map;
import steward.physics.Arithmetic;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.ImpactLaw.ScanOrder;
import steward.physics.Wall;
import steward.scene.Accuracy;
import steward.scene.Bumper;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * Settings of a match of Fantastic Bits: the block {@code match} of a scene.
 *
 * @param variant      what some spells cost and how long they work, and what a player reads
 * @param maximumTurns turns after which the game ends, 1..10000
 * @param bludgers     true if there are bludgers; not in the lowest league
 * @param spells       true if players gather magic; without any, no spell works
 */
public record FantasticBitsSettings(Variant variant, int maximumTurns, boolean bludgers, boolean spells) {

    public static final int PLAYERS = 2;

    /** The referee's expressions as a law; the rungs other than {@code event/official} compute by it. */
    static final ImpactLaw LAW = new ImpactLaw(Restitution.ELASTIC, 100, false, Double.NaN, true, 1e-5,
        ScanOrder.DESCENDING, 1e-5, 0);

    private static final double GOAL_LINE = EntityKind.SNAFFLE.radius();
    private static final List<Wall> WALLS = List.of(
        new HalfPlane(0, 0, 1, 0, 1), new HalfPlane(0, 0, 0, 1, 1),
        new HalfPlane(Pitch.WIDTH, 0, -1, 0, 1), new HalfPlane(0, Pitch.HEIGHT, 0, -1, 1),
        new HalfPlane(-GOAL_LINE, 0, 1, 0, 1), new HalfPlane(Pitch.WIDTH + GOAL_LINE, 0, -1, 0, 1));

    private static final int MOST_TURNS = 10_000;

    /**
     * Reads the block and checks what the game needs of the common ones: its walls, goal lines and goal posts; no block
     * {@code motion}; and on the rung {@code event/official} the referee's own law of impact.
     *
     * @throws steward.scene.json.SceneException if something is missing or not as the game needs it
     */
    public static FantasticBitsSettings read(Scene scene) {
        Block root = scene.root();
        if (root.contains("motion")) {
            throw root.error("motion", "a block motion",
                "none: the end of a turn is part of the rules of Fantastic Bits");
        }
        List<Wall> walls = scene.field().map(field -> field.walls()).orElse(List.of());
        List<Bumper> bumpers = scene.field().map(field -> field.bumpers()).orElse(List.of());
        if (!walls.equals(WALLS) || !bumpers.equals(Pitch.POSTS)) {
            throw root.error("field", "another field",
                "the pitch of Fantastic Bits as in the scene fantastic-bits: four "
                + "walls, two goal lines, and the goal posts as bumpers");
        }
        if (scene.accuracy().equals(Accuracy.event(Arithmetic.OFFICIAL))
            && !scene.law().withMaximumImpacts(0).equals(LAW)) {
            throw root.error("impacts", "another law of impact",
                "that of the scene fantastic-bits, or another rung than event/official");
        }
        Block match = root.block("match");
        return new FantasticBitsSettings(match.choice("variant", Map.of(Variant.CONTEST.text(), Variant.CONTEST,
            Variant.PUZZLE.text(), Variant.PUZZLE)), match.integer("maximumTurns", 1, MOST_TURNS),
            match.flag("bludgers", true), match.flag("spells", true));
    }
}

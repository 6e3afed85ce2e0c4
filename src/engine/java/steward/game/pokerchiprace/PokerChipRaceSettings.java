package steward.game.pokerchiprace;

import java.util.List;
import steward.physics.Arithmetic;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Wall;
import steward.scene.Accuracy;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * Settings of a Poker Chip Race: the block {@code chips} of a scene. Missing fields are drawn as the published referee
 * draws them.
 *
 * @param players      2..4
 * @param neutral      most neutral chips at the start, {@link #DRAWN} or 0..200
 * @param perPlayer    chips of each player, {@link #DRAWN} or 1..40
 * @param radius       of the players' chips in u, NaN if drawn, or 1..100
 * @param symmetric    whether the start is symmetric
 * @param maximumTurns turns after which the game ends, 1..1000
 */
public record PokerChipRaceSettings(int players, int neutral, int perPlayer, double radius, boolean symmetric,
                           int maximumTurns) {

    /** A number that the seed decides. */
    public static final int DRAWN = -1;
    public static final int FEWEST_PLAYERS = 2;
    /** The most players: the symmetric start knows no more. */
    public static final int MOST_PLAYERS = 4;

    /** The walls of the table: left, top, right, bottom. */
    static final List<Wall> WALLS = List.of(new HalfPlane(-ChipTable.HALF_WIDTH, 0, 1, 0, 1),
        new HalfPlane(0, -ChipTable.HALF_HEIGHT, 0, 1, 1), new HalfPlane(ChipTable.HALF_WIDTH, 0, -1, 0, 1),
        new HalfPlane(0, ChipTable.HALF_HEIGHT, 0, -1, 1));

    private static final int MOST_NEUTRAL = 200;
    private static final int MOST_PER_PLAYER = 40;
    private static final int LEAST_RADIUS = 1;
    private static final int GREATEST_RADIUS = 100;
    private static final int MOST_TURNS = 1000;

    /**
     * Reads the block and checks what the game needs of the common ones: its table with four walls; no block {@code
     * motion}; and on the rung {@code event/official} the common law of impact without changes.
     *
     * @throws steward.scene.json.SceneException if something is missing or not as the game needs it
     */
    public static PokerChipRaceSettings read(Scene scene) {
        Block root = scene.root();
        if (root.contains("motion")) {
            throw root.error("motion", "a block motion", "none: nothing slows a chip down and nothing is rounded");
        }
        boolean bumpers = scene.field().stream().anyMatch(field -> !field.bumpers().isEmpty());
        List<Wall> walls = scene.field().map(field -> field.walls()).orElse(List.of());
        if (bumpers || !isTable(walls)) {
            throw root.error("field", "another field",
                "the table: x -400, y -257.5, width 800, height 515, walls \"box\", no bumpers");
        }
        if (scene.accuracy().equals(Accuracy.event(Arithmetic.OFFICIAL))
            && !scene.law().withMaximumImpacts(0).equals(ImpactLaw.PHYSICS)) {
            throw root.error("impacts", "another law of impact",
                "none (but for maximumPerTurn), or another rung than event/official");
        }
        Block chips = root.block("chips");
        int turns = chips.integer("maximumTurns", 1, MOST_TURNS);
        int neutral = chips.integer("neutral", 0, MOST_NEUTRAL, DRAWN);
        int perPlayer = chips.integer("perPlayer", 1, MOST_PER_PLAYER, DRAWN);
        double radius = chips.number("radius", LEAST_RADIUS, GREATEST_RADIUS, Double.NaN);
        boolean symmetric = chips.flag("symmetric", scene.players() >= MOST_PLAYERS);
        return new PokerChipRaceSettings(scene.players(), neutral, perPlayer, radius, symmetric, turns);
    }

    /** The order counts, because impacts name a wall by its place in it. */
    private static boolean isTable(List<Wall> walls) {
        boolean is = walls.size() == WALLS.size();
        for (int k = 0; is && k < walls.size(); k++) {
            Wall own = WALLS.get(k);
            is = walls.get(k) instanceof HalfPlane plane && plane.restitution() == own.restitution()
                && own.gap(0, 0, 0) == plane.gap(0, 0, 0) && own.normalX(0, 0) == plane.normalX(0, 0)
                && own.normalY(0, 0) == plane.normalY(0, 0);
        }
        return is;
    }
}

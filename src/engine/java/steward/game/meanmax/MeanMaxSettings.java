package steward.game.meanmax;

import java.util.List;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.ImpactLaw.ScanOrder;
import steward.physics.Wall;
import steward.scene.Accuracy;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * Settings of Mean Max: the block {@code harvest} of a scene.
 *
 * @param winningScore the score that ends the game, 1..1000
 * @param maximumTurns turns after which the game ends, 1..10000
 * @param version      the league by the number that the published referee has for it, 0..{@value #WHOLE}
 */
public record MeanMaxSettings(int winningScore, int maximumTurns, int version) {

    /** The version with all looters and all skills; scenes that name none have it. */
    public static final int WHOLE = 3;

    public static final int PLAYERS = 3;

    /** The referee's expressions as a law; the rungs other than {@code event/official} compute by it. */
    static final ImpactLaw LAW = new ImpactLaw(Restitution.ELASTIC, 30, true, 1e-5, true, 0, ScanOrder.ASCENDING, 1e-5,
        0);

    private static final int MOST_WATER = 1000;
    private static final int MOST_TURNS = 10_000;

    /**
     * Reads the block and checks what the game needs of the common ones: its arena; no block {@code motion}; and on the
     * rung {@code event/official} the referee's own law of impact.
     *
     * @throws steward.scene.json.SceneException if something is missing or not as the game needs it
     */
    public static MeanMaxSettings read(Scene scene) {
        Block root = scene.root();
        if (root.contains("motion")) {
            throw root.error("motion", "a block motion", "none: the end of a turn is part of the rules of Mean Max");
        }
        List<Wall> walls = scene.field().map(field -> field.walls()).orElse(List.of());
        boolean bumpers = scene.field().stream().anyMatch(field -> !field.bumpers().isEmpty());
        if (bumpers || !walls.equals(List.of(new Arena(0, 0, MeanMaxWorld.ARENA_RADIUS, 1)))) {
            throw root.error("field", "another field", "the arena of Mean Max as its only wall: x 0, y 0, radius 6000");
        }
        if (scene.accuracy().equals(Accuracy.event(Arithmetic.OFFICIAL))
            && !scene.law().withMaximumImpacts(0).equals(LAW)) {
            throw root.error("impacts", "another law of impact",
                "that of the scene mean-max, or another rung than event/official");
        }
        Block harvest = root.block("harvest");
        return new MeanMaxSettings(harvest.integer("winningScore", 1, MOST_WATER),
            harvest.integer("maximumTurns", 1, MOST_TURNS), harvest.integer("version", 0, WHOLE, WHOLE));
    }

    /** Looters that a player has: the reaper in version 0, the destroyer too in 1, the doof too from 2 on. */
    public int looters() {
        return Math.min(version + 1, UnitKind.LOOTERS);
    }

    /** True if no tankers come, but wrecks in their place, as in version 0. */
    public boolean hasWrecksOnly() {
        return version == 0;
    }

    /** True if a looter has its skill: only the destroyer in version 2, all in 3. */
    public boolean isActive(Skill skill) {
        return version == WHOLE || version == WHOLE - 1 && skill == Skill.GRENADE;
    }
}

package steward.lab.calibration;

import java.nio.charset.StandardCharsets;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;

/*
 * A game shows its bodies between turns, after the rounding of the last turn; the flight of a turn begins with other
 * velocities, which the commands have changed. They are reconstructed after the turn: for a body that was hit, as the
 * velocity before its first impact; for any other body, as the distance that it has flown. Where the game has rounded
 * the final position, the velocity is known to half a unit, and the rest of it is drawn at random.
 */

/**
 * States that occur in play of a scene: seeded games, one after the other, whose players answer by a script. Each turn
 * gives the bodies as they were when its flight began; but where the game rounds positions, the velocities of bodies
 * without an impact are accurate to half a unit only. Deterministic.
 */
public final class SeededPlay {

    /** A player's answers, each as the line it would send. */
    @FunctionalInterface
    public interface Script {

        /**
         * @param game   its current state
         * @param player the player that answers
         * @param random the play's own generator, used by all players in turn
         */
        String answer(Game game, int player, SplitMix64 random);
    }

    private final GameSetup setup;
    private final Script script;
    private final SplitMix64 random;
    private long gameSeed;
    private Game game;
    private FrameCodec codec;

    /** @param seed of the first game; each further one has the next number. The script draws from it too */
    public SeededPlay(GameSetup setup, Script script, long seed) {
        this.setup = setup;
        this.script = script;
        random = new SplitMix64(seed);
        gameSeed = seed;
    }

    /**
     * Plays a turn; of a new game if the last one is over.
     *
     * @return a new copy of the bodies as they were when its flight began
     * @throws IllegalArgumentException if an answer is refused
     */
    public Bodies next() {
        if (game == null || game.isOver()) {
            game = setup.create(gameSeed++);
            codec = setup.codec(game);
        }
        for (int player = 0; player < game.players(); player++) {
            if (game.isIn(player)) {
                byte[] answer = script.answer(game, player, random).getBytes(StandardCharsets.UTF_8);
                String problem = codec.readAnswer(player, answer, answer.length);
                if (problem != null) {
                    throw new IllegalArgumentException("seeded play of " + setup.scene().name() + ", player " + player
                        + ": " + problem);
                }
            }
        }
        Bodies before = copy(game.bodies());
        game.play();
        return begun(before, game.bodies());
    }

    private static Bodies copy(Bodies bodies) {
        Bodies copy = new Bodies(bodies.capacity());
        copy.copyFrom(bodies);
        return copy;
    }

    /**
     * The positions before the turn with the masses and velocities of the turn; unchanged if bodies were added or
     * removed.
     */
    private Bodies begun(Bodies before, Bodies after) {
        boolean same = before.size() == after.size() && before.nextId() == after.nextId();
        for (int k = 0; same && k < before.size(); k++) {
            before.setMass(k, after.mass[k]);
            before.setVelocity(k, flown(after.x[k] - before.x[k], after.vx[k]),
                flown(after.y[k] - before.y[k], after.vy[k]));
        }
        TurnLog log = game.log();
        for (int k = log.kept() - 1; same && k >= 0; k--) {
            Impact impact = log.impact(k);
            before.setVelocity(before.indexOf(impact.a()), impact.vaxBefore(), impact.vayBefore());
            if (!impact.isWall()) {
                before.setVelocity(before.indexOf(impact.b()), impact.vbxBefore(), impact.vbyBefore());
            }
        }
        return before;
    }

    private double flown(double way, double velocityAfter) {
        boolean rests = way == 0 && velocityAfter == 0;
        return rests || !setup.scene().roundPosition() ? way : way + random.nextDouble() - 0.5;
    }
}

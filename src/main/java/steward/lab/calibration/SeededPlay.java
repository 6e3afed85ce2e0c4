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
 * A game shows its bodies between turns, with what the end of the last turn has done to them; the flight of a turn
 * begins from other velocities, which the commands have made. They are found again after the turn: of a body that was
 * hit, as it stood before its first impact; of any other, it is the way that it has flown. Where the game has rounded
 * the place where that ended, the velocity is known to half a unit, and the rest of it is drawn by lot.
 */

/**
 * States that a scene really comes to: games from seeds, one after the other, whose players answer by a script. Each
 * turn gives the bodies as they stood when its flight began; but where the game rounds positions, the velocities of
 * bodies that nothing touched are good to half a unit only. Deterministic.
 */
public final class SeededPlay {

    /** What the players answer, as the line they would send. */
    @FunctionalInterface
    public interface Script {

        /**
         * @param game   as it stands
         * @param player who is to answer
         * @param random the play's own, to be used by all players in turn
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
     * Plays a turn, of a new game when the last is over.
     *
     * @return the bodies when its flight began, not shared with anybody
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

    /** The places of before with the masses and velocities of the turn; as they are, if bodies came or went. */
    private Bodies begun(Bodies before, Bodies after) {
        boolean same = before.size() == after.size() && before.nextId() == after.nextId();
        for (int k = 0; same && k < before.size(); k++) {
            before.setMass(k, after.mass[k]);
            before.setVelocity(k, flown(after.x[k] - before.x[k], after.vx[k]),
                flown(after.y[k] - before.y[k], after.vy[k]));
        }
        TurnLog log = game.log();
        for (int k = log.impacts() - 1; same && k >= 0; k--) {
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

package steward.lab.calibration;

import java.nio.charset.StandardCharsets;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.Motion;
import steward.physics.TurnLog;

/*
 * A game shows its bodies between turns, after the rounding of the last turn; the flight of a turn begins with other
 * velocities, which the commands have changed. They are reconstructed after the turn: for a body that was hit, as the
 * velocity before its first impact; for any other body, as the distance that it has flown. Where the game has rounded
 * the final position, the velocity is known to half a unit, and the rest of it is drawn at random.
 */

/**
 * Source of states that occur in play of a scene: seeded games, one after the other, whose players answer by rule. Each
 * turn gives the bodies as they were when its flight began. If the game rounds positions, the velocities of bodies
 * without an impact are accurate to half a unit only. Deterministic.
 */
public final class SeededPlay {

    private final GameSetup setup;
    private final Pilot pilot;
    private final SplitMix64 random;
    private long gameSeed;
    private Game game;
    private GameJson codec;

    /** @param seed of the first game; each further one has the next number. All players draw from it too */
    public SeededPlay(GameSetup setup, Pilot pilot, long seed) {
        this.setup = setup;
        this.pilot = pilot;
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
                byte[] answer = pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8);
                String problem = codec.readAnswer(player, answer, answer.length);
                if (problem != null) {
                    throw new IllegalArgumentException("seeded play of " + setup.scene().name() + ", player " + player
                        + ": " + problem);
                }
            }
        }
        Bodies before = game.bodies().copy();
        game.play();
        return begun(before, game.bodies());
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
        return rests || setup.motion().step(Motion.Of.POSITION) == null ? way : way + random.nextDouble() - 0.5;
    }
}

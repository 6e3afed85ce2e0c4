package steward.scene;

import java.util.Optional;
import steward.numerics.Angles;
import steward.physics.ImpactLaw;
import steward.scene.json.Block;

/**
 * What a scene file says, apart from the blocks of the game. Two scenes are equal when their files say the same in the
 * same words.
 *
 * @param name             its name
 * @param gameId           which game is played
 * @param players          how many, 1..16
 * @param field            the field with its walls and bumpers, if there is one
 * @param law              how impacts go; its restitution is elastic here, {@link Plan#physics} decides it
 * @param drag             the share of its speed that a body loses at the end of a turn, 0..1
 * @param truncateVelocity whether speeds are cut to whole numbers at the end of a turn
 * @param roundPosition    whether positions are rounded at the end of a turn
 * @param time             how long a player may take
 * @param choice           with how much care it is computed, and why so
 * @param angles           where sines and cosines come from: no matter of the file, but of who plays or plays again
 * @param observer         sees the ways to advance that games of this scene take from their plan
 * @param root             the whole file, for the game to read its own blocks from and then to call
 *                         {@link Block#done()} on
 */
public record Scene(String name, String gameId, int players, Optional<Field> field, ImpactLaw law, double drag,
                    boolean truncateVelocity, boolean roundPosition, Time time, AccuracyChoice choice,
                    Angles angles, PhysicsObserver observer, Block root) {

    /** With how much care it is computed. */
    public Accuracy accuracy() {
        return choice.rung();
    }

    /** The same scene, its games watched: for measuring turns from within. */
    public Scene withObserver(PhysicsObserver other) {
        return new Scene(name, gameId, players, field, law, drag, truncateVelocity, roundPosition, time, choice,
            angles, other, root);
    }

    /** The same scene with other sines and cosines: for playing again what was played with them. */
    public Scene withAngles(Angles other) {
        return new Scene(name, gameId, players, field, law, drag, truncateVelocity, roundPosition, time, choice, other,
            observer, root);
    }

    /**
     * The whole file on one line, fields in the same order and numbers in the same words; characters beyond ASCII are
     * escaped. Reading it gives an equal scene.
     */
    public String json() {
        return root.json();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Scene scene && json().equals(scene.json());
    }

    @Override
    public int hashCode() {
        return json().hashCode();
    }

    @Override
    public String toString() {
        return json();
    }
}

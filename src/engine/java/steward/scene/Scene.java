package steward.scene;

import java.util.Optional;
import steward.Internal;
import steward.physics.ImpactLaw;
import steward.physics.Motion;
import steward.scene.json.Block;

/**
 * Contents of a scene file without the game's own blocks. Two scenes are equal if their {@link #json()} is.
 *
 * @param players  number of players, 1..16
 * @param field    the field with its walls and bumpers, if there is one
 * @param law      the law of impact; its restitution is elastic here and is decided by {@link Plan#physics}
 * @param drag     the share of its speed that a body loses at the end of a turn, 0..1
 * @param motion   what happens to speeds and positions at the end of a turn, in which order
 * @param time     time limits of the players
 * @param choice   the rung it is computed on, and how it was chosen
 * @param observer observes the advances that games of this scene take from their plan
 * @param root     the whole file, from which the game reads its own blocks; the game calls {@link Block#done()}
 *                 at the end
 */
public record Scene(String name, String gameId, int players, Optional<Field> field, ImpactLaw law, double drag,
                    Motion motion, Time time, AccuracyChoice choice, @Internal PhysicsObserver observer, Block root) {

    /** Made by {@link SceneReader}. */
    @Internal
    public Scene {
    }

    /** The rung that it is computed on. */
    public Accuracy accuracy() {
        return choice.rung();
    }

    /** Returns this scene with another observer, for measurements inside turns. */
    @Internal
    public Scene withObserver(PhysicsObserver other) {
        return new Scene(name, gameId, players, field, law, drag, motion, time, choice, other, root);
    }

    /**
     * The whole file on one line, with the order of fields and the text of numbers kept; characters beyond ASCII are
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

package steward.minigame;

import steward.physics.Arena;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * The block {@code pond} of a scene, and its arena.
 *
 * @param bubbles      how many bubbles, 0..100
 * @param cells        how many cells, 0..100
 * @param cellMass     the mass of a whole cell
 * @param fogs         how many fogs, 0..100
 * @param push         the most a hunter can change its speed in a turn, in u per turn
 * @param maximumTurns then the game ends
 * @param arena        the scene's only wall
 */
record PondSettings(int bubbles, int cells, double cellMass, int fogs, double push, int maximumTurns, Arena arena) {

    /** Reads the block {@code pond} and checks the field. */
    static PondSettings read(Scene scene) {
        Arena arena = scene.field().stream().flatMap(field -> field.walls().stream())
            .filter(Arena.class::isInstance).map(Arena.class::cast).findFirst()
            .orElseThrow(() -> scene.root().error("field", "no arena", "an arena among the walls"));
        Block pond = scene.root().block("pond");
        return new PondSettings(pond.integer("bubbles", 0, 100), pond.integer("cells", 0, 100),
            pond.number("cellMass", 1, 1000), pond.integer("fogs", 0, 100), pond.positive("push"),
            pond.integer("maximumTurns", 1, 10_000), arena);
    }
}

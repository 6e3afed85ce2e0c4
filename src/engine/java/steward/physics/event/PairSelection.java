package steward.physics.event;

import steward.physics.Bodies;
import steward.physics.Contacts;

/**
 * Selects who can react where not all can: kinds that ignore each other, passing pairs and two infinite masses cannot.
 *
 * @param contacts what contacts mean in the scene
 */
public record PairSelection(Contacts contacts) {

    public boolean canReact(Bodies bodies, int i, int j) {
        return switch (contacts.between(bodies.kind[i], bodies.kind[j])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] + bodies.inverseMass[j] > 0;
            case ASK -> bodies.passing().isEmpty() || !bodies.passing().contains(bodies.id(i), bodies.id(j));
        };
    }

    public boolean canReactWithWalls(Bodies bodies, int i) {
        return switch (contacts.withWall(bodies.kind[i])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] > 0;
            case ASK -> true;
        };
    }

    /** True if a body that can react with walls does not pass through this one. */
    public boolean canReactWithWall(Bodies bodies, int i, int w) {
        return bodies.passing().isEmpty() || !bodies.passing().contains(bodies.id(i), ~w);
    }
}

package steward.physics.queue;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.PhysicsParts;

/**
 * Selects the pairs that can react where not all can: kinds that ignore each other, passing pairs and two infinite
 * masses cannot.
 */
final class QueuePairs {

    private final Crowd crowd;
    private final Contacts contacts;
    private Bodies bodies;

    private QueuePairs(Crowd crowd, Contacts contacts) {
        this.crowd = crowd;
        this.contacts = contacts;
    }

    /** @return {@code null} if all pairs can react */
    static QueuePairs of(Crowd crowd, PhysicsParts parts) {
        boolean all = parts.contacts().allBounce() && !parts.infiniteMasses();
        return all ? null : new QueuePairs(crowd, parts.contacts());
    }

    /** Begins a turn with these bodies. */
    void begin(Bodies ofTurn) {
        bodies = ofTurn;
    }

    boolean canReact(int a, int b) {
        int i = crowd.index[a];
        int j = crowd.index[b];
        return switch (contacts.between(bodies.kind[i], bodies.kind[j])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] + bodies.inverseMass[j] > 0;
            case ASK -> !bodies.passing().contains(bodies.id(i), bodies.id(j));
        };
    }

    /** Whether a body can react with any wall. */
    boolean canReactWithWalls(int body) {
        int i = crowd.index[body];
        return switch (contacts.withWall(bodies.kind[i])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] > 0;
            case ASK -> true;
        };
    }

    /** Whether a body that can react with walls does not pass through this one. */
    boolean canReactWithWall(int body, int wall) {
        return !bodies.passing().contains(bodies.id(crowd.index[body]), ~wall);
    }
}

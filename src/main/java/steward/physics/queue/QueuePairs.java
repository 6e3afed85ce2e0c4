package steward.physics.queue;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.PhysicsParts;

/** Which pairs meet where not all do: kinds that ignore each other, pairs that pass, two infinite masses. */
final class QueuePairs {

    private final Crowd crowd;
    private final Contacts contacts;
    private Bodies bodies;

    private QueuePairs(Crowd crowd, Contacts contacts) {
        this.crowd = crowd;
        this.contacts = contacts;
    }

    /** @return {@code null} if all pairs meet */
    static QueuePairs of(Crowd crowd, PhysicsParts parts) {
        boolean all = parts.contacts().allBounce() && !parts.infiniteMasses();
        return all ? null : new QueuePairs(crowd, parts.contacts());
    }

    /** A turn with these bodies. */
    void begin(Bodies ofTurn) {
        bodies = ofTurn;
    }

    boolean meet(int a, int b) {
        int i = crowd.index[a];
        int j = crowd.index[b];
        return switch (contacts.between(bodies.kind[i], bodies.kind[j])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] + bodies.inverseMass[j] > 0;
            case ASK -> !bodies.passing().contains(bodies.id(i), bodies.id(j));
        };
    }

    /** Whether a body meets any walls. */
    boolean meetsWalls(int body) {
        int i = crowd.index[body];
        return switch (contacts.withWall(bodies.kind[i])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] > 0;
            case ASK -> true;
        };
    }

    /** Whether a body that meets walls meets this one. */
    boolean meetsWall(int body, int wall) {
        return !bodies.passing().contains(bodies.id(crowd.index[body]), ~wall);
    }
}

package steward.physics.queue;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.PhysicsParts;
import steward.physics.event.PairSelection;

/**
 * Selects the pairs that can react where not all can: kinds that ignore each other, passing pairs and two infinite
 * masses cannot.
 */
final class QueuePairs {

    private final Crowd crowd;
    private final PairSelection selection;
    private Bodies bodies;

    private QueuePairs(Crowd crowd, Contacts contacts) {
        this.crowd = crowd;
        selection = new PairSelection(contacts);
    }

    /** @return {@code null} if all pairs can react */
    static QueuePairs of(Crowd crowd, PhysicsParts parts) {
        boolean all = parts.contacts().allBounce() && !parts.infiniteMasses();
        return all ? null : new QueuePairs(crowd, parts.contacts());
    }

    void begin(Bodies ofTurn) {
        bodies = ofTurn;
    }

    boolean canReact(int a, int b) {
        return selection.canReact(bodies, crowd.index[a], crowd.index[b]);
    }

    boolean canReactWithWalls(int body) {
        return selection.canReactWithWalls(bodies, crowd.index[body]);
    }

    /** True if a body that can react with walls does not pass through this one. */
    boolean canReactWithWall(int body, int wall) {
        return selection.canReactWithWall(bodies, crowd.index[body], wall);
    }
}

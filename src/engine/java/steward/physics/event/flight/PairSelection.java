package steward.physics.event.flight;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.PhysicsParts;

/**
 * Selection of pairs that can react: not kinds that ignore each other, passing pairs, or two infinite masses.
 *
 * @param contacts what contacts mean in the scene
 */
public record PairSelection(Contacts contacts) {

    /** @return {@code null} if all can react, and all pairs touch at the sum of their radii */
    public static PairSelection of(PhysicsParts parts) {
        return parts.contacts().allBounce() && !parts.infiniteMasses() ? null : new PairSelection(parts.contacts());
    }

    public boolean canReact(Bodies bodies, int i, int j) {
        return switch (contacts.between(bodies.kind[i], bodies.kind[j])) {
            case NONE -> false;
            case BOUNCE -> bodies.inverseMass[i] + bodies.inverseMass[j] > 0;
            case ASK -> bodies.passing().isEmpty() || !bodies.passing().contains(bodies.id(i), bodies.id(j));
        };
    }

    /**
     * The radius of i in its contacts with j: half of their distance where they have one of their own.
     *
     * @param selection {@code null} if all can react
     */
    public static double radius(PairSelection selection, Bodies bodies, int i, int j) {
        if (selection == null) {
            return bodies.radius[i];
        }
        double reach = selection.contacts.reach(bodies.kind[i], bodies.kind[j]);
        return reach > 0 ? reach / 2 : bodies.radius[i];
    }

    /** The largest of these radii, and its own. */
    public double widestRadius(Bodies bodies, int i) {
        double widest = bodies.radius[i];
        for (int kind = 0; contacts.hasReaches() && kind < contacts.kinds(); kind++) {
            double reach = contacts.reach(bodies.kind[i], kind);
            widest = reach > 2 * widest ? reach / 2 : widest;
        }
        return widest;
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

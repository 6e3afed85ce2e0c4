package steward.physics.time;

import steward.physics.Bodies;
import steward.physics.Contacts;

/**
 * Support for contacts at a distance other than the sum of the radii ({@link Contacts#askWithin}). While a pair is
 * looked at, each of the two has half of the distance as its radius, so that every arithmetic and every search can be
 * used unchanged. Made only for scenes that have such contacts.
 */
public final class ContactDistance {

    private final Contacts contacts;
    private double radiusI;
    private double radiusJ;

    public ContactDistance(Contacts contacts) {
        this.contacts = contacts;
    }

    /** Gives the two the radii of their contact. @return whether it has a distance of its own; then {@link #leave} */
    public boolean enter(Bodies bodies, int i, int j) {
        double reach = contacts.reach(bodies.kind[i], bodies.kind[j]);
        if (Double.isNaN(reach)) {
            return false;
        }
        radiusI = bodies.radius[i];
        radiusJ = bodies.radius[j];
        bodies.radius[i] = reach / 2;
        bodies.radius[j] = reach / 2;
        return true;
    }

    /** Gives the two their own radii back. */
    public void leave(Bodies bodies, int i, int j) {
        bodies.radius[i] = radiusI;
        bodies.radius[j] = radiusJ;
    }
}

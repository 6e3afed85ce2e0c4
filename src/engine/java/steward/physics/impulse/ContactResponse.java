package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.PassingPairs;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.physics.Wall;

/** Response to a contact: an impact, or the answer of the scene's {@link Reaction}. */
public abstract sealed class ContactResponse {

    /** Responds to a contact. @return false if the bodies were altered, so that all predictions are out of date */
    public abstract boolean react(Bodies bodies, int a, int b, double time, TurnSink sink);

    /** True if the response to a contact needs all bodies where they are now, and not only the two. */
    public boolean needsAll(Bodies bodies, int a, int b) {
        return false;
    }

    /**
     * Ends the passing of pairs that have separated, and responds to a contact.
     *
     * @return whether nothing but the two has changed, so that all other predictions hold
     */
    public boolean reactAlone(Bodies bodies, int a, int b, double time, TurnSink sink) {
        return react(bodies, a, b, time, sink);
    }

    /** Called after each free flight: ends the passing of pairs that have separated. */
    public abstract void releaseSeparatedPairs(Bodies bodies);

    public static ContactResponse of(PhysicsParts parts, Collision collision, Wall[] walls) {
        return parts.reaction() == null ? new Bounce(collision) : new Ask(collision, parts, walls);
    }

    /** Every contact is an impact. */
    static final class Bounce extends ContactResponse {

        private final Collision collision;

        Bounce(Collision collision) {
            this.collision = collision;
        }

        @Override
        public boolean react(Bodies bodies, int a, int b, double time, TurnSink sink) {
            collision.react(bodies, a, b, time, sink);
            return true;
        }

        @Override
        public void releaseSeparatedPairs(Bodies bodies) { }
    }

    /** {@code ASK} contacts are decided by the reaction. */
    static final class Ask extends ContactResponse {

        private final Collision collision;
        private final Contacts contacts;
        private final Reaction reaction;
        private final Wall[] walls;
        private boolean alteredOthers;

        Ask(Collision collision, PhysicsParts parts, Wall[] walls) {
            this.collision = collision;
            this.contacts = parts.contacts();
            this.reaction = parts.reaction();
            this.walls = walls;
        }

        private Contacts.Meaning meaning(Bodies bodies, int a, int b) {
            return b < 0 ? contacts.withWall(bodies.kind[a]) : contacts.between(bodies.kind[a], bodies.kind[b]);
        }

        @Override
        public boolean needsAll(Bodies bodies, int a, int b) {
            return meaning(bodies, a, b) == Contacts.Meaning.ASK || !bodies.passing().isEmpty();
        }

        @Override
        public boolean reactAlone(Bodies bodies, int a, int b, double time, TurnSink sink) {
            int passing = bodies.passing().size();
            releaseSeparatedPairs(bodies);
            boolean alone = bodies.passing().size() == passing;
            return react(bodies, a, b, time, sink) && !alteredOthers && alone;
        }

        @Override
        public boolean react(Bodies bodies, int a, int b, double time, TurnSink sink) {
            alteredOthers = false;
            if (meaning(bodies, a, b) == Contacts.Meaning.BOUNCE) {
                collision.react(bodies, a, b, time, sink);
                return true;
            }
            int idA = bodies.id(a);
            int idB = b < 0 ? b : bodies.id(b);
            sink.knot(idA, time, bodies.x[a], bodies.y[a]);
            if (b >= 0) {
                sink.knot(idB, time, bodies.x[b], bodies.y[b]);
            }
            int size = bodies.size();
            switch (reaction.on(time, a, b, bodies, sink)) {
                case BOUNCE -> {
                    if (bodies.inverseMass[a] + (b < 0 ? 0 : bodies.inverseMass[b]) > 0) {
                        bounce(bodies, a, b, time, sink);
                        alteredOthers = reaction.after(time, a, b, bodies, sink);
                    } else {
                        bodies.passing().add(idA, idB);         // two infinite masses exchange no impulse
                    }
                    return true;
                }
                case ALTERED -> {
                    alteredOthers = true;
                    return bodies.size() == size;
                }
                case PASS -> {
                    bodies.passing().add(idA, idB);
                    return true;
                }
                default -> {
                    return false;
                }
            }
        }

        /** An impact; at a distance of its own, the two have half of it as their radii. */
        private void bounce(Bodies bodies, int a, int b, double time, TurnSink sink) {
            double reach = b < 0 ? Double.NaN : contacts.reach(bodies.kind[a], bodies.kind[b]);
            if (Double.isNaN(reach)) {
                collision.react(bodies, a, b, time, sink);
                return;
            }
            double radiusA = bodies.radius[a];
            double radiusB = bodies.radius[b];
            bodies.radius[a] = reach / 2;
            bodies.radius[b] = reach / 2;
            collision.react(bodies, a, b, time, sink);
            bodies.radius[a] = radiusA;
            bodies.radius[b] = radiusB;
        }

        /** Pairs that have separated, or of which a body was removed, no longer pass through each other. */
        @Override
        public void releaseSeparatedPairs(Bodies bodies) {
            PassingPairs passing = bodies.passing();
            for (int k = passing.size() - 1; k >= 0; k--) {
                int a = bodies.indexOf(passing.first(k));
                int second = passing.second(k);
                boolean apart = second < 0
                    ? a < 0 || walls[~second].gap(bodies.x[a], bodies.y[a], bodies.radius[a]) > 0
                        && !approachesWall(bodies, a, walls[~second])
                    : areSeparatedOrRemoved(bodies, a, bodies.indexOf(second));
                if (apart) {
                    passing.remove(k);
                }
            }
        }

        private static boolean approachesWall(Bodies bodies, int a, Wall wall) {
            double x = bodies.x[a];
            double y = bodies.y[a];
            return wall.normalX(x, y) * bodies.vx[a] + wall.normalY(x, y) * bodies.vy[a] > 0;
        }

        private boolean areSeparatedOrRemoved(Bodies bodies, int a, int b) {
            if (a < 0 || b < 0) {
                return true;
            }
            double dx = bodies.x[b] - bodies.x[a];
            double dy = bodies.y[b] - bodies.y[a];
            double approach = dx * (bodies.vx[b] - bodies.vx[a]) + dy * (bodies.vy[b] - bodies.vy[a]);
            double reach = contacts.reach(bodies.kind[a], bodies.kind[b]);
            return approach >= 0 && Math.sqrt(dx * dx + dy * dy)
                > (Double.isNaN(reach) ? bodies.radius[a] + bodies.radius[b] : reach);
        }
    }
}

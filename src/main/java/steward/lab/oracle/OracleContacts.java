package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.PassingPairs;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/**
 * What contacts mean to the {@link Oracle}: which kinds meet, and what the game's reaction answers. The reaction is
 * asked about rounded copies of the bodies; those that it does not alter keep all their digits.
 *
 * <p>Caveats: bodies that pass each other do so until they are apart as doubles; walls let none pass; contacts with a
 * distance of their own are refused.
 */
final class OracleContacts {

    private final Contacts contacts;
    private final Reaction reaction;
    private final Bodies rounded;
    private final List<Integer> startIds = new ArrayList<>();

    /** @throws IllegalArgumentException if a contact has a distance of its own */
    OracleContacts(PhysicsParts parts, Bodies start) {
        contacts = parts.contacts();
        reaction = parts.reaction();
        if (contacts.hasReaches()) {
            throw new IllegalArgumentException("the oracle knows no contacts at a distance of their own");
        }
        rounded = start.copy();
        for (int k = 0; k < start.size(); k++) {
            startIds.add(start.id(k));
        }
    }

    /** Whether two bodies can have an impact. */
    boolean meet(int a, int b) {
        return contacts.between(rounded.kind[a], rounded.kind[b]) != Meaning.NONE
            && (rounded.passing().isEmpty() || !rounded.passing().contains(rounded.id(a), rounded.id(b)));
    }

    /** Lets the pairs meet again that have passed each other: they are apart, and do not come nearer. */
    void release(List<OracleBody> bodies) {
        PassingPairs pairs = rounded.passing();
        for (int k = pairs.size() - 1; k >= 0; k--) {
            int a = rounded.indexOf(pairs.first(k));
            int b = pairs.second(k) < 0 ? -1 : rounded.indexOf(pairs.second(k));
            if (a < 0 || b < 0 || isApart(bodies.get(a), bodies.get(b))) {
                pairs.remove(k);
            }
        }
    }

    private static boolean isApart(OracleBody p, OracleBody q) {
        double dx = p.x.subtract(q.x).doubleValue();
        double dy = p.y.subtract(q.y).doubleValue();
        double touch = p.radius.add(q.radius).doubleValue();
        double approach = dx * p.vx.subtract(q.vx).doubleValue() + dy * p.vy.subtract(q.vy).doubleValue();
        return dx * dx + dy * dy > touch * touch && approach >= 0;
    }

    /** Whether a body can have an impact with a wall. */
    boolean meetsWalls(int a) {
        return contacts.withWall(rounded.kind[a]) != Meaning.NONE;
    }

    /** The ids of the bodies as they now are. */
    int id(int body) {
        return rounded.id(body);
    }

    /** The index of a body at the start of the turn; -1 if it came later. */
    int startIndex(int body) {
        return startIds.indexOf(rounded.id(body));
    }

    /**
     * Asks the reaction, if the contact asks.
     *
     * @return whether an impact follows; otherwise the bodies may have been altered
     * @throws IllegalArgumentException if the answer at a wall is {@code PASS}
     */
    boolean bounces(List<OracleBody> bodies, int a, int b, BigDecimal time) {
        if (meaning(a, b) == Meaning.BOUNCE) {
            return true;
        }
        round(bodies);
        Bodies before = rounded.copy();
        switch (reaction.on(time.doubleValue(), a, b, rounded, TurnSink.NONE)) {
            case BOUNCE -> {
                return true;
            }
            case PASS -> {
                if (b < 0) {
                    throw new IllegalArgumentException("the oracle lets no body pass a wall");
                }
                rounded.passing().add(rounded.id(a), rounded.id(b));
                return false;
            }
            default -> {
                take(bodies, before);
                return false;
            }
        }
    }

    private Meaning meaning(int a, int b) {
        return b < 0 ? contacts.withWall(rounded.kind[a]) : contacts.between(rounded.kind[a], rounded.kind[b]);
    }

    /** Tells the reaction that an impact has happened, if the contact asks. */
    void after(List<OracleBody> bodies, int a, int b, BigDecimal time) {
        if (reaction != null && meaning(a, b) == Meaning.ASK) {
            round(bodies);
            Bodies before = rounded.copy();
            reaction.after(time.doubleValue(), a, b, rounded, TurnSink.NONE);
            take(bodies, before);
        }
    }

    private void round(List<OracleBody> bodies) {
        for (int k = 0; k < bodies.size(); k++) {
            OracleBody body = bodies.get(k);
            rounded.x[k] = body.x.doubleValue();
            rounded.y[k] = body.y.doubleValue();
            rounded.vx[k] = body.vx.doubleValue();
            rounded.vy[k] = body.vy.doubleValue();
        }
    }

    /** Takes over what the reaction has altered, removed and added. */
    private void take(List<OracleBody> bodies, Bodies before) {
        List<OracleBody> old = List.copyOf(bodies);
        List<OracleBody> anew = OracleBody.of(rounded);
        bodies.clear();
        for (int k = 0; k < rounded.size(); k++) {
            int was = before.indexOf(rounded.id(k));
            bodies.add(was >= 0 && isSame(before, was, k) ? old.get(was) : anew.get(k));
        }
    }

    private boolean isSame(Bodies before, int was, int k) {
        return before.x[was] == rounded.x[k] && before.y[was] == rounded.y[k] && before.vx[was] == rounded.vx[k]
            && before.vy[was] == rounded.vy[k] && before.mass[was] == rounded.mass[k]
            && before.radius[was] == rounded.radius[k];
    }
}

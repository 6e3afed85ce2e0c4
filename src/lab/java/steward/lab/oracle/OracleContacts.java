package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.PassingPairs;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * Rules of contacts for the {@link Oracle}: which kinds meet, and how the game's reaction answers. The reaction is
 * asked about rounded copies of the bodies; bodies that it does not alter keep all their digits.
 *
 * <p>Caveat: a contact at a distance of its own may be answered by anything but {@code BOUNCE}.
 */
final class OracleContacts {

    private final Contacts contacts;
    private final Reaction reaction;
    private final Bodies rounded;
    private final List<Integer> startIds = new ArrayList<>();

    OracleContacts(PhysicsParts parts, Bodies start) {
        contacts = parts.contacts();
        reaction = parts.reaction();
        rounded = start.copy();
        IntStream.range(0, start.size()).map(start::id).forEach(startIds::add);
    }

    boolean meet(int a, int b) {
        return contacts.between(rounded.kind[a], rounded.kind[b]) != Meaning.NONE && !passes(id(a), id(b));
    }

    boolean meetsWall(int a, int wall) {
        return contacts.withWall(rounded.kind[a]) != Meaning.NONE && !passes(id(a), ~wall);
    }

    /** True if two, or a body and {@code ~wall}, bounce without being asked, and nothing passes through anything. */
    boolean alwaysBounce(int a, int b) {
        return rounded.passing().isEmpty() && Meaning.BOUNCE == (b < 0 ? contacts.withWall(rounded.kind[a])
            : contacts.between(rounded.kind[a], rounded.kind[b]));
    }

    private boolean passes(int a, int b) {
        return !rounded.passing().isEmpty() && rounded.passing().contains(a, b);
    }

    /** The distance of the centres at which two bodies touch, if it is not the sum of their radii; otherwise NaN. */
    double reach(int a, int b) {
        return contacts.reach(rounded.kind[a], rounded.kind[b]);
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
     * @throws IllegalArgumentException if the answer is {@code BOUNCE} at a distance of their own
     */
    boolean bounces(List<OracleBody> bodies, int a, int b, BigDecimal time) {
        Meaning meaning = b < 0 ? contacts.withWall(rounded.kind[a])
            : contacts.between(rounded.kind[a], rounded.kind[b]);
        if (meaning == Meaning.BOUNCE) {
            return true;
        }
        round(bodies);
        Bodies before = rounded.copy();
        switch (reaction.on(time.doubleValue(), a, b, rounded, TurnSink.NONE)) {
            case BOUNCE -> {
                if (b >= 0 && !Double.isNaN(reach(a, b))) {
                    throw new IllegalArgumentException("the oracle knows no impacts at a distance of their own");
                }
                return true;
            }
            case PASS -> {
                rounded.passing().add(id(a), b < 0 ? b : id(b));
                return false;
            }
            default -> {
                take(bodies, before);
                return false;
            }
        }
    }

    /** Tells the reaction that an impact has happened, if the contact asks. */
    void after(List<OracleBody> bodies, int a, int b, BigDecimal time) {
        Meaning meaning = b < 0 ? contacts.withWall(rounded.kind[a])
            : contacts.between(rounded.kind[a], rounded.kind[b]);
        if (reaction != null && meaning == Meaning.ASK) {
            round(bodies);
            Bodies before = rounded.copy();
            reaction.after(time.doubleValue(), a, b, rounded, TurnSink.NONE);
            take(bodies, before);
        }
    }

    /** After a flight: pairs that have separated no longer pass through each other. */
    void releaseSeparatedPairs(List<OracleBody> bodies, List<Wall> walls) {
        PassingPairs passing = rounded.passing();
        if (passing.isEmpty()) {
            return;
        }
        round(bodies);
        for (int k = passing.size() - 1; k >= 0; k--) {
            int a = rounded.indexOf(passing.first(k));
            int b = passing.second(k) < 0 ? passing.second(k) : rounded.indexOf(passing.second(k));
            boolean gone = a < 0 || passing.second(k) >= 0 && b < 0;
            if (gone || (b < 0 ? isApart(a, walls.get(~b)) : areApart(a, b))) {
                passing.remove(k);
            }
        }
    }

    private boolean isApart(int a, Wall wall) {
        double x = rounded.x[a];
        double y = rounded.y[a];
        double approach = wall.normalX(x, y) * rounded.vx[a] + wall.normalY(x, y) * rounded.vy[a];
        return approach <= 0 && wall.gap(x, y, rounded.radius[a]) > 0;
    }

    private boolean areApart(int a, int b) {
        double dx = rounded.x[b] - rounded.x[a];
        double dy = rounded.y[b] - rounded.y[a];
        double touch = Double.isNaN(reach(a, b)) ? rounded.radius[a] + rounded.radius[b] : reach(a, b);
        return dx * (rounded.vx[b] - rounded.vx[a]) + dy * (rounded.vy[b] - rounded.vy[a]) >= 0
            && Math.sqrt(dx * dx + dy * dy) > touch;
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
